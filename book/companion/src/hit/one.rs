//! Error analysis of one case: each method's answer, its error in ulps, and the reason.

use std::error::Error;

use common::engine::output;
use common::rtweekend::*;
use figures::number::three_digits;
use laws::oracle::Exact;
use measure::truth::Truth;
use speed_vs_accuracy::{Case, Method, Precision};

use super::number::{ends, shortest};
use super::strain;

/// An error of this many ulps is what a handful of rounded operations leaves:
/// it needs no reason.
pub(crate) const ORDINARY: f64 = 4.0;

/// Prints the exact answer, and what each method answers instead.
pub(crate) fn print(
    case: &Case,
    methods: &[Method],
    range: (f64, f64),
) -> Result<(), Box<dyn Error>> {
    let mut text = String::new();
    for precision in Precision::ALL {
        let of_precision = |method: &&Method| method.precision() == precision;
        let methods: Vec<Method> = methods.iter().filter(of_precision).copied().collect();
        if methods.is_empty() {
            continue;
        }
        if !text.is_empty() {
            text.push('\n');
        }
        text += &under_the_microscope(case, precision, &methods, range);
    }
    Ok(output::to_stdout(|out| out.write_all(text.as_bytes()))?)
}

/// The exact answer in one precision, and what its `methods` say.
pub(crate) fn under_the_microscope(
    case: &Case,
    precision: Precision,
    methods: &[Method],
    range: (f64, f64),
) -> String {
    let rounded = case.rounded(precision);
    let name = precision.name();
    let Some(exact) = Exact::of_finite(&rounded) else {
        return format!("These numbers do not fit into {name}: they overflow.\n");
    };
    let range_of_it = match precision {
        Precision::Double => range,
        Precision::Single => (f64::from(range.0 as f32), f64::from(range.1 as f32)),
    };
    let truth = Truth::of(&exact, precision, range_of_it.0, range_of_it.1);
    let changed = if rounded == *case {
        ""
    } else {
        ", after the numbers are rounded to it"
    };
    let found = match truth.map(|truth| truth.nearest()) {
        Some(t) if t.abs() >= ends(precision).1 => {
            return format!("These numbers do not fit into {name}: t overflows.\n");
        }
        Some(t) => format!("the ray hits at t = {t:?}"),
        None if rounded.ray.direction == Vec3::ZERO => {
            "the direction is zero, and such a ray hits nothing".to_owned()
        }
        None => "the ray misses".to_owned(),
    };
    let mut text = format!("In {name}{changed}, {found}.\n");
    for method in methods {
        let t = case.put_to(method, range.0, range.1);
        text += &line(method, case, t, truth);
    }
    text
}

fn line(method: &Method, case: &Case, t: Option<f64>, truth: Option<Truth>) -> String {
    let answer = t.map_or("miss".to_owned(), |t| {
        format!("hit  {}", shortest(method, t))
    });
    let (verdict, is_ordinary) = match (t, truth) {
        (Some(t), Some(truth)) => how_far_off(t, truth),
        (None, None) => ("right".to_owned(), true),
        (Some(_), None) => ("WRONG: it misses".to_owned(), false),
        (None, Some(_)) => ("WRONG: it hits".to_owned(), false),
    };
    let mut line = format!("  {:<22}{answer:<30}{verdict}", method.name);
    line.push('\n');
    if !is_ordinary {
        for reason in strain::reasons(method, case) {
            line += &format!("  {:<22}{reason}\n", "");
        }
    }
    line
}

/// The error of `t` in words, and whether it needs no reason.
fn how_far_off(t: f64, truth: Truth) -> (String, bool) {
    match truth.error_in_ulps(t) {
        f64::INFINITY => ("more than 1e308 ulps off".to_owned(), false),
        1.0 => ("1 ulp off".to_owned(), true),
        error => (
            format!("{} ulps off", three_digits(error)),
            error <= ORDINARY,
        ),
    }
}
