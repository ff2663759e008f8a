//! Fixed point: the decimal digits of a number, place by place, below those of another.

/// As many decimal digits as tell every `f64` from its neighbors.
pub(crate) const PLACES: usize = 17;

/// The exponent of the first decimal digit of `x`; that of 0 is 0.
pub(crate) fn exponent(x: f64) -> i32 {
    scientific(x, PLACES - 1).1
}

/// The digits of |x|, rounded, at the place of 10 to the power `first` and the next ones.
/// There must be none before.
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

/// In how many digits from the first on the two agree.
pub(crate) fn agreeing(one: &str, other: &str) -> usize {
    one.bytes()
        .zip(other.bytes())
        .take_while(|(one, other)| one == other)
        .count()
}

/// So many digits of |x| after the first one, and the exponent of the first.
fn scientific(x: f64, after: usize) -> (String, i32) {
    let text = format!("{:.after$e}", x.abs());
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    (digits.replace('.', ""), exponent.parse().unwrap_or(0))
}
