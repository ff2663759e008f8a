//! Digits vanish: drag the star away, and choose a ray.

use figures::cancellation::Numbers;
use figures::digits::{Parameters, SKIES, draw, exponent_at, on_axis};
use figures::number::printed;
use glam::DVec2;

use crate::live::{Action, Answer, Handle, Live, Number};

/// How many digits are left at which distance.
pub(crate) const LIVE: Live = Live {
    name: "digits",
    question: "From which distance on is *D* nothing but rounding? Drag the star away, along the axis, \
        and choose a pixel in either picture.",
    numbers: &[
        Number {
            steps: 10.0,
            ..Number::new("Distance in radii, as a power of ten", 0.0, 16.0, 7.0)
        },
        Number::whole("Pixel, to the right of the middle", -7.0, 7.0, -3.0),
        Number::whole("Pixel, above the middle", -7.0, 7.0, 2.0),
        Number::choice("Radius", &["6/7", "1/700", "5000/7"]),
    ],
    handles: &[
        Handle {
            numbers: &[0],
            drag: |numbers, to| numbers[0] = exponent_at(to),
        },
        Handle {
            numbers: &[1, 2],
            drag: |numbers, to| [numbers[1], numbers[2]] = SKIES[0].pixel_at(to).to_array(),
        },
        Handle {
            numbers: &[1, 2],
            drag: |numbers, to| [numbers[1], numbers[2]] = SKIES[1].pixel_at(to).to_array(),
        },
    ],
    actions: &[
        Action {
            name: "Ten radii away",
            act: |numbers| numbers[0] = 1.0,
        },
        Action {
            name: "A million",
            act: |numbers| numbers[0] = 6.0,
        },
        Action {
            name: "The telescope's star",
            act: |numbers| numbers[0] = 8.0,
        },
    ],
    answer,
};

/// The choices of a radius: not such that squares are round numbers, of which *ac* is a
/// little less and has no digit in common.
const RADII: [f64; 3] = [6.0 / 7.0, 1.0 / 700.0, 5000.0 / 7.0];

fn answer(numbers: &[f64]) -> Answer {
    let parameters = parameters(numbers);
    let case = parameters.case();
    let found = Numbers::of(&case);
    let away = parameters.away_in_words();
    let agreeing = found.agreeing();
    Answer {
        svg: draw(&parameters),
        sentence: format!(
            "{away} radii away *h*² and *ac* agree in {agreeing} of their 17 digits. {} {}{}",
            of_discriminant(&found),
            of_t(&found, case.ray.direction.length() / case.radius),
            of_step(parameters.step()),
        ),
        handles: vec![
            on_axis(0.1 * f64::from(parameters.tenths)),
            SKIES[0].on_sheet(parameters.pixel),
            SKIES[1].on_sheet(parameters.pixel),
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

fn parameters(numbers: &[f64]) -> Parameters {
    Parameters {
        tenths: (10.0 * numbers[0]).round() as u8,
        pixel: DVec2::new(numbers[1], numbers[2]),
        radius: RADII[numbers[3] as usize],
    }
}

/// What is left of D.
fn of_discriminant(found: &Numbers) -> String {
    match found.error() {
        0.0 => "*D* has lost no digit.".to_owned(),
        ..0.001 => "*D* is off by less than a thousandth of itself.".to_owned(),
        error @ ..0.5 => format!("*D* is off by {} % of itself.", printed(100.0 * error)),
        _ => format!(
            "*D* is nothing but rounding: it should be {}, and comes out as {}.",
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
