//! Numbers in few characters.

/// Such as 0.41, 158, 1.3e-16.
pub fn three_digits(value: f64) -> String {
    // The largest numbers would round up to infinity.
    let rounded = format!("{value:.2e}").parse().ok();
    let rounded = rounded.filter(|it: &f64| it.is_finite()).unwrap_or(value);
    if rounded == 0.0 || (1e-3..1e6).contains(&rounded) {
        format!("{rounded}")
    } else {
        format!("{rounded:e}")
    }
}

/// A number of ulps, or of wrong decisions: two decimals at most, from 100 000 on a
/// power of ten.
pub(crate) fn short(value: f64) -> String {
    match value {
        100_000.0.. => {
            let exponent = value.log10().floor() as i32;
            let digits = value / 10_f64.powi(exponent);
            format!("{digits:.1}·10{}", raised(exponent))
        }
        100.0.. => format!("{value:.0}"),
        10.0.. => format!("{value:.1}"),
        _ => crate::svg::number(value),
    }
}

/// A number as an exponent.
pub(crate) fn raised(number: i32) -> String {
    let digit = |digit: char| {
        digit
            .to_digit(10)
            .map(|digit| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit as usize))
    };
    number
        .to_string()
        .chars()
        .filter_map(digit)
        .flatten()
        .collect()
}
