//! Running error bounds: each number carries how far off it can be.
//!
//! The filter has one bound for all questions, so it must be that of the worst.
//! Here the bounds are computed with the numbers, c keeps 70 digits, and the
//! discriminant comes from the cross product. All is still plain `f64`, at four or
//! five times the price of the filter. Source: Wilkinson's running error analysis,
//! in Higham, *Accuracy and Stability of Numerical Algorithms*, 2002, §3.3.

use common::rtweekend::*;

use super::filter::{U, Unclear, lies_between};
use super::refined;

/// Bound S: ĉ has the sign of c where it is more than so many times its bound.
const S_C_BAND: f64 = 2.0;

/// Bound S: the roots are computed where D̂ is more than so many times its bound.
const S_D_BAND: f64 = 16.0;

/// Whether the ray hits within the range, and where, if these bounds can tell.
///
/// They can as far as `cross_q` decides rightly, and for nearly all points that
/// rounding leaves beside a surface. A hit is left to the next stage if `ULP` asks
/// for a t within one ulp: here its last digits are not known.
pub(super) fn sharper<const ULP: bool>(
    center: Point3,
    radius: f64,
    ray: &Ray,
    t_min: f64,
    t_max: f64,
) -> Result<Option<f64>, Unclear> {
    let numbers = Sharper::of(center, radius, ray);
    let Sharper {
        h, c, discriminant, ..
    } = numbers;
    // From outside, a ray that does not turn towards the center meets nothing.
    if h <= 0.0 && c.value > S_C_BAND * c.error && t_min >= 0.0 {
        return Ok(None);
    }
    if discriminant.value < -discriminant.error {
        return Ok(None);
    }
    // From here on q is known to one part in 30.
    if discriminant.value <= S_D_BAND * discriminant.error {
        return Err(Unclear);
    }
    for root in numbers.roots() {
        let gaps = [root.t - t_min, t_max - root.t];
        if lies_between(gaps, root.scale, root.error)? {
            return if ULP { Err(Unclear) } else { Ok(Some(root.t)) };
        }
    }
    Ok(None)
}

/// A question in numbers that know how far off they are (bound S).
#[derive(Clone, Copy, Debug)]
struct Sharper {
    a: f64,
    h: f64,
    /// |d||oc|
    s: f64,
    /// c = |C − Q|² − r², with 70 digits of M.
    c: Bounded,
    /// D = a·r² − |d × oc|².
    discriminant: Bounded,
}

/// A computed number, and how far it is from the exact one at most.
#[derive(Clone, Copy, Debug)]
struct Bounded {
    /// What was computed.
    value: f64,
    /// At most so far off.
    error: f64,
}

/// A computed root, off by `error` / `scale` at most, which need not be divided.
#[derive(Clone, Copy, Debug)]
struct Quotient {
    /// The root.
    t: f64,
    /// Its error times `scale`.
    error: f64,
    /// The size of the number by which it was divided.
    scale: f64,
}

impl Sharper {
    /// The numbers of a question whose a and M are of ordinary size.
    #[inline(always)]
    fn of(center: Point3, radius: f64, ray: &Ray) -> Self {
        let oc = center - ray.origin;
        let a = ray.direction.length_squared();
        let (oc_squared, r_squared) = (oc.length_squared(), radius * radius);
        let across = ray.direction.cross(oc).length_squared();
        let s_squared = a * oc_squared;
        Self {
            a,
            h: ray.direction.dot(oc),
            s: s_squared.sqrt(),
            c: c(center, radius, ray.origin, oc_squared + r_squared),
            discriminant: discriminant(a * r_squared, across, s_squared),
        }
    }

    /// Both roots, the nearer one first, where D is more than 16 times its bound.
    #[inline(always)]
    fn roots(&self) -> impl Iterator<Item = Quotient> {
        let q = q(self.h, self.s, self.discriminant);
        let a = Bounded {
            value: self.a,
            error: 4.0 * U * self.a,
        };
        let roots = if q.value > 0.0 {
            [(self.c, q), (q, a)]
        } else {
            [(q, a), (self.c, q)]
        };
        roots
            .into_iter()
            .map(|(numerator, denominator)| quotient(numerator, denominator))
    }
}

#[inline(always)]
fn quotient(numerator: Bounded, denominator: Bounded) -> Quotient {
    let t = numerator.value / denominator.value;
    let scale = denominator.value.abs();
    let error = numerator.error + t.abs() * (denominator.error + U * scale);
    Quotient {
        t,
        // A sixteenth more: for terms in u², and the roundings of the bounds.
        error: 1.0625 * error,
        scale,
    }
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

/// D = `r` − `across`, from a·r², |d × oc|² and s = |d|²|oc|² (bound S).
#[inline(always)]
fn discriminant(r: f64, across: f64, s: f64) -> Bounded {
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
