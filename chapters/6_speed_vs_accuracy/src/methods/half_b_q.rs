//! Roots without cancellation: each of them by the division that keeps its digits.

use common::rtweekend::*;

/// Finds the nearest root with `t_min` < `t` < `t_max`, with the discriminant of `half_b` and each
/// root by a division in which nothing cancels; only the root that is returned is divided. Of all
/// methods, the one to begin with.
///
/// Cost: 1 √, 1 ÷; neither for a miss, or a ray from outside that turns away. Error: bound
/// [`D`](crate::bounds::D) as with `half_b`; but t keeps the digits that c has. Fails: where
/// `half_b` does, save that a large sphere costs no digit as long as c is exact. Source: Numerical
/// Recipes, §5.6; Forsythe, *How do you solve a quadratic equation?*, 1966.
/// A radius < 0 counts by its size. NaN, ∞, a direction of 0 or an overflow: `None`.
#[inline]
pub fn half_b_q(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let h = ray.direction.dot(oc);
    let c = oc.length_squared() - radius * radius;
    nearest_by_q(a, h, c, h * h - a * c, t_min, t_max)
}

/// Finds the nearest root of a·t² − 2h·t + c in the range, by one division.
///
/// The sum q = h ± √D with the sign of h cancels nothing. One root is q/a, and since the product
/// of the two is c/a, the other is c/q. Which of them is before `t_min` is asked before it is
/// divided: with both sides times its denominator, which is not negative. One that rounding could
/// take to `t_min` itself counts as before, so that the farther root is not lost with it.
#[inline]
pub(crate) fn nearest_by_q(
    a: f64,
    h: f64,
    c: f64,
    discriminant: f64,
    t_min: f64,
    t_max: f64,
) -> Option<f64> {
    let turns_away = h <= 0.0 && c > 0.0 && t_min >= 0.0;
    // What is divided by a q that overflows would be 0.
    if !(0.0..f64::INFINITY).contains(&discriminant) || turns_away {
        return None;
    }
    let q = h + discriminant.sqrt().copysign(h);
    let c_is_nearer = q > 0.0;
    let (numerator, denominator) = if c_is_nearer { (c, q) } else { (q, a) };
    let start = t_min * denominator;
    let is_before = numerator <= start + f64::EPSILON * start.abs();
    let takes_c = c_is_nearer != is_before;
    let (numerator, denominator) = if takes_c { (c, q) } else { (q, a) };
    let t = numerator / denominator;
    (t_min < t && t < t_max).then_some(t)
}
