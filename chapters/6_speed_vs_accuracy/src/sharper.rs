//! Running error bounds: each number carries how far off it can be.
//!
//! The filter has one bound for all questions, so it must be that of the worst.
//! Here the bounds are computed with the numbers, c keeps 70 digits, and the
//! discriminant comes from the cross product. All is still plain `f64`, at four or
//! five times the price of the filter. Source: Wilkinson's running error analysis,
//! in Higham, *Accuracy and Stability of Numerical Algorithms*, 2002, §3.3.

use common::rtweekend::*;

use crate::certified::{U, Unclear, lies_between};
use crate::refined;

/// Whether the ray hits within the range, and where, if these bounds can tell.
///
/// They can as far as `cross_q` decides rightly, and for nearly all points that
/// rounding leaves beside a surface. A hit is left to the next stage if `ULP` asks
/// for a t within one ulp: here its last digits are not known.
pub(crate) fn sharper<const ULP: bool>(
    center: Point3,
    radius: f64,
    ray: &Ray,
    t_min: f64,
    t_max: f64,
) -> Result<Option<f64>, Unclear> {
    let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let (oc_squared, r_squared) = (oc.length_squared(), radius * radius);
    let m = oc_squared + r_squared;
    let h = ray.direction.dot(oc);
    let c = c(center, radius, ray.origin, m);
    // From outside, a ray that does not turn towards the center meets nothing.
    if h <= 0.0 && c.value > 2.0 * c.error && t_min >= 0.0 {
        return Ok(None);
    }
    let across = ray.direction.cross(oc).length_squared();
    let discriminant = discriminant(a, r_squared, across, oc_squared);
    if discriminant.value < -discriminant.error {
        return Ok(None);
    }
    // From here on q is known to one part in 30.
    if discriminant.value <= 16.0 * discriminant.error {
        return Err(Unclear);
    }
    let q = q(h, (a * oc_squared).sqrt(), discriminant);
    let a = Bounded {
        value: a,
        error: 4.0 * U * a,
    };
    let roots = if q.value > 0.0 {
        [(c, q), (q, a)]
    } else {
        [(q, a), (c, q)]
    };
    for (numerator, denominator) in roots {
        let t = numerator.value / denominator.value;
        let (error, scale) = error_of_quotient(t, numerator, denominator);
        if lies_between([t - t_min, t_max - t], scale, error)? {
            return if ULP { Err(Unclear) } else { Ok(Some(t)) };
        }
    }
    Ok(None)
}

/// A computed number, and how far it is from the exact one at most.
#[derive(Clone, Copy)]
struct Bounded {
    value: f64,
    error: f64,
}

/// The error of t = `numerator` / `denominator` as a fraction, which need not be divided.
#[inline(always)]
fn error_of_quotient(t: f64, numerator: Bounded, denominator: Bounded) -> (f64, f64) {
    let size = denominator.value.abs();
    let error = numerator.error + t.abs() * (denominator.error + U * size);
    // A sixteenth more: for terms in u², and the roundings of the bounds.
    (1.0625 * error, size)
}

/// c = |C − Q|² − r² with 70 digits of M (bound S).
#[inline(always)]
fn c(center: Point3, radius: f64, origin: Point3, m: f64) -> Bounded {
    let value = refined::c(center, radius, origin, m);
    Bounded {
        value,
        error: 2.0 * U * (value.abs() + m / 1_048_576.0),
    }
}

/// D = a·r² − |d × oc|², from |d × oc|² and oc·oc (bound S).
#[inline(always)]
fn discriminant(a: f64, r_squared: f64, across: f64, oc_squared: f64) -> Bounded {
    let (r, s) = (a * r_squared, a * oc_squared);
    let size = across.sqrt() * s.sqrt() + across + r;
    Bounded {
        value: r - across,
        error: 8.0 * U * size + 32.0 * U * U * s,
    }
}

/// q = h ± √D with the sign of h (bound S); the error of h is counted in `s` = |d||oc|.
#[inline(always)]
fn q(h: f64, s: f64, discriminant: Bounded) -> Bounded {
    let root = discriminant.value.sqrt();
    let value = h + root.copysign(h);
    Bounded {
        value,
        error: U * (5.0 * s + 3.0 * value.abs()) + 0.75 * discriminant.error / root,
    }
}
