//! Exact integer arithmetic: nothing rounds until the last step.
//!
//! A finite `f64` is an integer times a power of two. Counted in one common
//! power, the coefficients of a·t² − 2h·t + c = 0 are integers, and whether a
//! root lies before or behind some number x is a question about the signs of
//! integers: those of a·x² − 2h·x + c and of a·x − h. No root has to be known
//! for that. So `t` may be guessed by any means; signs prove it.

use std::cmp::Ordering;

use common::rtweekend::*;
use dashu_int::ops::{Abs, BitTest, SquareRoot};
use dashu_int::{IBig, UBig};

/// Finds the nearest root with `t_min` < `t` < `t_max`, decided exactly and rounded once.
///
/// Cost: a few hundred times that of `half_b`, more for numbers of very
/// different size. Error: half an ulp. Fails: never. A root that is in range
/// but rounds to an end of it gives way to the next number inwards: a root
/// beyond the largest `f64` becomes that, and one too small to be told from
/// `t_min` = 0 the least. If no `f64` lies between the ends, if a number
/// is infinite or NaN, or if the direction is zero, it is a miss.
pub fn exact(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let quadratic = IntegerQuadratic::new(center, radius, ray)?;
    let root = quadratic.nearest_root_in(t_min, t_max)?;
    inwards(quadratic.rounded(root), t_min, t_max)
}

/// Computes the discriminant D = h² − a·c of a ray and a sphere exactly, and rounds it once.
///
/// D is in squared lengths of the scene times squared lengths of the direction. Error: an ulp,
/// unless D is beyond the normal numbers. Returns `None` if a number is infinite or NaN.
pub fn exact_discriminant(center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
    let ([a, h, c], units) = coefficients(center, radius, ray)?;
    let unit = 2 * units.iter().sum::<i64>();
    Some(quotient(&(&h * &h - a * c), &IBig::ONE, unit))
}

/// Returns true if the nearest root in the range on the first of two spheres is
/// less than that on the second; false if they are equal, or one of them has
/// none.
///
/// Cost: about twice that of [`exact`]. Rounds: nothing.
pub(crate) fn comes_before(spheres: [(Point3, f64); 2], ray: &Ray, t_min: f64, t_max: f64) -> bool {
    let [Some((first, root)), Some((second, of_second))] = spheres.map(|(center, radius)| {
        let quadratic = IntegerQuadratic::new(center, radius, ray)?;
        let root = quadratic.nearest_root_in(t_min, t_max)?;
        Some((quadratic, root))
    }) else {
        return false;
    };
    first.compare_roots(root, &second, of_second) == Ordering::Less
}

/// Returns `t`, or the next number inwards if it is not between the ends; `None`
/// if there is no number between them.
pub(super) fn inwards(t: f64, t_min: f64, t_max: f64) -> Option<f64> {
    let inside = t.max(t_min.next_up()).min(t_max.next_down());
    (t_min < inside && inside < t_max).then_some(inside)
}

/// The equation a·t² − 2h·t + c = 0 with integer coefficients, which has roots.
struct IntegerQuadratic {
    a: IBig,
    h: IBig,
    c: IBig,
    /// D = h² − a·c, at least 0.
    discriminant: UBig,
    /// The exponent of two of the unit in which `t` is counted.
    unit: i64,
}

#[derive(Clone, Copy)]
enum Root {
    /// (h − √D) / a
    Nearer,
    /// (h + √D) / a
    Farther,
}

impl IntegerQuadratic {
    /// Makes the equation of a ray and a sphere; returns `None` if it has no root, the direction is
    /// 0, or a number is not finite.
    fn new(center: Point3, radius: f64, ray: &Ray) -> Option<Self> {
        let ([a, h, c], [unit_of_length, unit_of_direction]) = coefficients(center, radius, ray)?;
        let discriminant = UBig::try_from(&h * &h - &a * &c).ok()?;
        (a != IBig::ZERO).then_some(Self {
            a,
            h,
            c,
            discriminant,
            unit: unit_of_length - unit_of_direction,
        })
    }

    /// Returns the nearer root if it lies between the ends, else the farther one if that does, else
    /// `None`.
    fn nearest_root_in(&self, t_min: f64, t_max: f64) -> Option<Root> {
        [Root::Nearer, Root::Farther].into_iter().find(|&root| {
            self.compare(root, t_min) == Some(Ordering::Greater)
                && self.compare(root, t_max) == Some(Ordering::Less)
        })
    }

