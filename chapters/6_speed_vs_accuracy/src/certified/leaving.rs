//! Ray-origin offsetting: where a ray starts that leaves a sphere, so that it does
//! not hit what it leaves.
//!
//! A hit point is rounded, and so lies a little above the surface or below. From there
//! a ray meets the sphere again at a t near 0, or not, as rounding has it: shadow acne.
//! Either hits near 0 do not count, or the ray starts a little farther out. What is
//! passed over is not seen: the less, the better.

use std::ops::RangeInclusive;

use common::rtweekend::*;

use crate::precision::Precision;

/// Where a ray may start that leaves a sphere at `point`: so near the surface as the proof
/// allows. From there three plain tests are right about this sphere, with `t_min` = 0.
///
/// A ray that goes out misses the sphere and one that goes in hits it, as exact
/// arithmetic sees it and as the tests of chapters 3 and 5 and `half_b_q` do: the origin is
/// so far from the surface that the sign of c survives its rounding. Seen from the center it
/// is in the direction of `point`, and its distance from the surface is at most
/// 30u·r + 4u·|C|, where u is half of ε. Bound L in the proofs, also for why 22 and 2.
///
/// The ray goes out if its direction turns away from the center, else into the sphere. In
/// `f32` all numbers given are numbers that an `f32` can hold, and so are those returned.
///
/// `None` if there may be no such point: if the center is r/2ε or more from the origin
/// of coordinates, where numbers are a quarter as far apart as the sphere is wide; if
/// `point` is the center; or if r, or its distance from the center, is not from 1e-67
/// to 1e67, in `f32` from 1e-7 to 1e9. The squared length of the direction must be
/// from 2⁻⁴⁵⁰ to 2⁴⁵⁰, in `f32` from 2⁻⁵⁰ to 2⁵⁰.
///
/// Cost: 2 √, 1 ÷.
#[inline]
pub fn proven_offset(
    center: Point3,
    radius: f64,
    point: Point3,
    direction: Vec3,
    precision: Precision,
) -> Option<Point3> {
    let normal = point - center;
    let length = normal.length();
    let u = precision.epsilon() / 2.0;
    let reach = u * (22.0 * radius + 2.0 * center.length());
    let ordinary = ordinary_lengths(precision);
    if !(ordinary.contains(&radius) && ordinary.contains(&length) && reach <= 0.5 * radius) {
        return None;
    }
    let side = if direction.dot(normal) < 0.0 {
        -reach
    } else {
        reach
    };
    let origin = center + (radius + side) / length * normal;
    Some(match precision {
        Precision::Double => origin,
        Precision::Single => origin.as_vec3().as_dvec3(),
    })
}

/// Lengths whose fourth powers do not overflow, nor underflow where they are rounded.
#[inline]
fn ordinary_lengths(precision: Precision) -> RangeInclusive<f64> {
    match precision {
        Precision::Double => 1e-67..=1e67,
        Precision::Single => 1e-7..=1e9,
    }
}
