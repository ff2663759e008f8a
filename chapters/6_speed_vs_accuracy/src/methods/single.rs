//! Single precision: methods in `f32`.
//!
//! The same formulas as in `f64`, with u = 2⁻²⁴ instead of 2⁻⁵³ and exponents
//! up to 1e38: all that fails in `f64` fails here too, and much nearer. Bound D is
//! all of D at 836 radii, and in `f64` at 1.9·10⁷.

use common::rtweekend::{Point3, Ray};
use glam::Vec3;

use super::half_b_q::half_b_q;
use crate::precision::SingleRay;

/// Finds the nearest root with `t_min` < `t` < `t_max` as [`half_b`](crate::half_b) does, in `f32`.
///
/// Cost: 1 √, 1 ÷. Fails: by the decision from 10 radii on, a few times in a
/// million, and from 1000 radii on for one ray in thirty.
/// A radius < 0 counts by its size. NaN, ∞, a direction of 0 or an overflow: `None`.
#[inline]
pub fn half_b_f32(
    center: Vec3,
    radius: f32,
    ray: &SingleRay,
    t_min: f32,
    t_max: f32,
) -> Option<f32> {
    let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let h = ray.direction.dot(oc);
    let c = oc.length_squared() - radius * radius;
    let discriminant = h * h - a * c;
    if discriminant < 0.0 {
        return None;
    }
    let sqrtd = discriminant.sqrt();
    let in_range = |t: &f32| t_min < *t && *t < t_max;
    Some((h - sqrtd) / a)
        .filter(in_range)
        .or_else(|| Some((h + sqrtd) / a).filter(in_range))
}

/// Finds the nearest root with `t_min` < `t` < `t_max` by [`half_b_q`] for numbers that are stored
/// in `f32`: widens them, solves in `f64`, and rounds `t` back.
///
/// Cost: 1 √, 1 ÷ in `f64`, and the conversions. Error: one rounding of t to
/// `f32`, as long as `half_b_q` is good for 24 digits. Fails: by the decision
/// from 10⁵ radii on, a few times in a million. No exponent of an `f32` is too
/// large or too small. A root in range that rounds to an end gives way inwards.
/// A radius < 0 counts by its size. NaN, ∞ or a direction of 0: `None`.
#[inline]
pub fn widened_half_b_q_f32(
    center: Vec3,
    radius: f32,
    ray: &SingleRay,
    t_min: f32,
    t_max: f32,
) -> Option<f32> {
    let ray = Ray::new(ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let center: Point3 = center.as_dvec3();
    let t = half_b_q(center, radius.into(), &ray, t_min.into(), t_max.into())? as f32;
    if t_min < t && t < t_max {
        return Some(t);
    }
    let t = t.max(t_min.next_up()).min(t_max.next_down());
    (t_min < t && t < t_max).then_some(t)
}