    /// Compares this root with a root of another sphere on the same ray.
    ///
    /// Both are h ± √D over one a, so it is the sign of h₁ − h₂ ± √D₁ against
    /// ±√D₂ that counts. To square keeps an order if signs are kept: each number
    /// x is here replaced by x·|x|, its signed square, until no √ is left.
    fn compare_roots(&self, root: Root, other: &Self, of_other: Root) -> Ordering {
        let unit = self.unit.min(other.unit);
        let [(h, sqrtd), (of_other, other_sqrtd)] =
            [(self, root), (other, of_other)].map(|(of, root)| of.parts(root, unit));
        let gap = signed_square(&(h - of_other));
        let sign = (&gap + &sqrtd).signum();
        let rest = &sign * ((&gap).abs() + (&sqrtd).abs()) - other_sqrtd;
        let left: IBig = signed_square(&rest) + 4 * sign * gap * sqrtd;
        left.cmp(&IBig::ZERO)
    }

    /// Returns h and the signed square of ±√D, of which this root is the sum over
    /// a, both counted in a finer unit of `t`.
    fn parts(&self, root: Root, unit: i64) -> (IBig, IBig) {
        let finer = distance(self.unit, unit);
        let square = IBig::from(&self.discriminant << (2 * finer));
        let signed = match root {
            Root::Nearer => -square,
            Root::Farther => square,
        };
        (&self.h << finer, signed)
    }

    /// Compares the root with `x`, which may be infinite; returns `None` if `x` is NaN.
    fn compare(&self, root: Root, x: f64) -> Option<Ordering> {
        if x.is_finite() {
            let (mantissa, exponent) = split(x);
            Some(self.compare_dyadic(root, mantissa, exponent))
        } else {
            0.0.partial_cmp(&x)
        }
    }

    /// Compares the root with x = `mantissa` · 2^`exponent`.
    ///
    /// The parabola a·x² − 2h·x + c is below zero between the roots and above it
    /// on either side; its slope a·x − h tells on which.
    fn compare_dyadic(&self, root: Root, mantissa: i64, exponent: i64) -> Ordering {
        let common = exponent.min(self.unit);
        let x = IBig::from(mantissa) << distance(exponent, common);
        let finer = distance(self.unit, common);
        let h = &self.h << finer;
        let slope = &self.a * &x - &h;
        let value = x * (&slope - h) + (&self.c << (2 * finer));
        match (value.cmp(&IBig::ZERO), root) {
            (Ordering::Greater, _) => IBig::ZERO.cmp(&slope),
            (Ordering::Equal, Root::Nearer) => IBig::ZERO.cmp(&slope).min(Ordering::Equal),
            (Ordering::Equal, Root::Farther) => IBig::ZERO.cmp(&slope).max(Ordering::Equal),
            (Ordering::Less, Root::Nearer) => Ordering::Less,
            (Ordering::Less, Root::Farther) => Ordering::Greater,
        }
    }

    /// Returns the `f64` nearest to the root, ties to even: the guess, moved
    /// until the root lies between the two points half-way to its neighbors.
    fn rounded(&self, root: Root) -> f64 {
        let mut t = self.guess(root).clamp(f64::MIN, f64::MAX);
        while t < f64::MAX && self.rounds_away(root, t, t.next_up(), Ordering::Greater) {
            t = t.next_up();
        }
        while t > f64::MIN && self.rounds_away(root, t, t.next_down(), Ordering::Less) {
            t = t.next_down();
        }
        t
    }

    /// Returns true if the root rounds to something on the side of `neighbor`,
    /// which is the next number on the side `toward` of `t`.
    fn rounds_away(&self, root: Root, t: f64, neighbor: f64, toward: Ordering) -> bool {
        let inner = if t.abs() < neighbor.abs() {
            t
        } else {
            neighbor
        };
        let (mantissa, exponent) = split(inner.abs());
        let half_way = 2 * mantissa + 1;
        let half_way = if t + neighbor < 0.0 {
            -half_way
        } else {
            half_way
        };
        let side = self.compare_dyadic(root, half_way, exponent - 1);
        side == toward || (side == Ordering::Equal && t.to_bits() % 2 == 1)
    }

