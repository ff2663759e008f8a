//! Digits of D and t that are lost with distance: a star goes away. A ray of it is chosen by
//! its pixel.

use common::rtweekend::*;
use glam::DVec2;
use speed_vs_accuracy::{Case, Eye, Lens, Method, Scene};

use crate::cancellation::Numbers;
use crate::figure::Figure;
use crate::live::{Action, Answer, Handle, Live, Number, parameters};
use crate::number::{printed, raised};
use crate::pixels::Frame;
use crate::svg::{Anchor, Svg};

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
    name: "digits",
    title: "Digits vanish",
    description: "A star, a sphere seen through a lens that makes it as large as the picture, drawn \
        twice in large pixels. At the right it is a smooth ball. At the left, where half_b draws it, \
        the rim is uneven and some colors jump. Below is an axis of distances, from ten to the \
        power of 0 to ten to the power of 16 radii, with a mark at 7. Then come numbers for one \
        ray, digit below digit. The first thirteen digits of h squared and of a times c are the \
        same and struck out. So D begins with fourteen zeros, and of the three digits that are left \
        only the first is right. Of t the first nine digits are right, and the other eight are not.",
    caption: "In the subtraction the digits in which *h*² and *ac* agree cancel. *D* has only the digits that are \
        left, and earlier rounding has made some of them wrong: right digits are bold, wrong ones are underlined.",
    draw: || LIVE.on_page(),
};

parameters! {
    exponent: Number {
        steps: 10.0,
        ..Number::new("Distance in radii, as a power of ten", 0.0, 16.0, 7.0)
    },
    right: Number::whole("Pixel, to the right of the middle", -7.0, 7.0, -3.0),
    up: Number::whole("Pixel, above the middle", -7.0, 7.0, 2.0),
    radius: Number::choice("Radius", &["6/7", "1/700", "5000/7"]),
}

/// The choices of a radius: not such that squares are round numbers, of which *ac* is a
/// little less and has no digit in common.
const RADII: [f64; 3] = [6.0 / 7.0, 1.0 / 700.0, 5000.0 / 7.0];

/// The figure, as a reader moves it.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: FIGURE,
    question: "From which distance on is *D* only rounding error? Drag the star away, along the axis, \
        and choose a pixel in either picture.",
    solution: "From about 10⁸ radii on: then the square of the distance has no digit left for the square of \
        the radius.",
    handles: &[
        Handle::new(&["exponent"], |it, to| it.exponent = exponent_at(to)),
        Handle::new(&["right", "up"], |it, to| {
            [it.right, it.up] = SKIES[0].pixel_at(to).to_array();
        }),
        Handle::new(&["right", "up"], |it, to| {
            [it.right, it.up] = SKIES[1].pixel_at(to).to_array();
        }),
    ],
    actions: &[
        Action::new("Ten radii away", |it| it.exponent = 1.0),
        Action::new("A million", |it| it.exponent = 6.0),
        Action::new("The telescope's star", |it| it.exponent = 8.0),
    ],
    answer,
};

impl Parameters {
    fn star(&self) -> Star {
        Star {
            tenths: (10.0 * self.exponent).round() as u8,
            pixel: DVec2::new(self.right, self.up),
            radius: RADII[self.radius as usize],
        }
    }
}

/// A star, and the ray of a pixel.
struct Star {
    /// From the eye to the center it is ten to the power of so many tenths, in radii.
    tenths: u8,
    /// Its radius.
    radius: f64,
    /// The pixel of whose ray there are numbers, counted from the middle to the right and
    /// upwards.
    pixel: DVec2,
}

fn answer(parameters: &Parameters) -> Answer {
    let star = parameters.star();
    let case = star.case();
    let found = Numbers::of(&case);
    let away = star.away_in_words();
    let agreeing = found.agreeing();
    Answer {
        drawing: draw(&star, &found),
        sentence: format!(
            "{away} radii away *h*² and *ac* agree in {agreeing} of their 17 digits. {} {}{}",
            of_discriminant(&found),
            of_t(&found, case.ray.direction.length() / case.radius),
            of_step(star.step()),
        ),
        handles: vec![
            on_axis(0.1 * f64::from(star.tenths)),
            SKIES[0].on_sheet(star.pixel),
            SKIES[1].on_sheet(star.pixel),
        ],
        says: vec![("distance", away), ("agree", digits(agreeing))],
    }
}

