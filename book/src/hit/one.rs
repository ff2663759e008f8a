//! One question, method by method.

use std::error::Error;
use std::fmt::Write;

use common::engine::output;
use laws::oracle::Exact;
use laws::truth::{Truth, three_digits};
use speed_vs_accuracy::{Case, Method, Precision};

use super::{shortest, strain};

/// An error of this many ulps is what a handful of rounded operations leaves:
/// it needs no reason.
const ORDINARY: f64 = 4.0;

/// Prints the exact answer, and what each method answers instead.
pub(crate) fn print(
    question: &Case,
    methods: &[Method],
    range: (f64, f64),
) -> Result<(), Box<dyn Error>> {
    let mut text = String::new();
    for precision in [Precision::Double, Precision::Single] {
        let of_precision = |method: &&Method| Precision::of(method) == precision;
        let methods: Vec<&Method> = methods.iter().filter(of_precision).collect();
        if !methods.is_empty() {
            part(&mut text, question, precision, &methods, range)?;
        }
    }
    Ok(output::to_open_stdout(|out| {
        out.write_all(text.as_bytes())
    })?)
}

/// What the methods of one precision say.
fn part(
    text: &mut String,
    question: &Case,
    precision: Precision,
    methods: &[&Method],
    range: (f64, f64),
) -> Result<(), std::fmt::Error> {
    let rounded = question.rounded(precision);
    let name = precision.name();
    if !text.is_empty() {
        text.push('\n');
    }
    let Some(exact) = Exact::new(rounded.center, rounded.radius, &rounded.ray) else {
        return writeln!(text, "{name} has no such numbers: they overflow.");
    };
    let (t_min, t_max) = match precision {
        Precision::Double => range,
        Precision::Single => (f64::from(range.0 as f32), f64::from(range.1 as f32)),
    };
    let truth = Truth::of(&exact, precision, t_min, t_max);
    let changed = match rounded == *question {
        true => "",
        false => ", after the numbers are rounded to it",
    };
    match truth {
        Some(truth) => writeln!(
            text,
            "In {name}{changed}, the ray hits at t = {:?}.",
            truth.nearest()
        )?,
        None => writeln!(text, "In {name}{changed}, the ray misses.")?,
    }
    for method in methods {
        let t = question.put_to(method, range.0, range.1);
        text.push_str(&line(method, question, t, truth));
    }
    Ok(())
}

fn line(method: &Method, question: &Case, t: Option<f64>, truth: Option<Truth>) -> String {
    let answer = t.map_or("miss".to_owned(), |t| {
        format!("hit  {}", shortest(method, t))
    });
    let error = t.zip(truth).map(|(t, truth)| truth.error_in_ulps(t));
    let verdict = match (t, truth, error) {
        (_, _, Some(error)) => format!("{} ulps off", three_digits(error)),
        (None, None, _) => "right".to_owned(),
        (Some(_), ..) => "WRONG: it misses".to_owned(),
        (None, ..) => "WRONG: it hits".to_owned(),
    };
    let is_ordinary = match error {
        Some(error) => error <= ORDINARY,
        None => t.is_none() && truth.is_none(),
    };
    let mut line = format!("  {:<22}{answer:<30}{verdict}", method.name);
    line.push('\n');
    if !is_ordinary {
        for reason in strain::reasons(method, question) {
            line += &format!("  {:<22}{reason}\n", "");
        }
    }
    line
}
