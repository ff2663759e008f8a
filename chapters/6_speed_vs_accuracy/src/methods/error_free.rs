//! Error-free transformations: sums and products together with what rounding took
//! from them.
//!
//! The rounding error of +, − or × is itself an `f64`, and a few operations find
//! it (Knuth; Dekker, *A floating-point technique for extending the available
//! precision*, 1971). Products need numbers between 1e-290 and 1e300 in size, or
//! zero.

use common::rtweekend::*;

/// a + b as a rounded sum and its error.
#[inline]
pub(crate) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_seen = sum - a;
    let error = (a - (sum - b_seen)) + (b - b_seen);
    (sum, error)
}

/// As [`two_sum`], for |a| ≥ |b| or a = 0.
#[inline]
pub(crate) fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// a × b as a rounded product and its error.
#[inline]
pub(crate) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (halves(a), halves(b));
    let error = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
    (product, error)
}

/// c = |C − Q|² − r², off by no more than u·|c| + 64u²·(|C − Q|² + r²).
pub(crate) fn c(center: Point3, radius: f64, origin: Point3) -> f64 {
    let (mut sum, mut error) = two_product(radius, -radius);
    for (to, from) in center.to_array().into_iter().zip(origin.to_array()) {
        let (oc, oc_error) = two_sum(to, -from);
        let (square, square_error) = two_product(oc, oc);
        let sum_error;
        (sum, sum_error) = two_sum(sum, square);
        error += sum_error + (square_error + 2.0 * oc * oc_error);
    }
    sum + error
}

/// x as a sum of two numbers of 26 digits or fewer, so that the products of
/// such halves do not round.
#[inline]
fn halves(x: f64) -> (f64, f64) {
    const DIGITS: u64 = 1 << 27;
    // Half a unit of the 26th digit is added first: that rounds to nearest, and
    // the rest, which has a sign of its own, needs one digit less.
    let high = f64::from_bits((x.to_bits() + DIGITS / 2) & !(DIGITS - 1));
    (high, x - high)
}
