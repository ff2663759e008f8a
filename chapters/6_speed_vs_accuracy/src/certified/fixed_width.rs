//! Multi-word integers of fixed width: coefficients without a rounding error, on
//! the stack.
//!
//! An `f64` is an integer times a power of two. If the lengths of a question are
//! within a factor of 2⁶⁷ of each other, they fit into 120 binary digits over a
//! common power; then a, h and c fit into 256, and D into 512. It is nearly always
//! so, and takes a small part of the time of integers of any length. Only then is
//! anything rounded, to twice the digits of an `f64`, and the roots are found with
//! these. Nothing is left that could cancel.

use std::array;

use common::rtweekend::*;

use super::exact::{inwards, split};
use super::filter::Unclear;
use crate::bounds::{U, W};
use crate::methods::{DoubleDouble, DoubleQuadratic};

/// Finds the nearest root in the range, decided exactly and rounded once.
///
/// Error: half an ulp and bound W, before a root that rounds to an end gives way
/// inwards as in [`exact`](crate::exact()). Unclear if lengths or directions do
/// not fit, if they are of sizes 2⁷⁰⁰ apart, or if a root is so close to an end
/// that twice the digits do not tell them apart.
pub(super) fn fixed_width(
    center: Point3,
    radius: f64,
    ray: &Ray,
    t_min: f64,
    t_max: f64,
) -> Result<Option<f64>, Unclear> {
    for root in pairs(center, radius, ray).ok_or(Unclear)? {
        let (above, below) = (root.minus(t_min), -root.minus(t_max));
        let band = W.band * U * U * root.high.abs();
        if above > band && below > band {
            return Ok(inwards(root.high, t_min, t_max));
        }
        let is_outside = above <= -band || below <= -band;
        if !is_outside {
            return Err(Unclear);
        }
    }
    Ok(None)
}

/// Returns the roots as sums of two `f64`, the nearer one first; `None` if the numbers do not fit.
fn pairs(center: Point3, radius: f64, ray: &Ray) -> Option<impl Iterator<Item = DoubleDouble>> {
    let ([cx, cy, cz], [qx, qy, qz]) = (center.to_array(), ray.origin.to_array());
    let (lengths, unit_of_length) = integers([cx, cy, cz, qx, qy, qz, radius])?;
    let (d, unit_of_direction) = integers(ray.direction.to_array())?;
    // Neither the root nor its lower half leaves the range of an `f64` then.
    let unit = unit_of_length - unit_of_direction;
    if unit.abs() > 700 {
        return None;
    }
    let roots = quadratic(lengths, d).and_then(|quadratic| quadratic.roots());
    let in_units = move |(numerator, denominator): (DoubleDouble, DoubleDouble)| {
        (numerator / denominator).times_power_of_two(two_to(unit as i32))
    };
    Some(roots.into_iter().flatten().map(in_units))
}

/// Returns a·t² − 2h·t + c = 0 and its D, each rounded once to a pair; `None` if it has no root.
#[inline(always)]
fn quadratic([cx, cy, cz, qx, qy, qz, r]: [i128; 7], d: [i128; 3]) -> Option<DoubleQuadratic> {
    let oc = [cx - qx, cy - qy, cz - qz];
    let dot = |u: [i128; 3], v: [i128; 3]| {
        let [x, y, z] = array::from_fn(|k| signed_product(u[k], v[k]));
        sum(sum(x, y), z)
    };
    let (a, h) = (dot(d, d), dot(d, oc));
    let c = sum(dot(oc, oc), signed_product(r, -r));
    if a == [0; 4] {
        return None;
    }
    let h_squared: [u64; 8] = product(magnitude(h), magnitude(h));
    let ac = product(a, magnitude(c));
    let discriminant = if is_negative(c) {
        sum(h_squared, ac)
    } else {
        difference(h_squared, ac)?
    };
    Some(DoubleQuadratic {
        a: pair(a),
        h: signed_pair(h),
        c: signed_pair(c),
        discriminant: pair(discriminant),
    })
}