fn digits(count: usize) -> String {
    match count {
        1 => "1 digit".to_owned(),
        _ => format!("{count} digits"),
    }
}

/// What is left of D.
fn of_discriminant(found: &Numbers) -> String {
    match found.error() {
        0.0 => "*D* has lost no digit.".to_owned(),
        ..0.001 => "*D* is off by less than a thousandth of itself.".to_owned(),
        error @ ..0.5 => format!("*D* is off by {} % of itself.", printed(100.0 * error)),
        _ => format!(
            "*D* is only rounding error: it should be {}, and is computed as {}.",
            printed(found.exact_discriminant),
            printed(found.discriminant)
        ),
    }
}

/// What is left of t, of which 1 is so many `radii` long.
fn of_t(found: &Numbers, radii: f64) -> String {
    match (found.t, found.exact_t, found.right_digits()) {
        (Some(t), Some(exact), _) if t == exact => {
            "No digit of *t* is wrong: exact arithmetic gives the same number.".to_owned()
        }
        (Some(t), Some(exact), Some(right @ 2..)) => {
            let off = radii * (t - exact).abs();
            format!(
                "The first {right} digits of *t* are right, and it is off by {} radii.",
                printed(off)
            )
        }
        (Some(_), Some(_), Some(1)) => "Only the first digit of *t* is right.".to_owned(),
        (Some(_), Some(_), _) => "Not even the first digit of *t* is right.".to_owned(),
        (Some(_), None, _) => "The ray misses the star, and half_b sees a hit.".to_owned(),
        (None, Some(_), _) => "The ray hits the star, and half_b sees a miss.".to_owned(),
        (None, None, _) => "The ray misses the star, as half_b says.".to_owned(),
    }
}

/// What the right picture suffers from.
fn of_step(radii: f64) -> String {
    match radii {
        0.03.. => format!(
            " From one number *t* to the next the ray goes on by {} radii: so coarse is the right \
            picture, too.",
            printed(radii)
        ),
        _ => String::new(),
    }
}

/// Pixels in a row, and how many of them are as wide as the radius: the half keeps rays
/// off the rim.
const PIXELS: u32 = 15;
const PER_RADIUS: f64 = 5.5;

/// The rays of the book's camera are so many times closer together here, and the lens makes
/// up for it. Behind them is so little of the sky that it has few colors.
const CLOSER: f64 = 16.0;

/// Where the star is drawn, by each of the two.
const SKIES: [Sky; 2] = [
    Sky {
        name: "half_b",
        eye: Eye::Method(Method::HALF_B),
        corner: DVec2::new(4.0, 22.0),
    },
    Sky {
        name: "certified_t",
        eye: Eye::Method(Method::CERTIFIED_T),
        corner: DVec2::new(208.0, 22.0),
    },
];

/// A picture of the star.
struct Sky {
    name: &'static str,
    eye: Eye,
    corner: DVec2,
}

impl Sky {
    const SIDE: f64 = 12.5;

    /// Where on the sheet a pixel is, counted from the middle.
    fn on_sheet(&self, pixel: DVec2) -> DVec2 {
        self.middle() + Self::SIDE * DVec2::new(pixel.x, -pixel.y)
    }

    /// Which pixel is there on the sheet.
    fn pixel_at(&self, at: DVec2) -> DVec2 {
        let way = (at - self.middle()) / Self::SIDE;
        DVec2::new(way.x, -way.y)
    }

    fn middle(&self) -> DVec2 {
        self.corner + DVec2::splat(0.5 * Self::SIDE * f64::from(PIXELS))
    }
}

/// Where a power of ten is on the axis of distances.
fn on_axis(exponent: f64) -> DVec2 {
    DVec2::new(20.0 + 22.5 * exponent, 236.0)
}

/// Which power of ten is there on the sheet.
fn exponent_at(at: DVec2) -> f64 {
    (at.x - 20.0) / 22.5
}

impl Star {
    /// From the eye to the center, in radii.
    fn away(&self) -> f64 {
        // From a table, since not every machine computes the same powers.
        const TENTHS: [f64; 10] = [
            1.0,
            1.2589254117941673,
            1.5848931924611136,
            1.9952623149688795,
            2.51188643150958,
            3.1622776601683795,
            3.9810717055349722,
            5.011872336272722,
            6.309573444801933,
            7.943282347242816,
        ];
        TENTHS[usize::from(self.tenths % 10)] * ten_to(self.tenths / 10)
    }

