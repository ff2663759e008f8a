//! Fixed point: the decimal digits of a number, place by place, below those of another.

/// The number of decimal digits that tell every `f64` from its neighbors.
pub(crate) const PLACES: usize = 17;

/// Returns the exponent of the first decimal digit of `x`; that of 0 is 0.
pub(crate) fn exponent(x: f64) -> i32 {
    scientific(x, PLACES - 1).1
}

/// Writes the digits of |x|, rounded, from the place of 10 to the power `first` on. No digit but 0
/// may stand before that place.
pub(crate) fn places(x: f64, first: i32) -> String {
    let before = first - exponent(x);
    let Some(after) = (PLACES as i32 - 1).checked_sub(before).filter(|n| *n >= 0) else {
        return "0".repeat(PLACES);
    };
    // Fewer digits may round up to a place more.
    let (digits, exponent) = scientific(x, after as usize);
    let zeros = "0".repeat((first - exponent).max(0) as usize);
    format!("{:0<PLACES$}", zeros + &digits)
}

/// Counts the digits in which the two agree, from the first on.
pub(crate) fn agreeing(one: &str, other: &str) -> usize {
    one.bytes()
        .zip(other.bytes())
        .take_while(|(one, other)| one == other)
        .count()
}

/// Writes |x| with `after` digits behind the first one, and returns them with the
/// exponent of the first.
fn scientific(x: f64, after: usize) -> (String, i32) {
    let text = format!("{:.after$e}", x.abs());
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    (digits.replace('.', ""), exponent.parse().unwrap_or(0))
}
