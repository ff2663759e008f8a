//! Digits of D and t that are lost with distance: a star goes away, and a reader chooses the
//! method that draws it. A ray of it is chosen by its pixel.

use speed_vs_accuracy::{Arithmetic, Case, Lens, Method, Scene, USUAL_T_MIN};

use crate::cancellation::Discriminant::{self, Difference, Whole};
use crate::cancellation::{Numbers, Terms};
use crate::prelude::*;

parameters! {
    exponent: f64 = Parameter::whole("Distance in radii, as a power of ten", 0.0, 16.0, 7.0);
    pixel: Vec3 =
        Parameter::whole("Pixel, to the right of the middle", -7.0, 7.0, -3.0),
        Parameter::whole("Pixel, above the middle", -7.0, 7.0, 2.0);
    eye: f64 = Parameter::choice("The left picture", NAMES);
}

/// A way to draw the star: the words of the list and of the caption, the method, and how it comes
/// to D.
type Eye = (&'static str, Method, fn(&Case) -> Discriminant);

/// The ways that a reader can choose for the left picture; the right one is drawn by the last.
const EYES: [Eye; 5] = [
    ("as chapter 5 has it", Method::HALF_B, |case| {
        Difference(Terms::of_half_b(case))
    }),
    ("first cure: cross_q", Method::CROSS_Q, |case| {
        Difference(Terms::of_cross_q(case))
    }),
    ("second cure: half_b_q", Method::HALF_B_Q, |case| {
        Difference(Terms::of_half_b(case))
    }),
    ("third cure: compensated", Method::COMPENSATED, |_| {
        Whole("The cross product keeps what rounding takes.")
    }),
    ("exact", Method::EXACT, |_| {
        Whole("Whole numbers never round.")
    }),
];
const NAMES: &[&str] = &[EYES[0].0, EYES[1].0, EYES[2].0, EYES[3].0, EYES[4].0];

/// The radius of the star. Its square is no round number: else *a·c* would be a little less than a
/// round number, and have no digit in common with it.
const RADIUS: f64 = 6.0 / 7.0;

/// The live figure: a star at a distance that a reader chooses, seen by a method and as it is, and
/// the digits of one ray.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: figure!("digits"),
    handles: &[
        point!(AXIS, exponent),
        point!(SKIES[0], pixel),
        point!(SKIES[1], pixel),
    ],
    actions: &[
        ("Ten radii away", |it| it.exponent = 1.0),
        ("A million", |it| it.exponent = 6.0),
        ("The telescope's star", |it| it.exponent = 8.0),
    ],
    answer,
};

fn answer(chosen: &Parameters) -> DrawnFigure {
    let case = chosen.case();
    let (_, method, discriminant) = chosen.eye();
    let found = Numbers::of(&case, *method, discriminant(&case));
    let away = power_of_ten(chosen.exponent as i32);
    let of_terms = match &found.discriminant {
        Whole(_) => String::new(),
        Difference(terms) => {
            let [one, other] = terms.names;
            let agreeing = terms.agreeing();
            let of_discriminant = of_discriminant(terms.difference(), found.exact_discriminant);
            format!(" {one} and {other} agree in {agreeing} of their 17 digits. {of_discriminant}")
        }
    };
    let of_t = of_t(&found, case.ray.direction.length() / RADIUS);
    let sentence = format!("The star is {away} radii away.{of_terms} {of_t}");
    let agreeing = Terms::of_half_b(&case).agreeing();
    let digits = if agreeing == 1 { "digit" } else { "digits" };
    let agree = format!("{agreeing} {digits}");
    let says = [("distance", away), ("agree", agree)];
    DrawnFigure::new(draw(chosen, &found), sentence, says)
}

/// Says how many digits of a `discriminant` are right.
fn of_discriminant(discriminant: f64, exact: f64) -> String {
    match ((discriminant - exact) / exact).abs() {
        0.0 => "*D* has lost no digit.".to_owned(),
        ..0.001 => "*D* is off by less than a thousandth of itself.".to_owned(),
        error @ ..0.5 => format!("*D* is off by {} % of itself.", printed(100.0 * error)),
        _ => format!(
            "*D* is only rounding error: it should be {}, and is computed as {}.",
            printed(exact),
            printed(discriminant)
        ),
    }
}

