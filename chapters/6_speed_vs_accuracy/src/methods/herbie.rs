//! Automatic rewriting: the quadratic formula as a program improved it.

use common::rtweekend::*;

use crate::method::Method;

impl Method {
    /// What a program found that rewrites formulas.
    pub const HERBIE: Self = Self::double("herbie", herbie);
}

/// The quadratic formula as it was rewritten by Herbie, a program that searches for
/// formulas that round less.
///
/// It rewrites the lesser root; the other one is that of the ray turned round. The sign
/// of D is left to the caller.
///
/// Cost: 1 √, 2 ÷, and 1 ÷ more if only the farther root is in range. Error: that of
/// [`half_b_q`](crate::half_b_q), of which the first two cases are another spelling. Fails: where that
/// does, and by the farther root at |h| above 5e126, where the third case leaves D out.
/// Herbie found that case with numbers of all exponents alike, of which b² is far from
/// 4ac if b is large. Of a ray and a sphere the two are of one size. Source: Panchekha,
/// Sanchez-Stern, Wilcox and Tatlock, *Automatically Improving Accuracy for Floating
/// Point Expressions*, 2015, §3.
#[inline]
pub fn herbie(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let b = -2.0 * ray.direction.dot(oc);
    let c = oc.length_squared() - radius * radius;
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return None;
    }
    let sqrtd = discriminant.sqrt();
    let in_range = |t: &f64| t_min < *t && *t < t_max;
    Some(lesser_root_by_herbie(a, b, c, sqrtd))
        .filter(in_range)
        .or_else(|| Some(-lesser_root_by_herbie(a, -b, c, sqrtd)).filter(in_range))
}

/// (−b − √D) / 2a, in the three cases of the paper.
#[inline]
fn lesser_root_by_herbie(a: f64, b: f64, c: f64, sqrtd: f64) -> f64 {
    if b < 0.0 {
        4.0 * a * c / (-b + sqrtd) / (2.0 * a)
    } else if b <= 1e127 {
        (-b - sqrtd) * (1.0 / (2.0 * a))
    } else {
        -b / a + c / b
    }
}
