//! An oracle in exact integer arithmetic: where a ray meets a sphere, without a
//! rounding error.
//!
//! A finite `f64` is an integer times a power of two. Over a common power of
//! two, the equation |C − P(t)|² = r² therefore has integer coefficients, and
//! whether it has roots, where they lie and which `f64` is nearest to them are
//! questions about integers. They have answers for all finite input, from
//! 5e-324 to 1.8e308 in any mixture.
//!
//! A tangent is a hit. The radius counts only by its square: −r is the same
//! sphere as r, and 0 is a point.

use std::cmp::Ordering;

use dashu_base::FloatEncoding;
use dashu_int::ops::{BitTest, DivRemEuclid, SquareRootRem, UnsignedAbs};
use dashu_int::{IBig, UBig};

use crate::case::Case;

/// The quadratic equation of one ray and one sphere, in integer arithmetic that never rounds.
///
/// Its roots are (h ∓ √D) / a, with oc = C − Q, a = d·d, h = d·oc, c = oc·oc − r² and D = h² − a·c,
/// for a ray from Q along d and a sphere around C. Source: equations (13)–(15) of the notes with h
/// = b/−2 and D = (b² − 4ac)/4.
#[derive(Clone, Debug)]
pub struct ExactCase {
    // Integers: lengths are counted in one power of two, `d` in another.
    a: IBig,
    h: IBig,
    discriminant: IBig,
    /// |oc|² + r², in squares of the unit of lengths.
    extent: IBig,
    /// The roots are (h ∓ √D) / a times 2 to this power, since lengths and `d` have different
    /// units.
    exponent: isize,
}

/// A real number `t` at which the line of a ray meets a sphere, in lengths of the ray's direction;
/// known exactly.
///
/// A root compares with any `f64`, exactly: `root > 0.0` asks where the root is, not what it rounds
/// to. Every comparison with NaN is false. Roots of two spheres on one ray compare exactly, too.
#[derive(Clone, Copy, Debug)]
pub struct ExactRoot<'a> {
    of: &'a ExactCase,
    nearer: bool,
}

impl ExactCase {
    /// Computes the equation of a ray and a sphere, exactly.
    ///
    /// # Panics
    /// If a number of the case is infinite or NaN.
    pub fn of(case: &Case) -> Self {
        Self::of_finite(case).expect("strategies make finite cases, and laws ask for no others")
    }

    /// Computes the equation of a ray and a sphere, exactly; `None` if a number of the case is
    /// infinite or NaN.
    pub fn of_finite(case: &Case) -> Option<Self> {
        let [cx, cy, cz, r, qx, qy, qz, dx, dy, dz] = case.numbers();
        let (lengths, unit_of_length) = integers([cx, cy, cz, qx, qy, qz, r])?;
        let (d, unit_of_direction) = integers([dx, dy, dz])?;

        let [cx, cy, cz, qx, qy, qz, r] = lengths;
        let oc = [cx - qx, cy - qy, cz - qz];
        let a = dot(&d, &d);
        let h = dot(&d, &oc);
        let oc_squared = dot(&oc, &oc);
        let r_squared = r.sqr();
        let c = &oc_squared - &r_squared;
        Some(Self {
            discriminant: h.sqr() - &a * &c,
            extent: oc_squared + r_squared,
            a,
            h,
            exponent: unit_of_length - unit_of_direction,
        })
    }

    /// Compares the discriminant D with zero: `Less` if the line misses the sphere, `Equal` if it
    /// touches it, `Greater` if it passes through.
    ///
    /// A direction of zero makes no line: D is then zero, and there is no root.
    pub fn discriminant(&self) -> Ordering {
        self.discriminant.cmp(&IBig::ZERO)
    }

    /// Returns D / (a·M) with M = oc·oc + r², rounded to nearest: how far the line is from being a
    /// tangent, on the scale that rounding errors have.
    ///
    /// The result is from −1 to 1, and 0 if a·M is 0. A value that rounds to 0 still has its sign
    /// in [`ExactCase::discriminant`].
    pub fn discriminant_margin(&self) -> f64 {
        ratio(&self.discriminant, &(&self.a * &self.extent))
    }

