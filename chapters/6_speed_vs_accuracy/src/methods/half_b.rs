//! The quadratic formula as the lesson has it, with half of b.

use common::rtweekend::*;

/// Finds the nearest root with `t_min` < `t` < `t_max` as chapter 5 does, to the bit, and makes no
/// record of the hit.
///
/// Cost: 1 √, 1 ÷, and a second ÷ if only the farther root is in range. Error: bound
/// [`D`](crate::bounds::D), and with it about 12u·M/√D in t. Fails: by the decision, once in a million from 10⁵ radii away, and a hundred times as often with each
/// factor of ten; by the digits of t near the surface and above a large sphere, where h − √D
/// cancels; at |d|·|oc| above 1e154 or below 1e-154. Source: the book, chapter 6.2.
/// A radius < 0 counts by its size. NaN, ∞, a direction of 0 or an overflow: `None`.
#[inline]
pub fn half_b(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let h = ray.direction.dot(oc);
    let c = oc.length_squared() - radius * radius;
    let discriminant = h * h - a * c;
    if discriminant < 0.0 {
        return None;
    }
    let sqrtd = discriminant.sqrt();
    let in_range = |t: &f64| t_min < *t && *t < t_max;
    Some((h - sqrtd) / a)
        .filter(in_range)
        .or_else(|| Some((h + sqrtd) / a).filter(in_range))
}