    /// Computes the root to about 60 binary digits and rounds it to 53: as in `half_b_q`, with q =
    /// h ± √D, of which nothing cancels.
    fn guess(&self, root: Root) -> f64 {
        let more = 70_usize.saturating_sub(self.h.bit_len().max(self.discriminant.bit_len() / 2));
        let sqrtd = IBig::from((&self.discriminant << (2 * more)).sqrt());
        let h_is_positive = self.h >= IBig::ZERO;
        let magnitude = ((&self.h).abs() << more) + sqrtd;
        let q = if h_is_positive { magnitude } else { -magnitude };
        if q == IBig::ZERO {
            return 0.0;
        }
        if h_is_positive == matches!(root, Root::Nearer) {
            quotient(&(&self.c << more), &q, self.unit)
        } else {
            quotient(&q, &(&self.a << more), self.unit)
        }
    }
}

/// Returns a, h and c as integers, and the exponents of the two units that they are counted in: of
/// length, of which c has two and h one, and of the direction, of which a has two and h one. `None`
/// if a number is not finite.
fn coefficients(center: Point3, radius: f64, ray: &Ray) -> Option<([IBig; 3], [i64; 2])> {
    let ([cx, cy, cz], [qx, qy, qz]) = (center.to_array(), ray.origin.to_array());
    let ([cx, cy, cz, qx, qy, qz, r], unit_of_length) = integers([cx, cy, cz, qx, qy, qz, radius])?;
    let (d, unit_of_direction) = integers(ray.direction.to_array())?;
    let oc = [cx - qx, cy - qy, cz - qz];
    let (a, h) = (dot(&d, &d), dot(&d, &oc));
    let c = dot(&oc, &oc) - &r * &r;
    Some(([a, h, c], [unit_of_length, unit_of_direction]))
}

/// Computes n / d times 2^`exponent`, to within an ulp.
fn quotient(n: &IBig, d: &IBig, exponent: i64) -> f64 {
    let shift = 66 + d.bit_len() as i64 - n.bit_len() as i64;
    let digits = if shift > 0 {
        (n << shift as usize) / d
    } else {
        n / (d << shift.unsigned_abs() as usize)
    };
    let mut t = digits.to_f64().value();
    // In steps, because two to the exponent alone may be too large or small.
    let mut left = (exponent - shift).clamp(-2400, 2400);
    while left != 0 {
        let step = left.clamp(-1000, 1000);
        t *= f64::from_bits(((1023 + step) as u64) << 52);
        left -= step;
    }
    t
}

/// Returns the values as integers times one power of two, and its exponent; `None` if one is not
/// finite.
fn integers<const N: usize>(values: [f64; N]) -> Option<([IBig; N], i64)> {
    if values.iter().any(|value| !value.is_finite()) {
        return None;
    }
    let parts = values.map(|value| {
        let (mantissa, exponent) = split(value);
        // Trailing zeros go, so that the unit is large and the integers short.
        let zeros = mantissa.trailing_zeros() % 64;
        (mantissa >> zeros, exponent + i64::from(zeros))
    });
    let exponents = parts
        .iter()
        .filter(|&&(mantissa, _)| mantissa != 0)
        .map(|&(_, exponent)| exponent);
    let unit = exponents.min().unwrap_or(0);
    let integers =
        parts.map(|(mantissa, exponent)| IBig::from(mantissa) << distance(exponent, unit));
    Some((integers, unit))
}

/// Returns an integer and an exponent: `x`, which has to be finite, is the integer times two to the
/// exponent.
pub(super) fn split(x: f64) -> (i64, i64) {
    let bits = x.abs().to_bits();
    let fraction = (bits & ((1 << 52) - 1)).cast_signed();
    let (mantissa, exponent) = match bits >> 52 {
        0 => (fraction, -1074),
        field => (fraction + (1 << 52), field.cast_signed() - 1075),
    };
    (if x < 0.0 { -mantissa } else { mantissa }, exponent)
}

/// Returns x·|x|: the square, with the sign of `x`.
fn signed_square(x: &IBig) -> IBig {
    x * x.abs()
}

fn distance(upper: i64, lower: i64) -> usize {
    upper.abs_diff(lower) as usize
}

fn dot(u: &[IBig; 3], v: &[IBig; 3]) -> IBig {
    &u[0] * &v[0] + &u[1] * &v[1] + &u[2] * &v[2]
}
