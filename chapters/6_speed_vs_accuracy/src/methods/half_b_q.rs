//! Roots without cancellation: each of them by the division that keeps its digits.

use common::rtweekend::*;

use crate::method::Method;

impl Method {
    /// The discriminant of `half_b`, and roots that do not cancel.
    pub const HALF_B_Q: Self = Self::double("half_b_q", half_b_q);
}

/// The same discriminant; each root by the division that does not cancel.
///
/// Cost: 1 √, 1 ÷ for the root that is returned. Error: 24u·a·M in D as before,
/// but t keeps the digits that c has. Fails: where `half_b` does, save that a
/// large sphere costs no digit as long as c is exact. Source: Numerical Recipes,
/// §5.6; Forsythe, *How do you solve a quadratic equation?*, 1966.
/// A radius < 0 counts by its size. NaN, ∞, a direction of 0 or an overflow: `None`.
#[inline]
pub fn half_b_q(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let h = ray.direction.dot(oc);
    let c = oc.length_squared() - radius * radius;
    nearest_by_q(a, h, c, h * h - a * c, t_min, t_max)
}

/// The nearest root of a·t² − 2h·t + c in the range, each by the division that
/// does not cancel; divides no sooner than it must.
#[inline]
pub(crate) fn nearest_by_q(
    a: f64,
    h: f64,
    c: f64,
    discriminant: f64,
    t_min: f64,
    t_max: f64,
) -> Option<f64> {
    let [nearer, farther] = roots_by_q(a, h, c, discriminant)?;
    let root = |(numerator, denominator)| {
        let t = numerator / denominator;
        (t_min < t && t < t_max).then_some(t)
    };
    root(nearer).or_else(|| root(farther))
}

/// Both roots as numerator and denominator, the nearer one first.
///
/// The sum q = h ± √D with the sign of h cancels nothing. One root is q/a, and
/// since the product of the two is c/a, the other is c/q. Should q be 0, the
/// ray starts at a tangent's point of contact: q/a is 0 and comes first, and c/q
/// is NaN, which lies in no range.
#[inline]
fn roots_by_q(a: f64, h: f64, c: f64, discriminant: f64) -> Option<[(f64, f64); 2]> {
    if discriminant < 0.0 {
        return None;
    }
    let q = h + discriminant.sqrt().copysign(h);
    Some(if q > 0.0 {
        [(c, q), (q, a)]
    } else {
        [(q, a), (c, q)]
    })
}
