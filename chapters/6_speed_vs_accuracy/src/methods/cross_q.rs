//! The discriminant by a cross product, without the division that a distance takes.

use common::rtweekend::*;

use super::half_b_q::nearest_by_q;

/// Finds the nearest root with `t_min` < `t` < `t_max`, with the discriminant by the identity of
/// Lagrange: (d·oc)² + |d × oc|² is |d|²·|oc|², so D = a·r² − |d × oc|².
///
/// Cost: 1 √, 1 ÷. Error of D: u·(6w·|d||oc| + 6w² + 6a·r²) with w = |d × oc|. Fails: near the surface, where c has lost its digits, and by some ten thousand ulps
/// on the book's ground. Source: the discriminant as a distance is that of Haines, Günther and
/// Akenine-Möller, *Precision Improvements for Ray/Sphere Intersection*, in Ray Tracing Gems,
/// 2019; the cross product spares its division.
/// A radius < 0 counts by its size. NaN, ∞, a direction of 0 or an overflow: `None`.
#[inline]
pub fn cross_q(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let h = ray.direction.dot(oc);
    let r_squared = radius * radius;
    let discriminant = a * r_squared - ray.direction.cross(oc).length_squared();
    let c = oc.length_squared() - r_squared;
    nearest_by_q(a, h, c, discriminant, t_min, t_max)
}
