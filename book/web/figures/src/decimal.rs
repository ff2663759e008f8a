//! Fixed point: the decimal digits of a number, place by place, below those of another.

/// The number of decimal digits that tell every `f64` from its neighbors.
pub(crate) const PLACES: usize = 17;

/// Returns the power of ten of the first decimal digit of `x`; 0 for 0.
pub(crate) fn exponent(x: f64) -> i32 {
    scientific(x, PLACES - 1).1
}

/// Writes [`PLACES`] digits of |x|, rounded, the first of which counts ten to the power `first`.
/// All digits before that place must be 0.
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

/// Counts the leading digits that two texts have in common.
pub(crate) fn agreeing(one: &str, other: &str) -> usize {
    one.bytes()
        .zip(other.bytes())
        .take_while(|(one, other)| one == other)
        .count()
}

/// Writes |x| with `after` digits behind the first one; returns all digits, and the power of ten of
/// the first.
fn scientific(x: f64, after: usize) -> (String, i32) {
    let text = format!("{:.after$e}", x.abs());
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    (digits.replace('.', ""), exponent.parse().unwrap_or(0))
}
