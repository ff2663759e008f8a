//! Filtered predicates: answers that are proven, ray by ray, while they are computed.
//!
//! A filter computes as `half_b_q` does, and knows how far off it can be. Nearly
//! always that is enough. If not, the question is asked again in integers, where
//! nothing is rounded. So the answer is right for every input, and nearly as fast
//! as one that is not.
//!
//! Each bound is proven in the book, in `proofs.md`, under the letter that stands
//! beside it here. The proofs assume that operations round to nearest and that
//! tiny results are not flushed to zero. Source of the idea: Shewchuk, *Adaptive
//! Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates*,
//! 1997.

mod exact;
mod filter;
mod fixed_width;
mod refined;

use common::rtweekend::*;
use glam::Vec3 as SingleVec3;

use crate::method::Method;
use crate::methods::widened;
use crate::precision::SingleRay;
use filter::Unclear;
pub(crate) use filter::filter;
use fixed_width::fixed_width;

pub(crate) use exact::comes_before;
pub use exact::{exact, exact_discriminant};

impl Method {
    /// The decision is certain, the digits of t are those of `half_b_q`.
    pub const CERTIFIED_HIT: Self = Self {
        is_certified: true,
        ..Self::double("certified_hit", certified_hit)
    };

    /// The decision is certain, and so are the digits of t.
    pub const CERTIFIED_T: Self = Self {
        is_certified: true,
        ..Self::double("certified_t", certified_t)
    };

    /// Input in `f32`; the decision is certain, and so is the last digit of t.
    pub const CERTIFIED_F32: Self = Self {
        is_certified: true,
        ..Self::single("certified_f32", certified_f32)
    };
}

/// Whether the ray hits within the range is right for every input, and so is the
/// choice between the two roots.
///
/// Cost: 1 √, 1 ÷, and a few + and × more than `half_b_q`. Some thirty times as much
/// where `half_b_q` could decide wrongly, because the sphere is far, or the ray starts
/// on its surface or nearly touches it; and that of [`exact`] if lengths differ by a
/// factor of 2⁶⁷. Error of t: that of `half_b_q`, and half an ulp where integers were
/// asked. Fails: never. Input that is infinite or NaN is a miss,
/// and so is every range between whose ends no `f64` lies.
#[inline]
pub fn certified_hit(
    center: Point3,
    radius: f64,
    ray: &Ray,
    t_min: f64,
    t_max: f64,
) -> Option<f64> {
    staged::<false>(center, radius, ray, t_min, t_max).0
}

/// As [`certified_hit`], and `t` is within one ulp of the exact root.
///
/// Cost: that of `certified_hit`, and for a hit 1 ÷ and 90 + or × more. Integers
/// are asked also if D or c is small: from some 250 radii away, and close to the
/// surface. Error: less than 0.8 ulp is proven. As with [`exact`], a root
/// beyond the largest `f64` becomes that. Fails: never.
/// A radius < 0 counts by its size. NaN, ∞ or a direction of 0: `None`.
#[inline]
pub fn certified_t(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    staged::<true>(center, radius, ray, t_min, t_max).0
}

/// [`certified_t`] on numbers that are stored in `f32`.
///
/// The decision is right for every input, and so is the choice between the roots.
/// Cost: that of `certified_t`, and the conversions. Error: less than 0.51 ulp of an
/// `f32`, before a root in range that rounds to an end gives way inwards. Fails:
/// never. A filter in `f32` would be silent from 600 radii on, 48u·a·M being all of
/// D there, and for the last digit of t it takes wider numbers anyway: so they are
/// widened first.
/// A radius < 0 counts by its size. NaN, ∞ or a direction of 0: `None`.
#[inline]
pub fn certified_f32(
    center: SingleVec3,
    radius: f32,
    ray: &SingleRay,
    t_min: f32,
    t_max: f32,
) -> Option<f32> {
    widened(certified_t, center, radius, ray, t_min, t_max)
}

/// The stage that decides a case, from fast to slow.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Stage {
    /// Plain `f64` with an error bound.
    Filter,
    /// Integers of fixed width.
    FixedWidth,
    /// Integers of any length.
    Exact,
}

/// The stage at which [`certified_hit`] has its answer.
pub fn stage_of_hit(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Stage {
    staged::<false>(center, radius, ray, t_min, t_max).1
}

/// The answer, and the stage that has it.
#[inline(always)]
fn staged<const ULP: bool>(
    center: Point3,
    radius: f64,
    ray: &Ray,
    t_min: f64,
    t_max: f64,
) -> (Option<f64>, Stage) {
    let t = filter::<ULP>(center, radius, ray, t_min, t_max);
    if t.is_nan() {
        // A copy: a ray whose address is asked for would be kept in memory, and the
        // filter would wait until one that was just made is written there.
        let ray = Ray::new(ray.origin, ray.direction);
        return later_stages(center, radius, &ray, t_min, t_max);
    }
    ((t < f64::INFINITY).then_some(t), Stage::Filter)
}

#[cold]
#[inline(never)]
pub(crate) fn later_stages(
    center: Point3,
    radius: f64,
    ray: &Ray,
    t_min: f64,
    t_max: f64,
) -> (Option<f64>, Stage) {
    match fixed_width(center, radius, ray, t_min, t_max) {
        Ok(t) => (t, Stage::FixedWidth),
        Err(Unclear) => (exact(center, radius, ray, t_min, t_max), Stage::Exact),
    }
}