    /// The same in a few characters.
    fn away_in_words(&self) -> String {
        let power = raised((self.tenths / 10).into());
        match (self.tenths / 10, self.tenths % 10) {
            (0, _) => format!("{:.1}", self.away()),
            (_, 0) => format!("10{power}"),
            (tens, _) => format!("{:.1} · 10{power}", self.away() / ten_to(tens)),
        }
    }

    /// The star, and the ray.
    fn case(&self) -> Case {
        let (center, radius) = self.sphere();
        let ray = self.scene().ray(&self.ray(self.pixel));
        Case {
            center,
            radius,
            ray,
        }
    }

    /// How far a ray goes from one `f64` t to the next where the star is, in radii.
    fn step(&self) -> f64 {
        let t = self.radius * self.away();
        (t.next_up() - t) / self.radius
    }

    fn scene(&self) -> Scene {
        Scene {
            name: FIGURE.name.to_owned(),
            width: PIXELS,
            sun: None,
            lens: Lens::new(Point3::ZERO, Vec3::NEG_Z, [self.away() / CLOSER; 2]),
            spheres: vec![self.sphere()],
        }
    }

    fn sphere(&self) -> (Point3, f64) {
        let in_radii = Point3::new(0.25, -0.5, -self.away());
        (self.radius * in_radii, self.radius)
    }

    /// The ray of the book's camera that the lens sends through that pixel.
    fn ray(&self, pixel: DVec2) -> Ray {
        let beside = pixel / PER_RADIUS;
        let through = Vec3::new(0.25 + beside.x, -0.5 + beside.y, -CLOSER);
        Ray::new(Point3::ZERO, through / CLOSER)
    }

    fn picture(&self, eye: Eye) -> Picture {
        let scene = self.scene();
        let middle = 0.5 * f64::from(PIXELS - 1);
        let mut rgb = vec![[0; 3]; (PIXELS * PIXELS) as usize];
        for (pixel, n) in rgb.iter_mut().zip(0..) {
            let [column, row] = [n % PIXELS, n / PIXELS].map(f64::from);
            let ray = self.ray(DVec2::new(column - middle, middle - row));
            write_color(pixel, scene.look(eye, &ray).color);
        }
        Picture::from_rgb(PIXELS, PIXELS, rgb.into_flattened()).expect("a color for each pixel")
    }
}

/// Draws the star twice, the axis, and the numbers of the chosen ray.
fn draw(star: &Star, numbers: &Numbers) -> Svg {
    let mut svg = FIGURE.sheet(400.0, 410.0);
    for sky in SKIES {
        let frame = Frame {
            corner: sky.corner,
            side: Sky::SIDE,
        };
        let above = DVec2::new(sky.middle().x, 14.0);
        svg.label("ink", above, Anchor::Middle, sky.name);
        frame.draw(&mut svg, &star.picture(sky.eye));
        let half = DVec2::splat(0.5 * Sky::SIDE);
        let chosen = sky.on_sheet(star.pixel);
        svg.rect("black line", chosen - half, 2.0 * half);
    }
    draw_axis(&mut svg, star.tenths);
    numbers.draw(&mut svg);
    svg
}

fn draw_axis(svg: &mut Svg, tenths: u8) {
    let [start, end] = [0.0, 16.0].map(on_axis);
    svg.line("ink line", start, end);
    for exponent in (0..=16).step_by(4) {
        let at = on_axis(exponent.into());
        svg.line("ink line", at, at + DVec2::new(0.0, 5.0));
        let below = at + DVec2::new(0.0, 19.0);
        let words = format!("10{}", raised(exponent));
        svg.small_label("faint", below, Anchor::Middle, &words);
    }
    let below = on_axis(8.0) + DVec2::new(0.0, 36.0);
    svg.small_label("ink", below, Anchor::Middle, "distance in radii");
    svg.circle("ray solid", on_axis(0.1 * f64::from(tenths)), 4.5);
}

fn ten_to(exponent: u8) -> f64 {
    (0..exponent).fold(1.0, |power, _| 10.0 * power)
}
