//! Compensated arithmetic: what each operation rounds away is computed too, and added at the end.

use common::rtweekend::*;

use super::error_free::{c_and_differences, difference_of_products};
use super::half_b_q::nearest_by_q;

/// Finds the nearest root with `t_min` < `t` < `t_max`: as [`cross_q`](crate::cross_q) does if the
/// sphere is far, and as [`half_b_q`](crate::half_b_q) does near its surface, with a c and a cross
/// product that keep all their digits.
///
/// Cost: 1 √, 1 ÷, and some 120 + or ×, 17 of them fused: each is the call of a function, unless
/// the compiler may ask the processor to fuse. Error: that of the discriminant only, at most
/// 12u·a·M near the surface. Fails: at grazing rays, as every method must that rounds D; at
/// |d|·|oc| above 1e150 or below 1e-150. Near means that c is less than 1/32 of oc·oc: there h² is
/// at least as good a source of D as |d × oc|². Source: the products are Kahan's; their bound is
/// by Jeannerod, Louvet and Muller, 2013.
/// A radius < 0 counts by its size. NaN, ∞, a direction of 0 or an overflow: `None`.
#[inline(always)]
pub fn compensated(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let d = ray.direction;
    let (c, oc, oc_error) = c_and_differences(center, radius, ray.origin);
    let across = Vec3::new(
        difference_of_products(d.y, oc.z, d.z, oc.y),
        difference_of_products(d.z, oc.x, d.x, oc.z),
        difference_of_products(d.x, oc.y, d.y, oc.x),
    ) + d.cross(oc_error);
    let a = d.length_squared();
    let h = d.dot(oc) + d.dot(oc_error);
    let is_near = c.abs() < oc.length_squared() / 32.0;
    let discriminant = if is_near {
        h * h - a * c
    } else {
        a * (radius * radius) - across.length_squared()
    };
    nearest_by_q(a, h, c, discriminant, t_min, t_max)
}
