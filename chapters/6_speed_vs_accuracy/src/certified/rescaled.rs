//! Scaling by powers of two: it changes no digit, and makes exponents ordinary.
//!
//! Source: Sterbenz, *Floating-Point Computation*, 1974.

use common::rtweekend::*;

use super::filter::{Unclear, filter};

/// The filter, asked in units in which neither the scene nor the direction is
/// much longer than 1.
///
/// Unclear if the filter says so, or if a number would lose a digit: a coordinate that is
/// smaller by 2¹⁰⁰⁰ than another one, or an end of the range beyond the largest number.
#[inline(always)]
pub(super) fn rescaled<const ULP: bool>(
    center: Point3,
    radius: f64,
    ray: &Ray,
    t_min: f64,
    t_max: f64,
) -> Result<Option<f64>, Unclear> {
    let oc = center - ray.origin;
    let length = exponent(oc.abs().max_element().max(radius.abs()));
    let direction = exponent(ray.direction.abs().max_element());
    // t counts lengths of d: it grows with the one and shrinks with the other.
    let t_unit = length - direction;
    if t_unit.abs() > 1000 {
        return Err(Unclear);
    }
    let lengths = |v: Vec3| in_units(v, length);
    let times = |t: f64| in_units(Vec3::splat(t), t_unit).map(|v| v.x);
    let ray = Ray::new(lengths(ray.origin)?, in_units(ray.direction, direction)?);
    let radius = lengths(Vec3::splat(radius))?.x;
    let t = filter::<ULP>(lengths(center)?, radius, &ray, times(t_min)?, times(t_max)?)?;
    t.map(|t| in_units(Vec3::splat(t), -t_unit).map(|v| v.x))
        .transpose()
}

/// `v` counted in 2^`exponent`, if that is exact.
#[inline(always)]
fn in_units(v: Vec3, exponent: i32) -> Result<Vec3, Unclear> {
    let scaled = v * two_to(-exponent);
    if scaled * two_to(exponent) == v {
        Ok(scaled)
    } else {
        Err(Unclear)
    }
}

/// The exponent of the power of two not above `x` > 0, kept within ±1000 so
/// that [`two_to`] has it with either sign.
#[inline]
fn exponent(x: f64) -> i32 {
    let field = (x.to_bits() >> 52) as i32;
    (field - 1023).clamp(-1000, 1000)
}

/// 2 to the power `exponent`, from −1022 to 1023.
#[inline]
pub(super) fn two_to(exponent: i32) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}
