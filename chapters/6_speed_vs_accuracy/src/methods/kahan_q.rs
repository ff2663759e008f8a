//! Kahan's difference of products: an accurate discriminant of rounded coefficients.

use common::rtweekend::*;

use super::error_free;
use super::half_b_q::nearest_by_q;
use crate::method::Method;

impl Method {
    /// The difference h² − a·c, rounded once or twice only.
    pub const KAHAN_Q: Self = Self::double("kahan_q", kahan_q);
}

/// The discriminant h² − a·c as if it had been rounded once or twice only.
///
/// Cost: 1 √, 1 ÷, and some 30 + or × for the discriminant, because the products
/// are exact: with a fused multiply-add it would be 4, but a program for any
/// processor calls a function for that. Error: 2 ulps in D for the coefficients
/// as they are. They were rounded before, so what is left is still about
/// 20u·a·M. Fails: where `half_b_q` does, nearly as early. Source: Kahan, *On
/// the Cost of Floating-Point Computation Without Extra-Precise Arithmetic*, 2004;
/// `quadratic_roots` of Boost.Math is the same but for the last bits.
#[inline]
pub fn kahan_q(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let h = ray.direction.dot(oc);
    let c = oc.length_squared() - radius * radius;
    let discriminant = error_free::difference_of_products(h, h, a, c);
    nearest_by_q(a, h, c, discriminant, t_min, t_max)
}
