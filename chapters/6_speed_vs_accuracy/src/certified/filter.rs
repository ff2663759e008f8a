//! A static filter: plain `f64` with an error bound that holds for all questions alike.
//!
//! The first stage, and the words in which all stages say that they are not certain.

use common::rtweekend::*;

use super::refined::refined;

/// The largest relative error of one operation.
pub(super) const U: f64 = f64::EPSILON / 2.0;

/// Bound E: a and M are from 2⁻⁴⁵⁰ to 2⁴⁵⁰.
const E_EXPONENT: u64 = 450;

/// Bound C: |ĉ − c| ≤ 8u·M.
const C_BAND: f64 = 8.0 * U;

/// Bound D: |D̂ − D| ≤ 24u·a·M.
const D_BAND: f64 = 24.0 * U;

/// Bound T: |t̂ − t|·√D̂ ≤ 34u·M where D̂ > 48u·a·M. A root so far from an end of the range is
/// in it, or out.
const T_BAND: f64 = 64.0 * U;

/// Bound T, one more product included: 38u·M. A nearer root so far before the range is out. One
/// that is not is found, once divided, less than [`T_BAND`] before it: so the two tests never
/// contradict each other.
const BEFORE_BAND: f64 = 48.0 * U;

/// Bound R: where D̂ > 2⁻¹⁶·a·M and |t̂|·√D̂ > 2⁻¹⁵·M, the refined t is less than
/// 0.8 ulp off.
const R_BANDS: [f64; 2] = [1.0 / 65_536.0, 1.0 / 32_768.0];

/// What a stage says that has too few digits to be certain.
#[derive(Clone, Copy, Debug)]
pub(super) struct Unclear;

/// The first stage: `t`, infinity for a miss, and NaN if it is not certain. `ULP` asks for a
/// `t` within one ulp.
///
/// A block of questions is asked in SIMD lanes, which all take the same way: so this is one
/// number instead of nested options, and both roots are divided at the same time.
#[inline(always)]
pub(crate) fn filter<const ULP: bool>(
    center: Point3,
    radius: f64,
    ray: &Ray,
    t_min: f64,
    t_max: f64,
) -> f64 {
    let has_numbers = t_min < t_max;
    if !has_numbers {
        return f64::INFINITY;
    }
    let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let h = ray.direction.dot(oc);
    let (oc_squared, r_squared) = (oc.length_squared(), radius * radius);
    let (c, m) = (oc_squared - r_squared, oc_squared + r_squared);
    let discriminant = h * h - a * c;
    // No comparison with NaN holds, so none here is certain then.
    let m = if is_ordinary(a) & is_ordinary(m) {
        m
    } else {
        f64::NAN
    };
    let am = a * m;
    // From outside, a ray that does not turn towards the center meets nothing.
    let turns_away = (h <= 0.0) & (c > C_BAND * m) & (t_min >= 0.0);
    if (discriminant < -D_BAND * am) | turns_away {
        return f64::INFINITY;
    }
    let is_clear = discriminant > if ULP { R_BANDS[0] } else { 2.0 * D_BAND } * am;
    if !is_clear {
        return f64::NAN;
    }
    let (sqrtd, band) = (discriminant.sqrt(), T_BAND * m);
    // The roots as in `half_b_q`. The nearer one counts, unless it lies before the range: both
    // sides of that are multiplied by its denominator, so that one division is enough.
    let q = h + sqrtd.copysign(h);
    let c_is_nearer = h.is_sign_positive();
    let (numerator, denominator) = if c_is_nearer { (c, q) } else { (q, a) };
    let before_band = BEFORE_BAND * m * denominator;
    let is_before = (numerator - t_min * denominator) * sqrtd <= -before_band;
    let takes_c = c_is_nearer ^ is_before;
    let (numerator, denominator) = if takes_c { (c, q) } else { (q, a) };
    let t = numerator / denominator;
    let gap = lesser(t - t_min, t_max - t) * sqrtd;
    if gap <= -band {
        return f64::INFINITY;
    }
    let is_clear = (gap > band) & (!ULP | ((t * sqrtd).abs() > R_BANDS[1] * m));
    if !is_clear {
        return f64::NAN;
    }
    if !ULP {
        return t;
    }
    let slope = if is_before { sqrtd } else { -sqrtd };
    refined(center, radius, ray, m, t, |t| (a * t - h) + slope)
}

/// The lesser of the two, the first if one is NaN: a single instruction.
#[inline(always)]
fn lesser(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

/// Whether `x` is from 2⁻⁴⁵⁰ to 2⁴⁵⁰. If a and M are, nothing overflows on the
/// way, and what underflow takes away is far below every bound here (bound E).
#[inline(always)]
fn is_ordinary(x: f64) -> bool {
    const LEAST: u64 = (1023 - E_EXPONENT) << 52;
    const SPAN: u64 = (2 * E_EXPONENT) << 52;
    // One comparison for both ends and NaN: neither x nor its bits are negative.
    x.to_bits().wrapping_sub(LEAST) < SPAN
}
