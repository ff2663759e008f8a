//! Iterative refinement, one step: the last digits of a root that is nearly right.

use glam::DVec4;

use crate::workload::Case;

/// Refines the root near `t`: off by less than 0.8 ulp under the conditions of
/// bound R.
///
/// With F(t) = |t·d − oc|² − r², which is zero at the root τ, and s = a·τ − h,
/// F(t) = (t − τ)·((a·t − h) + s): no term is left out. So τ is t − F/`divisor`,
/// where `divisor(t)` is (a·t − h) + s, and s is ∓√D. F must be known to some
/// 70 digits of M, the divisor only to 30.
///
/// Those 70 come from cutting numbers in two. The upper parts are multiples of
/// one grid, so short that their products and sums do not round; the lower parts
/// are so small that their rounding does not matter. The radius rides along as a
/// fourth coordinate, whose square is subtracted.
#[inline(always)]
pub(super) fn refined(case: &Case, m: f64, t: f64, divisor: impl Fn(f64) -> f64) -> f64 {
    let shifter = shifter(m);

    // The point t·d: 26 digits times 26 digits, and the rest.
    let t = upper_digits(t);
    let d = case.ray.direction.extend(0.0);
    let d_high = case.ray.direction.map(upper_digits).extend(0.0);
    let point = t * d_high;
    let point_high = on_grid(point, shifter);
    let point_low = (point - point_high) + t * (d - d_high);

    // C − Q with r as its fourth coordinate: the part on the grid, and the rest.
    let (oc, error) = difference(case.center.extend(case.radius), case.ray.origin.extend(0.0));
    let oc_high = on_grid(oc, shifter);
    let oc_low = (oc - oc_high) + error;
    let residual = square(point_high - oc_high, point_low - oc_low);
    t - residual / divisor(t)
}

/// Returns (high + low)² of a vector whose last coordinate's square is subtracted.
#[inline(always)]
fn square(high: DVec4, low: DVec4) -> f64 {
    let sum = |v: DVec4| (v.x + v.z) + (v.y - v.w);
    sum(high * high) + sum((high + high + low) * low)
}

/// Returns the vector with each coordinate rounded to a multiple of the grid of `shifter`.
#[inline(always)]
fn on_grid(v: DVec4, shifter: f64) -> DVec4 {
    (v + shifter) - shifter
}

/// Returns 1.5 · 2⁵² times the grid, which is 2⁻²⁵ of the power of two next below
/// √m: a sum with it is a multiple of the grid.
#[inline(always)]
fn shifter(m: f64) -> f64 {
    let exponent = ((m.to_bits() >> 52) + 1023) / 2;
    f64::from_bits(((exponent + 27) << 52) | (1 << 51))
}

/// Returns the first 26 binary digits of `x`.
#[inline(always)]
fn upper_digits(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & !((1 << 27) - 1))
}

/// Returns a − b, rounded, and the error of rounding (Knuth).
#[inline(always)]
fn difference(a: DVec4, b: DVec4) -> (DVec4, DVec4) {
    let difference = a - b;
    let b_seen = a - difference;
    let error = (a - (difference + b_seen)) + (b_seen - b);
    (difference, error)
}
