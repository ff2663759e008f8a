//! Scaling by powers of two, against overflow and underflow.

use common::rtweekend::*;

use super::half_b_q::{nearest_of, roots_by_q};
use crate::method::Method;

impl Method {
    /// Exponents near 0 before anything else.
    pub const SCALED_Q: Self = Self {
        any_exponent: true,
        ..Self::double("scaled_q", scaled_q)
    };
}

/// [`half_b_q`](crate::half_b_q) after the lengths, and the direction, have been brought near 1
/// by powers of two, which do not round.
///
/// Cost: 1 √, 1 ÷, and the scaling of seven numbers. Error: that of `half_b_q`.
/// Fails: where that does, but not for want of exponents, as long as C − Q does
/// not overflow. Source: Goualard, *The Ins and Outs of Solving Quadratic
/// Equations with Floating-Point Arithmetic*, 2023, after Sterbenz.
#[inline]
pub fn scaled_q(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let oc = center - ray.origin;
    let length = exponent(oc.abs().max_element().max(radius.abs()));
    let direction = exponent(ray.direction.abs().max_element());
    let (oc, radius) = (oc * two_to(-length), radius * two_to(-length));
    let d = ray.direction * two_to(-direction);

    let a = d.length_squared();
    let h = d.dot(oc);
    let c = oc.length_squared() - radius * radius;
    // t counts lengths of d: it grows with the one and shrinks with the other.
    // In two steps, because 2^(length − direction) need not be a number.
    let (shift, half) = (length - direction, (length - direction) / 2);
    let unscaled = |t: f64| t * two_to(half) * two_to(shift - half);
    nearest_of(roots_by_q(a, h, c, h * h - a * c)?, unscaled, t_min, t_max)
}

/// The exponent of the power of two not above `x` > 0, kept within ±1000 so
/// that [`two_to`] has it with either sign.
#[inline]
pub(crate) fn exponent(x: f64) -> i32 {
    let field = (x.to_bits() >> 52) as i32;
    (field - 1023).clamp(-1000, 1000)
}

/// 2 to the power `exponent`, from −1022 to 1023.
#[inline]
pub(crate) fn two_to(exponent: i32) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}