/// Returns the values as integers of at most 120 binary digits times one power of two, and its
/// exponent; `None` if they do not fit.
#[inline(always)]
fn integers<const N: usize>(values: [f64; N]) -> Option<([i128; N], i64)> {
    /// The largest shift: a number has 53 digits.
    const MOST: i64 = 120 - 53;
    /// The exponent that `split` returns for an infinity or NaN.
    const NOT_FINITE: i64 = 972;
    let parts = values.map(split);
    // A zero has the least exponent, and none that counts.
    let counted =
        parts.map(|(mantissa, exponent)| if mantissa == 0 { NOT_FINITE } else { exponent });
    let least = counted.into_iter().fold(NOT_FINITE, i64::min);
    let most = parts.iter().fold(least, |most, part| most.max(part.1));
    if most - least > MOST || most >= NOT_FINITE {
        return None;
    }
    let shifted = array::from_fn(|k| i128::from(parts[k].0) << (parts[k].1.max(least) - least));
    Some((shifted, least))
}

/// An integer in two's complement, 256 bits; the lowest digits first.
type Integer = [u64; 4];

#[inline(always)]
fn signed_product(x: i128, y: i128) -> Integer {
    let words = |x: i128| [x.unsigned_abs() as u64, (x.unsigned_abs() >> 64) as u64];
    let size = product(words(x), words(y));
    if (x < 0) == (y < 0) {
        size
    } else {
        negative(size)
    }
}

/// Computes x · y, for `TWICE` = 2 · `N`: word by word, as on paper.
#[inline(always)]
fn product<const N: usize, const TWICE: usize>(x: [u64; N], y: [u64; N]) -> [u64; TWICE] {
    let mut product = [0; TWICE];
    for i in 0..N {
        let mut carry = 0;
        for j in 0..N {
            (product[i + j], carry) = x[i].carrying_mul_add(y[j], product[i + j], carry);
        }
        product[i + N] = carry;
    }
    product
}

#[inline(always)]
fn sum<const N: usize>(x: [u64; N], y: [u64; N]) -> [u64; N] {
    let mut carry = false;
    array::from_fn(|k| {
        let sum;
        (sum, carry) = x[k].carrying_add(y[k], carry);
        sum
    })
}

/// Computes x − y; `None` if it is negative.
#[inline(always)]
fn difference<const N: usize>(x: [u64; N], y: [u64; N]) -> Option<[u64; N]> {
    let mut borrow = false;
    let difference = array::from_fn(|k| {
        let difference;
        (difference, borrow) = x[k].borrowing_sub(y[k], borrow);
        difference
    });
    (!borrow).then_some(difference)
}

#[inline(always)]
fn negative(x: Integer) -> Integer {
    sum(x.map(|word| !word), [1, 0, 0, 0])
}

#[inline(always)]
fn is_negative(x: Integer) -> bool {
    x[3] >> 63 == 1
}

#[inline(always)]
fn magnitude(x: Integer) -> Integer {
    if is_negative(x) { negative(x) } else { x }
}

/// Rounds an integer to a sum of two `f64`.
#[inline(always)]
fn signed_pair(x: Integer) -> DoubleDouble {
    let size = pair(magnitude(x));
    if is_negative(x) { -size } else { size }
}

/// Rounds a natural number to a sum of two `f64`, off by less than 2u² of it: its first 106 digits.
#[inline(always)]
fn pair<const N: usize>(x: [u64; N]) -> DoubleDouble {
    let top = x.iter().rposition(|&word| word != 0).unwrap_or(0);
    let [high, middle, low] = array::from_fn(|k| top.checked_sub(k).map_or(0, |k| x[k]));
    let zeros = high.leading_zeros();
    let upper = u128::from(high) << 64 | u128::from(middle);
    let digits = upper << zeros | u128::from(low) << zeros >> 64;
    let unit = 64 * top as i32 - 42 - zeros as i32;
    let (first, second) = (digits >> 75, digits >> 22 & ((1 << 53) - 1));
    DoubleDouble::sum(
        first as u64 as f64 * two_to(unit + 53),
        second as u64 as f64 * two_to(unit),
    )
}

/// Returns 2 to the power `exponent`, from −1022 to 1023.
#[inline]
fn two_to(exponent: i32) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}