/// Says how many digits of t are left; a t of 1 is `radii` radii long.
fn of_t(found: &Numbers, radii: f64) -> String {
    match (found.t, found.exact_t, found.right_digits()) {
        (Some(t), Some(exact), _) if t == exact => "No digit of *t* is wrong.".to_owned(),
        (Some(t), Some(exact), Some(right)) => format!(
            "Of the 17 digits of *t* {right} are right, and it is off by {} radii.",
            printed(radii * (t - exact).abs())
        ),
        (Some(_), _, _) => "The ray misses the star, and the left picture has a hit.".to_owned(),
        (None, Some(_), _) => "The ray hits the star, and the left picture has a miss.".to_owned(),
        (None, None, _) => "The ray misses the star, in both pictures.".to_owned(),
    }
}

/// The number of pixels in a row of a star's picture, and the number in a radius: the half keeps
/// rays off the rim.
const PIXELS: u32 = 15;
const PER_RADIUS: f64 = 5.5;

/// The factor by which the rays of the book's camera are closer together here, for which the lens
/// makes up. Behind them is so little of the sky that it has few colors.
const CLOSER: f64 = 16.0;

/// The planes of the two stars' pictures, in pixels from the middle of each.
const SKIES: [Plane; 2] = [
    Plane::new(97.75, 115.75, SIDE),
    Plane::new(301.75, 115.75, SIDE),
];
const SIDE: f64 = 12.5;

/// The axis of distances, as powers of ten.
const AXIS: Axis = Axis::new(20.0, 236.0, 360.0, 0.0, 16.0);

impl Parameters {
    /// Returns the distance from the eye to the star's center, in radii.
    fn away(&self) -> f64 {
        (0..self.exponent as u8).fold(1.0, |power, _| 10.0 * power)
    }

    /// Returns the star and the ray through the chosen pixel.
    fn case(&self) -> Case {
        Case {
            center: self.center(),
            radius: RADIUS,
            ray: self.scene().ray(&self.ray(self.pixel)),
        }
    }

    /// Returns how the left picture is drawn.
    fn eye(&self) -> &'static Eye {
        &EYES[self.eye as usize]
    }

    fn center(&self) -> Point3 {
        RADIUS * Point3::new(0.25, -0.5, -self.away())
    }

    fn scene(&self) -> Scene {
        Scene {
            name: LIVE.name().to_owned(),
            width: PIXELS,
            sun: None,
            t_min: USUAL_T_MIN,
            lens: Lens::new(Point3::ZERO, Vec3::NEG_Z, [self.away() / CLOSER; 2]),
            spheres: vec![(self.center(), RADIUS)],
        }
    }

    /// Returns the ray of the book's camera that the lens turns into the ray through a pixel.
    fn ray(&self, pixel: Vec3) -> Ray {
        let through = Vec3::new(0.25, -0.5, -CLOSER) + pixel / PER_RADIUS;
        Ray::new(Point3::ZERO, through / CLOSER)
    }

    fn picture(self, method: Method) -> Picture {
        let scene = self.scene();
        let middle = 0.5 * f64::from(PIXELS - 1);
        Picture::paint(PIXELS, PIXELS, move |i, j| {
            let ray = self.ray(xy(f64::from(i) - middle, middle - f64::from(j)));
            scene.look(Arithmetic::Method(method), &ray).color
        })
    }
}

/// Draws the star by the chosen method and exactly, the axis of distances, and the digits of the
/// chosen ray.
fn draw(chosen: &Parameters, numbers: &Numbers) -> Svg {
    let mut svg = LIVE.figure.sheet(410.0);
    for (sky, (name, method, _)) in SKIES.into_iter().zip([chosen.eye(), &EYES[4]]) {
        svg.label("ink", spot(sky.origin.x, 14.0), Middle, name);
        let corner = sky.origin - 0.5 * SIDE * f64::from(PIXELS);
        PixelGrid { corner, side: SIDE }.draw(&mut svg, &chosen.picture(*method));
        let pixel = sky.point(chosen.pixel) - 0.5 * SIDE;
        svg.rect("black line", pixel, DVec2::splat(SIDE));
    }
    let powers = [0.0, 4.0, 8.0, 12.0, 16.0].into_iter();
    AXIS.draw(&mut svg, &ticks(powers, |it| power_of_ten(it as i32)));
    svg.small_label("ink", spot(200.0, 272.0), Middle, "distance in radii");
    svg.circle("ray solid", AXIS.point(chosen.exponent), 4.5);
    numbers.draw(&mut svg);
    svg
}
