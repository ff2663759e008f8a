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
    // From here on q is known to one part in 20.
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
    /// c = |C − Q|² − r², with 70 digits of M; off by u·|c| besides.
    c: Bounded,
    /// D = a·r² − |d × oc|²; off by 6u·|D| besides.
    discriminant: Bounded,
}

/// A computed number, and how far it is from the exact one at most. What is off by a few
/// u of itself keeps its sign: that is counted where it ends, in the roots.
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
        let (w, s) = (across.sqrt(), (a * oc_squared).sqrt());
        let m = oc_squared + r_squared;
        Self {
            a,
            h: ray.direction.dot(oc),
            c: Bounded {
                value: refined::c(center, radius, ray.origin, m),
                error: U * m / 524_288.0,
            },
            discriminant: Bounded {
                value: a * r_squared - across,
                error: U * s * (20.0 * w + 64.0 * U * s),
            },
        }
    }

    /// Both roots, the nearer one first, where D is more than 16 times its bound.
    #[inline(always)]
    fn roots(&self) -> [Quotient; 2] {
        let root = self.discriminant.value.sqrt();
        let q = self.h + root.copysign(self.h);
        // All that is off by a few u of itself, here and in both roots, is 15u·|q| at most.
        let error = 16.0 * U * q.abs() + 0.75 * self.discriminant.error / root;
        let over_a = quotient(q, self.a, error);
        let t = self.c.value / q;
        let under_q = quotient(self.c.value, q, self.c.error + t.abs() * error);
        if q > 0.0 {
            [under_q, over_a]
        } else {
            [over_a, under_q]
        }
    }
}

/// A sixteenth more than the `error`: for terms in u², and the roundings of the bounds.
#[inline(always)]
fn quotient(numerator: f64, denominator: f64, error: f64) -> Quotient {
    Quotient {
        t: numerator / denominator,
        error: 1.0625 * error,
        scale: denominator.abs(),
    }
}