    /// Returns the lesser of the two roots, which is negative if it lies behind the ray's origin.
    ///
    /// A tangent has one root, as the nearer and as the farther. Returns `None` if the line misses
    /// or the direction is zero.
    pub fn nearer_root(&self) -> Option<ExactRoot<'_>> {
        self.root(true)
    }

    /// Returns the greater of the two roots, which is negative if it lies behind the ray's origin.
    ///
    /// A tangent has one root, as the nearer and as the farther. Returns `None` if the line misses
    /// or the direction is zero.
    pub fn farther_root(&self) -> Option<ExactRoot<'_>> {
        self.root(false)
    }

    /// Returns the nearer root if it lies between `t_min` and `t_max`, else the farther root if
    /// that does, else `None`.
    ///
    /// Both ends are excluded, and may be infinite. The exact root must lie between them, even if
    /// it rounds to an end. If an end is NaN, the result is `None`.
    pub fn nearest_root_in(&self, t_min: f64, t_max: f64) -> Option<ExactRoot<'_>> {
        [self.nearer_root(), self.farther_root()]
            .into_iter()
            .flatten()
            .find(|root| *root > t_min && *root < t_max)
    }

    fn root(&self, nearer: bool) -> Option<ExactRoot<'_>> {
        let exists = self.discriminant >= IBig::ZERO && self.a != IBig::ZERO;
        exists.then_some(ExactRoot { of: self, nearer })
    }
}

impl ExactRoot<'_> {
    /// Returns the `f64` nearest to the root, ties to even.
    ///
    /// A root too small for an `f64` becomes a zero and one too large an
    /// infinity, with the sign of the root. The root 0 itself is +0.
    pub fn rounded(&self) -> f64 {
        let (digits, exponent) = self.digits();
        round(&digits, exponent)
    }

    /// Returns how far `t` is from the root, in units of the last place that an `f64` near the root
    /// has; infinity if `t` is infinite or NaN.
    ///
    /// The unit is 2⁻¹⁰⁷⁴ at least; it goes on growing beyond the largest `f64`. The result is 0
    /// only if `t` is the root, and from 2⁻⁶⁰ upwards its relative error is below 1 in 10 000.
    pub fn error_in_ulps(&self, t: f64) -> f64 {
        let Some((mantissa, exponent_of_t)) = decode(t) else {
            return f64::INFINITY;
        };
        let (digits, exponent) = self.digits();
        let unit = last_place(&digits, exponent);
        let common = exponent.min(exponent_of_t);
        let t = IBig::from(mantissa) << exponent_of_t.abs_diff(common);
        let root = digits << exponent.abs_diff(common);
        round(&(t - root), common - unit).abs()
    }

    /// Returns the root as `digits` · 2^`exponent`: exactly if `digits` is even. If odd, it stands
    /// for the open interval between its even neighbors, which holds the root.
    ///
    /// A root that is not zero has 129 digits or more. An `f64` has 53, so what separates one that
    /// rounds up from one that rounds down is an even number of this scale: all of the interval
    /// lies on one side of it, and rounds as the root does. The other digits measure small errors.
    fn digits(&self) -> (IBig, isize) {
        let ExactCase {
            a, h, discriminant, ..
        } = self.of;
        // If h ∓ √D cancels, the same root is c / (h ± √D), where nothing does.
        let sum = h.bit_len().max(discriminant.bit_len() / 2 + 1) + 1;
        let shift = 128 + sum.max(a.bit_len());
        let (sqrtd, rest) = (discriminant.unsigned_abs() << (2 * shift)).sqrt_rem();
        let inexact = rest != UBig::ZERO;

        // The greatest integer not above (h ∓ √D) · 2^shift. Its quotient by
        // the integer a, rounded down, is that of the real number.
        let numerator = if self.nearer {
            (h << shift) - sqrtd - IBig::from(inexact)
        } else {
            (h << shift) + sqrtd
        };
        let digits = odd_if_inexact(&numerator, a, inexact);
        (digits, self.of.exponent - shift.cast_signed() - 1)
    }
}

