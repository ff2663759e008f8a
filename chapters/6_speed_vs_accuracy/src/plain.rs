//! Floating point, plain `f64`: each method rounds as it goes and hopes for the best.
//!
//! In what is said about errors, u = 2⁻⁵³ is the largest relative error of one
//! operation, and M = oc·oc + r². What a method costs is counted in √ and ÷,
//! which take several times as long as + and ×.

use common::rtweekend::*;
use hittable_list::{Hittable, Sphere};

use crate::error_free;

/// The full quadratic formula of chapter 3; the farther root is the nearer one
/// of the ray turned round, to the bit.
///
/// Cost: 1 √, 1 ÷, and both again if only the farther root is in range.
/// Error: that of [`half_b`], to the bit, because b is h with a factor of two
/// that never rounds. Fails: where `half_b` does, and a factor of two earlier
/// for want of exponents. Source: equations (12)–(15) of the notes.
#[inline]
pub fn full_b(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let in_range = |t: &f64| t_min < *t && *t < t_max;
    let nearer = normals::hit_sphere(center, radius, ray)?;
    Some(nearer).filter(in_range).or_else(|| {
        let turned = Ray::new(ray.origin, -ray.direction);
        normals::hit_sphere(center, radius, &turned)
            .map(|t| -t)
            .filter(in_range)
    })
}

/// Half of b: what chapter 5 does.
///
/// Cost: 1 √, 1 ÷, and a second ÷ if only the farther root is in range.
/// Error: 24u·a·M in D, and with it about 12u·M/√D in t. Fails: by the decision,
/// once in a million from 10⁵ radii away, and a hundred times as often with each
/// factor of ten; by the digits of t near the surface and above a large sphere,
/// where h − √D cancels; at |d|·|oc| above 1e154 or below 1e-154. Source: the
/// book, chapter 6.2.
#[inline]
pub fn half_b(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    Sphere::new(center, radius.abs())
        .hit(ray, t_min, t_max)
        .map(|hit| hit.t)
}

/// The same discriminant; each root by the division that does not cancel.
///
/// Cost: 1 √, 1 ÷ for the root that is returned. Error: 24u·a·M in D as before,
/// but t keeps the digits that c has. Fails: where `half_b` does, save that a
/// large sphere costs no digit as long as c is exact. Source: Numerical Recipes,
/// §5.6; Forsythe, *How do you solve a quadratic equation?*, 1966.
#[inline]
pub fn half_b_q(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let h = ray.direction.dot(oc);
    let c = oc.length_squared() - radius * radius;
    nearest_by_q(a, h, c, h * h - a * c, t_min, t_max)
}

/// The discriminant from the point of the line that is nearest to the center:
/// D/a is r² less the square of its distance.
///
/// Cost: 1 √, 1 ÷, both roots included; the ÷ is paid by misses too. Error of
/// D/a: u·(4l·|oc| + 8l² + 2r²) with l the distance. Fails: by the decision,
/// twice in a million from 10¹¹ radii away, and ten times as often with each factor
/// of ten; by the digits of t above a large sphere, where the root cancels and h/a
/// has been rounded: worse than `half_b` on the book's own ground. Source: Haines, Günther and Akenine-Möller, *Precision Improvements
/// for Ray/Sphere Intersection*, in Ray Tracing Gems, 2019; Hearn and Baker.
#[inline]
pub fn haines(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let oc = center - ray.origin;
    let per_a = 1.0 / ray.direction.length_squared();
    let middle = ray.direction.dot(oc) * per_a;
    let across = oc - middle * ray.direction;
    let discriminant_per_a = radius * radius - across.length_squared();
    if discriminant_per_a < 0.0 {
        return None;
    }
    let half_chord = (discriminant_per_a * per_a).sqrt();
    let in_range = |t: &f64| t_min < *t && *t < t_max;
    Some(middle - half_chord)
        .filter(in_range)
        .or_else(|| Some(middle + half_chord).filter(in_range))
}

