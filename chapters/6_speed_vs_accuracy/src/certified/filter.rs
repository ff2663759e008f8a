//! A static filter: plain `f64` with an error bound that holds for all questions alike.
//!
//! The first stage, and the words in which all stages say that they are not certain.

use common::rtweekend::*;

use super::refined::refined;
use crate::methods::roots_by_q;

/// The largest relative error of one operation.
pub(super) const U: f64 = f64::EPSILON / 2.0;

/// Bound E: a and M are from 2⁻⁴⁵⁰ to 2⁴⁵⁰.
const E_EXPONENT: u64 = 450;

/// Bound C: |ĉ − c| ≤ 8u·M.
const C_BAND: f64 = 8.0 * U;

/// Bound D: |D̂ − D| ≤ 24u·a·M.
pub const D_BAND: f64 = 24.0 * U;

/// Bound T: |t̂ − t|·√D̂ ≤ 64u·M where D̂ > 48u·a·M.
const T_BAND: f64 = 64.0 * U;

/// Bound R: where D̂ > 2⁻¹⁶·a·M and |t̂|·√D̂ > 2⁻¹⁵·M, the refined t is less than
/// 0.8 ulp off.
const R_BANDS: [f64; 2] = [1.0 / 65_536.0, 1.0 / 32_768.0];

/// What a stage says that has too few digits to be certain.
#[derive(Clone, Copy, Debug)]
pub(super) struct Unclear;

/// The first stage. `ULP` asks for a t within one ulp.
#[inline(always)]
pub(super) fn filter<const ULP: bool>(
    center: Point3,
    radius: f64,
    ray: &Ray,
    t_min: f64,
    t_max: f64,
) -> Result<Option<f64>, Unclear> {
    let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let h = ray.direction.dot(oc);
    let (oc_squared, r_squared) = (oc.length_squared(), radius * radius);
    let (c, m) = (oc_squared - r_squared, oc_squared + r_squared);
    let (discriminant, am) = (h * h - a * c, a * m);
    if !(is_ordinary(a) && is_ordinary(m)) {
        return Err(Unclear);
    }
    // From outside, a ray that does not turn towards the center meets nothing.
    let turns_away = h <= 0.0 && c > C_BAND * m && t_min >= 0.0;
    if discriminant < -D_BAND * am || turns_away {
        return Ok(None);
    }
    if discriminant <= if ULP { R_BANDS[0] } else { 2.0 * D_BAND } * am {
        return Err(Unclear);
    }
    let [nearer, farther] = roots_by_q(a, h, c, discriminant).ok_or(Unclear)?;
    let sqrtd = discriminant.sqrt();
    for (sqrtd, (numerator, denominator)) in [(-sqrtd, nearer), (sqrtd, farther)] {
        let t = numerator / denominator;
        if !lies_between([t - t_min, t_max - t], sqrtd.abs(), T_BAND * m)? {
            continue;
        }
        if !ULP {
            return Ok(Some(t));
        }
        if (t * sqrtd).abs() <= R_BANDS[1] * m {
            return Err(Unclear);
        }
        let divisor = |t: f64| (a * t - h) + sqrtd;
        return Ok(Some(refined(center, radius, ray, m, t, divisor)));
    }
    Ok(None)
}

/// Whether a root lies inside the range, from its gaps to both ends: each is off
/// by no more than `band` / `sqrtd`.
#[inline(always)]
pub(super) fn lies_between(
    [above, below]: [f64; 2],
    sqrtd: f64,
    band: f64,
) -> Result<bool, Unclear> {
    let (above, below) = (above * sqrtd, below * sqrtd);
    if above > band && below > band {
        Ok(true)
    } else if above <= -band || below <= -band {
        Ok(false)
    } else {
        Err(Unclear)
    }
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