impl PartialEq<f64> for ExactRoot<'_> {
    fn eq(&self, t: &f64) -> bool {
        self.partial_cmp(t) == Some(Ordering::Equal)
    }
}

impl PartialOrd<f64> for ExactRoot<'_> {
    /// Compares the root with `t`, which may be infinite; `None` if `t` is NaN.
    fn partial_cmp(&self, t: &f64) -> Option<Ordering> {
        let Some((mantissa, exponent)) = decode(*t) else {
            return 0.0.partial_cmp(t);
        };
        let ExactCase {
            a, h, discriminant, ..
        } = self.of;
        // ∓√D against a·t − h, both in the finer of two units.
        let common = exponent.min(self.of.exponent);
        let shift = self.of.exponent.abs_diff(common);
        let side = ((a * mantissa) << exponent.abs_diff(common)) - (h << shift);
        let square = discriminant << (2 * shift);
        Some(if self.nearer {
            compare_sqrt(&square, &-side).reverse()
        } else {
            compare_sqrt(&square, &side)
        })
    }
}

impl PartialEq<ExactRoot<'_>> for ExactRoot<'_> {
    fn eq(&self, other: &ExactRoot<'_>) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl PartialOrd<ExactRoot<'_>> for ExactRoot<'_> {
    /// Compares the root with one on another sphere; always `Some`.
    ///
    /// # Panics
    /// If the two are not on the same ray.
    fn partial_cmp(&self, other: &ExactRoot<'_>) -> Option<Ordering> {
        let (one, another) = (self.of, other.of);
        assert_eq!(one.a, another.a, "only roots on one ray compare");
        let common = one.exponent.min(another.exponent);
        let [(h, square), (other_h, other_square)] = [one, another].map(|exact| {
            let finer = exact.exponent.abs_diff(common);
            (&exact.h << finer, &exact.discriminant << (2 * finer))
        });
        let x = h - other_h;
        let squares = square.bit_len().max(other_square.bit_len());
        let digits = enough_digits(x.bit_len().max(squares / 2 + 1));
        let sqrt = |square: &IBig, nearer| {
            let floor = IBig::from((square.unsigned_abs() << (2 * digits)).sqrt_rem().0);
            if nearer { -floor } else { floor }
        };
        let difference =
            (x << digits) + sqrt(&square, self.nearer) - sqrt(&other_square, other.nearer);
        Some(if difference.bit_len() < 2 {
            Ordering::Equal
        } else {
            difference.cmp(&IBig::ZERO)
        })
    }
}

/// Returns how many binary digits behind the point v = x ± √A ± √B must be known, to tell v from 0
/// with an error of less than 2 in the last place. Each of the three integers x, √A and √B is below
/// 2^`length`.
///
/// The four numbers that the signs make have an integer as their product. If that is not 0, v is at
/// least 1 over the other three, each below 2^(`length` + 2). If it is 0 and v is not, another one
/// is: then v is twice x, √A or √B, so 2 or more.
fn enough_digits(length: usize) -> usize {
    3 * (length + 2) + 2
}

/// Compares √`square` with `x`.
fn compare_sqrt(square: &IBig, x: &IBig) -> Ordering {
    if *x < IBig::ZERO {
        Ordering::Greater
    } else {
        square.cmp(&x.sqr().into())
    }
}

/// Returns `numerator` / `denominator` rounded to nearest, or 0 if the denominator is 0.
fn ratio(numerator: &IBig, denominator: &IBig) -> f64 {
    if *denominator == IBig::ZERO {
        return 0.0;
    }
    // At least 64 digits, so that odd ones round as in `ExactRoot::digits`.
    let shift = denominator.bit_len() + 64;
    let digits = odd_if_inexact(&(numerator << shift), denominator, false);
    round(&digits, -shift.cast_signed() - 1)
}

/// Returns twice the quotient rounded down, and one more if that is not exact. `inexact` says that
/// `numerator` is itself a number rounded down.
fn odd_if_inexact(numerator: &IBig, denominator: &IBig, inexact: bool) -> IBig {
    let (floor, rest) = numerator.div_rem_euclid(denominator);
    (floor << 1) + IBig::from(inexact || rest != UBig::ZERO)
}

/// The exponent of the least `f64` above zero.
const LEAST: isize = -1074;

/// The number of binary digits of an `f64`.
const DIGITS: isize = 53;

/// Returns the `f64` nearest to `digits` · 2^`exponent`, ties to even.
fn round(digits: &IBig, exponent: isize) -> f64 {
    // What is dropped behind 62 digits makes the last one odd, as in `ExactRoot::digits`.
    let dropped = digits.bit_len().saturating_sub(62);
    let is_exact = digits.trailing_zeros().is_none_or(|zeros| zeros >= dropped);
    let kept = i64::try_from(digits >> dropped).expect("62 digits and a sign");
    let exponent = exponent + dropped.cast_signed();
    let beyond_all = isize::from(i16::MAX / 4);
    let exponent = exponent.clamp(-beyond_all, beyond_all) as i16;
    f64::encode(kept | i64::from(!is_exact), exponent).value()
}

/// Returns the exponent of the last place that an `f64` of the size of `digits` · 2^`exponent` has,
/// if exponents had no upper end.
fn last_place(digits: &IBig, exponent: isize) -> isize {
    match digits.bit_len() {
        0 => LEAST,
        length => (length.cast_signed() + exponent - DIGITS).max(LEAST),
    }
}

/// Returns `values` as integers that count one power of two, and the exponent of that power; `None`
/// if one of them is infinite or NaN.
fn integers<const N: usize>(values: [f64; N]) -> Option<([IBig; N], isize)> {
    let mut parts = [(0, 0); N];
    for (part, value) in parts.iter_mut().zip(values) {
        *part = decode(value)?;
    }
    let common = parts.iter().map(|&(_, exponent)| exponent).min()?;
    let integers =
        parts.map(|(mantissa, exponent)| IBig::from(mantissa) << exponent.abs_diff(common));
    Some((integers, common))
}

/// Returns the integer and the exponent of two whose product is `x`, the integer odd or zero;
/// `None` if `x` is infinite or NaN.
fn decode(x: f64) -> Option<(i64, isize)> {
    let (mantissa, exponent) = x.decode().ok()?;
    if mantissa == 0 {
        // No number has a greater exponent: a zero never makes others longer.
        return Some((0, 1023));
    }
    let zeros = mantissa.trailing_zeros();
    Some((mantissa >> zeros, isize::from(exponent) + zeros as isize))
}

/// Returns the dot product of two vectors of integers.
fn dot(u: &[IBig; 3], v: &[IBig; 3]) -> IBig {
    &u[0] * &v[0] + &u[1] * &v[1] + &u[2] * &v[2]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The suite asks the method `exact` of chapter 6 about ten thousand cases more.
    #[test]
    fn another_library_finds_the_same_roots() {
        let lines = include_str!("oracle_vectors.txt").lines();
        let vectors: Vec<&str> = lines.filter(|line| !line.starts_with('#')).collect();
        for line in &vectors {
            let numbers: Vec<f64> = line.split(' ').flat_map(str::parse).collect();
            let (&case, expected) = numbers.split_first_chunk().expect("ten numbers and roots");
            let exact = ExactCase::of(&Case::from_numbers(case));
            let roots = [exact.nearer_root(), exact.farther_root()];
            let found = roots.iter().flatten().map(ExactRoot::rounded);
            let bits = |t: f64| t.to_bits();
            let expected: Vec<u64> = expected.iter().copied().map(bits).collect();
            assert_eq!(found.map(bits).collect::<Vec<_>>(), expected, "{line}");
        }
        assert_eq!(vectors.len(), 71);
    }
}
