//! Error analysis of one case: each method's answer, and its error in ulps.

use std::error::Error;

use common::rtweekend::*;
use figures::number::three_digits;
use laws::oracle::ExactRoot;
use measure::accuracy::{exact, ulps_off};
use speed_vs_accuracy::{Case, METHODS, Method, Precision, Solve};

use launcher::command_line::Words;

/// Returns where a ray hits a sphere, by exact arithmetic and by each method of chapter 6, with its
/// error.
pub(crate) fn hit(words: &Words) -> Result<String, Box<dyn Error>> {
    let missing = || {
        let needed = ["--origin", "--direction", "--center", "--radius"];
        let missing: Vec<&str> = needed.into_iter().filter(|it| !words.has(it)).collect();
        let missing = format!("missing: {}", missing.join(", "));
        words.command.misuse(&missing)
    };
    let vector = |name| words.option(name, vector)?.ok_or_else(missing);
    let ray = Ray::new(vector("--origin")?, vector("--direction")?);
    let center = vector("--center")?;
    let radius = words.option("--radius", radius)?.ok_or_else(missing)?;
    let case = Case::new(center, radius, ray);
    let t_min = words.option("--t-min", finite)?.unwrap_or_default();
    let of = |precision| {
        let mut methods = METHODS.to_vec();
        methods.retain(|method| method.precision() == precision);
        compare_methods(&case, precision, &methods, t_min)
    };
    Ok(Precision::ALL.map(of).join("\n"))
}

/// The error in ulps that a handful of rounded operations leaves.
pub(crate) const ORDINARY: f64 = 4.0;

/// Writes the exact answer to `case`, rounded to one precision, for t above `t_min`, and below it a
/// line for each of `methods`, which have this precision: its answer, and its error in ulps.
pub(crate) fn compare_methods(
    case: &Case,
    precision: Precision,
    methods: &[Method],
    t_min: f64,
) -> String {
    let rounded = case.rounded(precision);
    let name = precision.name();
    let Some(exact) = exact(&rounded) else {
        return format!("These numbers do not fit into {name}: they overflow.\n");
    };
    let (lower, greatest) = match precision {
        Precision::Double => (t_min, f64::MAX),
        Precision::Single => (f64::from(t_min as f32), f64::from(f32::MAX)),
    };
    let root = exact.nearest_root_in(lower, f64::INFINITY);
    let changed = if rounded == *case {
        ""
    } else {
        ", after the numbers are rounded to it"
    };
    let found = match root.map(|root| root.rounded()) {
        Some(t) if t.abs() >= greatest => {
            return format!("These numbers do not fit into {name}: t overflows.\n");
        }
        Some(t) => format!("the ray hits at t = {t:?}"),
        None if rounded.ray.direction == Vec3::ZERO => {
            "the direction is zero, and such a ray hits nothing".to_owned()
        }
        None => "the ray misses".to_owned(),
    };
    let line = |method| line(method, case.put_to(method, t_min, f64::INFINITY), root);
    let lines: String = methods.iter().map(line).collect();
    format!("In {name}{changed}, {found}.\n{lines}")
}

fn line(method: &Method, t: Option<f64>, root: Option<ExactRoot>) -> String {
    let answer = t.map_or("miss".to_owned(), |t| {
        format!("hit  {}", shortest(method, t))
    });
    let verdict = match (t, root) {
        (Some(t), Some(root)) => how_far_off(ulps_off(root, method.precision(), t)),
        (None, None) => "right".to_owned(),
        (Some(_), None) => "WRONG: the ray misses".to_owned(),
        (None, Some(_)) => "WRONG: the ray hits".to_owned(),
    };
    format!("  {:<22}{answer:<30}{verdict}\n", method.name)
}

/// Writes an error in words.
fn how_far_off(ulps: f64) -> String {
    match ulps {
        f64::INFINITY => "more than 1e308 ulps off".to_owned(),
        1.0 => "1 ulp off".to_owned(),
        error => format!("{} ulps off", three_digits(error)),
    }
}

/// Writes `t` in the fewest digits that are read as `t` again, in the precision of `method`.
fn shortest(method: &Method, t: f64) -> String {
    match method.solve {
        Solve::Double(_) => format!("{t:?}"),
        Solve::Single(_) => format!("{:?}", t as f32),
    }
}

/// Parses a finite number. The error names the text.
fn finite(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        _ => Err(format!(
            "{:?} is not a finite number; write one such as 0.5, -3 or 1e-9",
            text.trim()
        )),
    }
}

/// Parses a finite number that is not negative.
fn radius(text: &str) -> Result<f64, String> {
    match finite(text)? {
        radius if radius >= 0.0 => Ok(radius),
        _ => Err(
            "a radius is not negative: since version 4, the book takes such a radius for 0"
                .to_owned(),
        ),
    }
}

/// Parses three finite numbers with commas between them.
fn vector(text: &str) -> Result<Vec3, String> {
    let numbers: Vec<f64> = text.split(',').map(finite).collect::<Result<_, _>>()?;
    match numbers[..] {
        [x, y, z] => Ok(Vec3::new(x, y, z)),
        _ => Err("three numbers with commas between them are needed, such as 0,0,-1".to_owned()),
    }
}
