//! Parsing and shortest printing of decimal numbers.

use common::rtweekend::*;
use speed_vs_accuracy::{Method, Precision, Solve};

/// `t` in as few digits as lead back to it in the precision of `method`.
pub(super) fn shortest(method: &Method, t: f64) -> String {
    match method.solve {
        Solve::Double(_) => format!("{t:?}"),
        Solve::Single(_) => format!("{:?}", t as f32),
    }
}

/// The least normal number above 0, and the greatest of all.
pub(super) fn ends(precision: Precision) -> (f64, f64) {
    match precision {
        Precision::Double => (f64::MIN_POSITIVE, f64::MAX),
        Precision::Single => (f64::from(f32::MIN_POSITIVE), f64::from(f32::MAX)),
    }
}

/// The `f64` nearest to the decimal number in `text`.
pub(super) fn finite(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(number)
            if number.is_infinite() && text.contains(|digit: char| digit.is_ascii_digit()) =>
        {
            Err("is too large for a number: the largest is 1.7976931348623157e308".to_owned())
        }
        _ => Err("is not a number; write one such as 0.5, -3 or 1e-9".to_owned()),
    }
}

/// A number or an infinity.
pub(super) fn bound(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(number) if !number.is_nan() => Ok(number),
        _ => Err("is not a number; write one such as 0.001, or inf".to_owned()),
    }
}

/// Three numbers with commas between them.
pub(super) fn vector(text: &str) -> Result<Vec3, String> {
    let numbers: Vec<f64> = text
        .split(',')
        .map(|number| finite(number).map_err(|problem| format!("{:?} {problem}", number.trim())))
        .collect::<Result<_, _>>()?;
    match numbers[..] {
        [x, y, z] => Ok(Vec3::new(x, y, z)),
        _ => Err("three numbers with commas between them are needed, such as 0,0,-1".to_owned()),
    }
}