/// The discriminant of [`haines`], the roots of [`half_b_q`]: what Ray Tracing
/// Gems recommends.
///
/// Cost: 1 √, 2 ÷, of which misses pay one. Error: that of `haines` in D, that
/// of c in a root near the origin. Fails: near the surface, where c has lost its
/// digits; on the book's ground its worst t is a hundred times worse than that
/// of `half_b_q`. Source: as `haines`.
#[inline]
pub fn haines_q(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let h = ray.direction.dot(oc);
    let r_squared = radius * radius;
    let across = oc - (h / a) * ray.direction;
    let discriminant = a * (r_squared - across.length_squared());
    let c = oc.length_squared() - r_squared;
    nearest_by_q(a, h, c, discriminant, t_min, t_max)
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

/// The discriminant by the identity of Lagrange: (d·oc)² + |d × oc|² is
/// |d|²·|oc|², so D = a·r² − |d × oc|², without the division of [`haines_q`].
///
/// Cost: 1 √, 1 ÷. Error of D: u·(6w·|d||oc| + 6w² + 6a·r²) with w = |d × oc|: at
/// small far spheres it decides as [`haines`] does. Fails: near the surface, where c
/// has lost its digits, and by some ten thousand ulps on the book's ground.
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

/// [`cross_q`] where the sphere is far, and near its surface [`half_b_q`] with a
/// c that has all its digits.
///
/// Cost: 1 √, 1 ÷, and near the surface some 110 + or × more. Error: that of
/// the discriminant only, 24u·a·M near the surface. Fails: at grazing rays, as
/// every method must that rounds D; at |d|·|oc| above 1e150 or below 1e-150.
/// Near means that c is less than 1/32 of oc·oc: there h² is at least as good a
/// source of D as |d × oc|², and c begins to lose digits.
#[inline]
pub fn adaptive_q(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let oc = center - ray.origin;
    let c = oc.length_squared() - radius * radius;
    if c.abs() >= oc.length_squared() / 32.0 {
        return cross_q(center, radius, ray, t_min, t_max);
    }
    let a = ray.direction.length_squared();
    let h = ray.direction.dot(oc);
    let c = error_free::c(center, radius, ray.origin);
    nearest_by_q(a, h, c, h * h - a * c, t_min, t_max)
}

/// [`half_b_q`] after the lengths, and the direction, have been brought near 1
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

/// The quadratic formula as it was rewritten by Herbie, a program that searches for
/// formulas that round less.
///
/// It rewrites the lesser root; the other one is that of the ray turned round. The sign
/// of D is left to the caller.
///
/// Cost: 1 √, 2 ÷, and 1 ÷ more if only the farther root is in range. Error: that of
/// [`half_b_q`], of which the first two cases are another spelling. Fails: where that
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

/// The nearest root of a·t² − 2h·t + c in the range, each by the division that
/// does not cancel.
#[inline]
fn nearest_by_q(a: f64, h: f64, c: f64, discriminant: f64, t_min: f64, t_max: f64) -> Option<f64> {
    nearest_of(roots_by_q(a, h, c, discriminant)?, |t| t, t_min, t_max)
}

/// Both roots as numerator and denominator, the nearer one first.
///
/// The sum q = h ± √D with the sign of h cancels nothing. One root is q/a, and
/// since the product of the two is c/a, the other is c/q. Should q be 0, the
/// ray starts at a tangent's point of contact: q/a is 0 and comes first, and c/q
/// is NaN, which lies in no range.
#[inline]
pub(crate) fn roots_by_q(a: f64, h: f64, c: f64, discriminant: f64) -> Option<[(f64, f64); 2]> {
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

/// The first of two fractions that lies in the range; divides no sooner than it
/// must.
#[inline]
fn nearest_of(
    [nearer, farther]: [(f64, f64); 2],
    unscaled: impl Fn(f64) -> f64,
    t_min: f64,
    t_max: f64,
) -> Option<f64> {
    let root = |(numerator, denominator)| {
        let t = unscaled(numerator / denominator);
        (t_min < t && t < t_max).then_some(t)
    };
    root(nearer).or_else(|| root(farther))
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
