//! Filtered predicates: answers that are proven, ray by ray, while they are computed.
//!
//! A filter computes as `half_b_q` does, and knows how far off it can be. Nearly
//! always that is enough. If not, the question goes to a sharper stage, which is
//! plain `f64` too, and at last to integers, where nothing is rounded. So the
//! answer is right for every input, and nearly as fast as one that is not.
//!
//! Each bound is proven in the book, in `proofs.md`, under the letter that stands
//! beside it here. The proofs assume that operations round to nearest and that
//! tiny results are not flushed to zero. Source of the idea: Shewchuk, *Adaptive
//! Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates*,
//! 1997.

use common::rtweekend::*;

use crate::exact::exact;
use crate::fixed_width::fixed_width;
use crate::plain::roots_by_q;
use crate::refined::refined;
use crate::rescaled::rescaled;
use crate::sharper::sharper;

/// The largest relative error of one operation.
pub(crate) const U: f64 = f64::EPSILON / 2.0;

/// Bound E: a and M are from 2⁻⁴⁵⁰ to 2⁴⁵⁰.
pub const E_EXPONENT: u64 = 450;

/// Bound C: |ĉ − c| ≤ 8u·M.
pub const C_BAND: f64 = 8.0 * U;

/// Bound D: |D̂ − D| ≤ 24u·a·M.
pub const D_BAND: f64 = 24.0 * U;

/// Bound T: |t̂ − t|·√D̂ ≤ 64u·M where D̂ > 48u·a·M.
pub const T_BAND: f64 = 64.0 * U;

/// Bound R: where D̂ > 2⁻¹⁶·a·M and |t̂|·√D̂ > 2⁻¹⁵·M, the refined t is less than
/// 0.8 ulp off.
pub const R_BANDS: [f64; 2] = [1.0 / 65_536.0, 1.0 / 32_768.0];

/// Whether the ray hits within the range is right for every input, and so is the
/// choice between the two roots.
///
/// Cost: 1 √, 1 ÷, and a few + and × more than `half_b_q`. Some five times that
/// where `half_b_q` could decide wrongly, because the sphere is far or the ray
/// starts on its surface; twenty times that near a tangent; and that of [`exact`] if
/// lengths differ by a factor of 2⁶⁷. Error of t: that of `half_b_q`, unless a
/// later stage was asked. Fails: never. Input that is infinite or NaN is a miss,
/// and so is every range between whose ends no `f64` lies.
#[inline]
pub fn certified_hit(
    center: Point3,
    radius: f64,
    ray: &Ray,
    t_min: f64,
    t_max: f64,
) -> Option<f64> {
    filter::<false>(center, radius, ray, t_min, t_max)
        .unwrap_or_else(|Unclear| later_stages::<false>(center, radius, ray, t_min, t_max).0)
}

/// As [`certified_hit`], and `t` is within one ulp of the exact root.
///
/// Cost: that of `certified_hit`, and for a hit 1 ÷ and 90 + or × more. Integers
/// are asked also if D or c is small: from some 250 radii away, and close to the
/// surface. Error: less than 0.8 ulp is proven. As with [`exact`], a root
/// beyond the largest `f64` becomes that. Fails: never.
#[inline]
pub fn certified_t(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    filter::<true>(center, radius, ray, t_min, t_max)
        .unwrap_or_else(|Unclear| later_stages::<true>(center, radius, ray, t_min, t_max).0)
}

/// The stage that decides a case, from fast to slow.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Stage {
    /// Plain `f64` with an error bound.
    Filter,
    /// The same, after exponents have been made ordinary.
    Rescaled,
    /// Plain `f64` with better sources of digits, and bounds that grow with the numbers.
    Sharper,
    /// Integers of fixed width.
    FixedWidth,
    /// Integers of any length.
    Exact,
}

/// The stage at which [`certified_hit`] has its answer.
pub fn stage_of_hit(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Stage {
    stage::<false>(center, radius, ray, t_min, t_max)
}

/// The stage at which [`certified_t`] has its answer.
pub fn stage_of_t(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Stage {
    stage::<true>(center, radius, ray, t_min, t_max)
}

fn stage<const ULP: bool>(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Stage {
    match filter::<ULP>(center, radius, ray, t_min, t_max) {
        Ok(_) => Stage::Filter,
        Err(Unclear) => later_stages::<ULP>(center, radius, ray, t_min, t_max).1,
    }
}

/// What a stage says that has too few digits to be certain.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Unclear;

/// The first stage. `ULP` asks for a t within one ulp.
#[inline(always)]
pub(crate) fn filter<const ULP: bool>(
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

#[cold]
#[inline(never)]
fn later_stages<const ULP: bool>(
    center: Point3,
    radius: f64,
    ray: &Ray,
    t_min: f64,
    t_max: f64,
) -> (Option<f64>, Stage) {
    let by = |stage| move |t| (t, stage);
    let in_plain_numbers = if has_ordinary_exponents(center, radius, ray) {
        sharper::<ULP>(center, radius, ray, t_min, t_max).map(by(Stage::Sharper))
    } else {
        rescaled::<ULP>(center, radius, ray, t_min, t_max).map(by(Stage::Rescaled))
    };
    in_plain_numbers
        .or_else(|Unclear| {
            fixed_width(center, radius, ray, t_min, t_max).map(by(Stage::FixedWidth))
        })
        .unwrap_or_else(|Unclear| (exact(center, radius, ray, t_min, t_max), Stage::Exact))
}

/// Whether a root lies inside the range, from its gaps to both ends: each is off
/// by no more than `band` / `sqrtd`.
#[inline(always)]
pub(crate) fn lies_between(
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

/// Whether a and M are ordinary numbers.
#[inline(always)]
pub(crate) fn has_ordinary_exponents(center: Point3, radius: f64, ray: &Ray) -> bool {
    let m = (center - ray.origin).length_squared() + radius * radius;
    is_ordinary(ray.direction.length_squared()) && is_ordinary(m)
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
