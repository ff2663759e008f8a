//! A star goes away, and takes the digits of D and t along.

use common::rtweekend::*;
use glam::DVec2;
use speed_vs_accuracy::{Case, Eye, Lens, Method, Scene};

use crate::cancellation::Numbers;
use crate::figure::Figure;
use crate::number::raised;
use crate::pixels::Frame;
use crate::svg::{Anchor, Svg};

/// The words of this figure.
pub const FIGURE: Figure = Figure {
    name: "digits",
    title: "Digits vanish",
    description: "A star, a sphere seen through a lens that makes it as large as the picture, drawn \
        twice in large pixels. At the right it is a smooth ball. At the left, where half_b draws it, \
        the rim is uneven and some colors jump. Below is an axis of distances, from ten to the \
        power of 0 to ten to the power of 16 radii, with a mark at 7. Then come numbers for one \
        ray, digit below digit. The first thirteen digits of h squared and of a times c are the \
        same and struck out. So D begins with fourteen zeros, and of the three digits that are left \
        only the first is right. Of t the first nine digits are right, and the other eight are not.",
    caption: "The subtraction strikes out the digits in which *h*² and *ac* agree. *D* has what is left, \
        and that is what earlier rounding has spoiled: right digits are bold, wrong ones are underlined.",
    draw: || draw(&Parameters::default()),
};

/// What can be changed.
#[derive(Clone, Copy, Debug)]
pub struct Parameters {
    /// From the eye to the center it is ten to the power of so many tenths, in radii.
    pub tenths: u8,
    /// The radius.
    pub radius: f64,
    /// The pixel of whose ray there are numbers, counted from the middle to the right and
    /// upwards.
    pub pixel: DVec2,
}

impl Default for Parameters {
    fn default() -> Self {
        Self {
            tenths: 70,
            radius: 6.0 / 7.0,
            pixel: DVec2::new(-3.0, 2.0),
        }
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
pub const SKIES: [Sky; 2] = [
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
#[derive(Clone, Copy, Debug)]
pub struct Sky {
    name: &'static str,
    eye: Eye,
    corner: DVec2,
}

impl Sky {
    const SIDE: f64 = 12.5;

    /// Where on the sheet a pixel is, counted from the middle.
    pub fn on_sheet(&self, pixel: DVec2) -> DVec2 {
        self.middle() + Self::SIDE * DVec2::new(pixel.x, -pixel.y)
    }

    /// Which pixel is there on the sheet.
    pub fn pixel_at(&self, at: DVec2) -> DVec2 {
        let way = (at - self.middle()) / Self::SIDE;
        DVec2::new(way.x, -way.y)
    }

    fn middle(&self) -> DVec2 {
        self.corner + DVec2::splat(0.5 * Self::SIDE * f64::from(PIXELS))
    }
}

/// Where a power of ten is on the axis of distances.
pub fn on_axis(exponent: f64) -> DVec2 {
    DVec2::new(20.0 + 22.5 * exponent, 236.0)
}

/// Which power of ten is there on the sheet.
pub fn exponent_at(at: DVec2) -> f64 {
    (at.x - 20.0) / 22.5
}

impl Parameters {
    /// From the eye to the center, in radii.
    pub fn away(&self) -> f64 {
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
    pub fn away_in_words(&self) -> String {
        let power = raised((self.tenths / 10).into());
        match (self.tenths / 10, self.tenths % 10) {
            (0, _) => format!("{:.1}", self.away()),
            (_, 0) => format!("10{power}"),
            (tens, _) => format!("{:.1} · 10{power}", self.away() / ten_to(tens)),
        }
    }

    /// The star, and the ray.
    pub fn case(&self) -> Case {
        let (center, radius) = self.star();
        let ray = self.scene().ray(&self.ray(self.pixel));
        Case {
            center,
            radius,
            ray,
        }
    }

    /// How far a ray goes from one `f64` t to the next where the star is, in radii.
    pub fn step(&self) -> f64 {
        let t = self.radius * self.away();
        (t.next_up() - t) / self.radius
    }

    fn scene(&self) -> Scene {
        Scene {
            name: FIGURE.name.to_owned(),
            width: PIXELS,
            sun: None,
            lens: Lens::new(Point3::ZERO, Vec3::NEG_Z, [self.away() / CLOSER; 2]),
            spheres: vec![self.star()],
        }
    }

    fn star(&self) -> (Point3, f64) {
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
pub fn draw(parameters: &Parameters) -> String {
    let mut svg = FIGURE.sheet(400.0, 410.0);
    for sky in SKIES {
        let frame = Frame {
            corner: sky.corner,
            side: Sky::SIDE,
        };
        let above = DVec2::new(sky.middle().x, 14.0);
        svg.label("ink", above, Anchor::Middle, sky.name);
        frame.draw(&mut svg, &parameters.picture(sky.eye));
        let half = DVec2::splat(0.5 * Sky::SIDE);
        let chosen = sky.on_sheet(parameters.pixel);
        svg.rect("black line", chosen - half, 2.0 * half);
    }
    draw_axis(&mut svg, parameters.tenths);
    Numbers::of(&parameters.case()).draw(&mut svg);
    svg.finish()
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
