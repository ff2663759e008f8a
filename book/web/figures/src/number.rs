//! Number formatting: numbers in few characters, for files, pages and drawings.

use std::cmp::Ordering;

use common::rtweekend::*;

/// Writes a number with three significant digits, for a file: 0.41, 158, 1.3e-16. Numbers from
/// 0.001 up to a million have no exponent. A number that is not finite becomes `inf`, `-inf` or
/// `NaN`.
pub fn three_digits(value: f64) -> String {
    let rounded = format!("{value:.2e}");
    let Some((digits, exponent)) = rounded.split_once('e') else {
        return rounded; // It is infinite, or no number.
    };
    match exponent.parse() {
        Ok(decimals @ -3..2) => trimmed(&format!("{value:.*}", (2 - decimals) as usize)).to_owned(),
        Ok(zeros @ 2..6) => digits.replace('.', "") + &"0".repeat(zeros as usize - 2),
        _ => format!("{}e{exponent}", trimmed(digits)),
    }
}

/// Writes a number with three significant digits, for a page, as plain text: −0.41, 158, 271,000,
/// 1.3·10⁻¹⁶. A number that is not finite becomes `inf`, `−inf` or `NaN`.
pub fn printed(value: f64) -> String {
    as_printed(&three_digits(value))
}

/// Writes a number of a file as pages print it: 2.5·10⁻¹⁶ for `2.5e-16`, and 271,000 for a whole
/// number of five digits or more.
pub fn as_printed(text: &str) -> String {
    let text = text.replace('-', "−");
    match text.split_once('e') {
        Some((digits, exponent)) => format!("{digits}·10{}", raised(exponent)),
        None if text.len() > 4 && text.bytes().all(|digit| digit.is_ascii_digit()) => {
            in_thousands(&text)
        }
        None => text,
    }
}

/// Writes decimal digits with a comma after each group of three, counted from the end.
fn in_thousands(digits: &str) -> String {
    let groups = digits.as_bytes().rchunks(3).rev();
    let groups: Vec<_> = groups.map(String::from_utf8_lossy).collect();
    groups.join(",")
}

/// Cuts the zeros off the end of decimals, and the point if none is left.
fn trimmed(decimals: &str) -> &str {
    decimals.trim_end_matches('0').trim_end_matches('.')
}

/// Writes a whole number in superscript digits.
pub(crate) fn raised(number: impl ToString) -> String {
    let raised = |digit: char| match digit.to_digit(10) {
        Some(digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit as usize),
        None => Some('⁻'),
    };
    number.to_string().chars().filter_map(raised).collect()
}

/// Writes ten to that power: 10⁻¹⁶.
pub(crate) fn power_of_ten(exponent: i32) -> String {
    format!("10{}", raised(exponent))
}

/// Writes a number with at most two decimals, and without a minus before zero, for an SVG
/// attribute.
pub(crate) fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let short = trimmed(&text);
    if short == "-0" { "0" } else { short }.to_owned()
}

/// Formats a number with at most two decimals, for a page: 0.5, −2, 1.25. A half is rounded away
/// from zero, and a minus sign is U+2212.
pub fn spoken(value: f64) -> String {
    number((100.0 * value).round() / 100.0).replace('-', "−")
}

/// Formats numbers with at most two decimals, and "and" between them.
pub(crate) fn listed(values: &[f64]) -> String {
    let values: Vec<String> = values.iter().copied().map(spoken).collect();
    values.join(" and ")
}

/// Returns `<`, `=` or `>`: how one number compares with the other, where −0 is less than 0.
pub(crate) fn sign(one: f64, other: f64) -> char {
    match one.total_cmp(&other) {
        Ordering::Less => '<',
        Ordering::Equal => '=',
        Ordering::Greater => '>',
    }
}

/// Writes a vector as three numbers in brackets, with at most two decimals.
pub(crate) fn triple(vector: Vec3) -> String {
    let [x, y, z] = vector.to_array().map(spoken);
    format!("({x}, {y}, {z})")
}
