//! Scaling by powers of two: it changes no digit, and makes exponents ordinary.
//!
//! Source: Sterbenz, *Floating-Point Computation*, 1974.

use common::rtweekend::*;

use super::filter::{Unclear, filter};
use crate::methods::{exponent, two_to};

/// The filter, asked in units in which neither the scene nor the direction is
/// much longer than 1.
///
/// Unclear if the filter says so, or if a number would lose a digit: a coordinate that is smaller by 2¹⁰⁰⁰ than another
/// one, or an end of the range beyond the largest number.
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
