//! Ray-origin offsetting: where a ray starts that leaves a sphere, so that it does
//! not hit what it leaves.
//!
//! A hit point is rounded, and so lies a little above the surface or below. From there
//! a ray meets the sphere again at a t near 0, or not, as rounding has it. Either hits
//! near 0 do not count, or the ray starts a little farther out. What is passed over is
//! not seen: the less, the better.
//!
//! All ways here have one signature. They are given the center and the radius of the
//! sphere, the point that was found on it, and where the ray goes: out of the sphere if
//! the direction turns away from the center, else into it. In `f32` they are given
//! numbers that an `f32` can hold, and start at such a point.

use std::ops::RangeInclusive;

use common::rtweekend::*;

use crate::precision::Precision;

/// How a ray leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Departure {
    /// The ray.
    pub ray: Ray,
    /// Hits count if their `t` is above this.
    pub t_min: f64,
}

/// A way to leave a sphere.
#[derive(Clone, Copy, Debug)]
pub struct Leaving {
    /// The name of the function.
    pub name: &'static str,
    /// The precisions that it is made for.
    pub precisions: &'static [Precision],
    /// The function.
    pub leave: fn(Point3, f64, Point3, Vec3, Precision) -> Option<Departure>,
}

/// All ways to leave, from no care to a proof.
pub const LEAVINGS: [Leaving; 6] = [
    Leaving::AT_ONCE,
    Leaving::AFTER_T_MIN,
    Leaving::INTEGER_OFFSET,
    Leaving::OPTIX_OFFSET,
    Leaving::PBRT_OFFSET,
    Leaving::PROVEN_OFFSET,
];

impl Leaving {
    /// By the bound of the rounding error of the test that comes next.
    pub const PROVEN_OFFSET: Self = Self {
        name: "proven_offset",
        leave: proven_offset,
        ..Self::AT_ONCE
    };
}

/// From so near the surface as the proof allows; then three plain tests are right about
/// this sphere, with `t_min` = 0.
///
/// A ray that goes out misses the sphere and one that goes in hits it, as exact
/// arithmetic sees it and as the tests of chapters 3 and 5 and `half_b_q` do: the origin is
/// so far from the surface that the sign of c survives its rounding. Seen from the center it
/// is in the direction of `point`, and its distance from the surface is at most
/// 30u·r + 4u·|C|, where u is half of ε. Bound L in the proofs, also for why 22 and 2.
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
) -> Option<Departure> {
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
    let origin = rounded(precision, center + (radius + side) / length * normal);
    Some(departure(origin, direction))
}

impl Leaving {
    /// From the rounded point.
    pub const AT_ONCE: Self = Self {
        name: "at_once",
        precisions: &Precision::ALL,
        leave: at_once,
    };
}

/// From the point as it is.
///
/// Cost: none. Fails: about every third ray that goes out hits the sphere, as exact
/// arithmetic sees it.
#[inline]
pub fn at_once(
    _center: Point3,
    _radius: f64,
    point: Point3,
    direction: Vec3,
    _precision: Precision,
) -> Option<Departure> {
    Some(departure(point, direction))
}

impl Leaving {
    /// From the rounded point, and the first thousandth does not count.
    pub const AFTER_T_MIN: Self = Self {
        name: "after_t_min",
        leave: after_t_min,
        ..Self::AT_ONCE
    };
}

/// From the point as it is, with `t_min` = 0.001.
///
/// Cost: none. Fails: 0.001 is a length in the unit of the scene. Where things are as
/// small it passes over them, and on a large sphere it is less than a rounding. Source:
/// the book, in its chapter on diffuse materials.
#[inline]
pub fn after_t_min(
    _center: Point3,
    _radius: f64,
    point: Point3,
    direction: Vec3,
    _precision: Precision,
) -> Option<Departure> {
    Some(Departure {
        t_min: 0.001,
        ..departure(point, direction)
    })
}

impl Leaving {
    /// By up to 256 numbers farther on.
    pub const INTEGER_OFFSET: Self = Self {
        name: "integer_offset",
        precisions: &[Precision::Single],
        leave: integer_offset,
    };
}

/// Along the normal by up to 256 numbers in each coordinate, or by 2⁻¹⁶ where the
/// coordinate is below 1/32 in size.
///
/// Made for `f32`, and computed in it. Cost: 1 √, 3 ÷ for the normal. Fails: a
/// coordinate near 0 does not know how large the sphere is. Source: Wächter and Binder,
/// *A Fast and Robust Method for Avoiding Self-Intersection*, in Ray Tracing Gems, 2019.
#[inline]
pub fn integer_offset(
    center: Point3,
    _radius: f64,
    point: Point3,
    direction: Vec3,
    _precision: Precision,
) -> Option<Departure> {
    let normal = onwards((point - center).normalize(), direction).as_vec3();
    let moved = |x: f32, n: f32| {
        if x.abs() < 1.0 / 32.0 {
            return x + n / 65_536.0;
        }
        // The bits of floats of one sign are in the order of their sizes.
        let steps = (256.0 * n) as i32;
        let away_from_zero = if x < 0.0 { -steps } else { steps };
        f32::from_bits(x.to_bits().wrapping_add_signed(away_from_zero))
    };
    let point = point.as_vec3();
    let origin = glam::Vec3::new(
        moved(point.x, normal.x),
        moved(point.y, normal.y),
        moved(point.z, normal.z),
    );
    Some(departure(origin.as_dvec3(), direction))
}

impl Leaving {
    /// By a bound of the rounding error of a point that was brought back to the surface.
    pub const OPTIX_OFFSET: Self = Self {
        name: "optix_offset",
        leave: optix_offset,
        ..Self::AT_ONCE
    };
}

/// Along the normal by u·(|C| + 3r), from the point brought back to the surface.
///
/// Cost: 2 √, 1 ÷. Fails: where the test that comes next errs by more than the point does,
/// for it is a seventh as long as [`proven_offset`] on a sphere around the origin of
/// coordinates. Source: the recipe of the OptiX Toolkit's *Self Intersection Avoidance*,
/// NVIDIA, 2023: a custom primitive brings a bound of the error of its own point, and this
/// is what users bring for a sphere. Its next ray is traced by another test.
#[inline]
pub fn optix_offset(
    center: Point3,
    radius: f64,
    point: Point3,
    direction: Vec3,
    precision: Precision,
) -> Option<Departure> {
    let u = precision.epsilon() / 2.0;
    let normal = (point - center).normalize();
    let on_sphere = rounded(precision, center + radius * normal);
    let offset = u * (center.length() + 3.0 * radius) * onwards(normal, direction);
    Some(departure(rounded(precision, on_sphere + offset), direction))
}

impl Leaving {
    /// By the bound of the rounding error of the point.
    pub const PBRT_OFFSET: Self = Self {
        name: "pbrt_offset",
        leave: pbrt_offset,
        ..Self::AT_ONCE
    };
}

/// Along the normal by a bound of the rounding error that the point has, once it was
/// brought back to the surface.
///
/// In pbrt-v4 a test in interval arithmetic goes with it; here a plain one does. The
/// bounds are those of a sphere that is moved to its place, and nothing else. Cost: 2 √,
/// 4 ÷. Fails: not in what is measured here, but nothing is proved. The plain test has an
/// error of its own, of which the bound does not know. Source: Pharr, Jakob and Humphreys,
/// *Physically Based Rendering*, 2023, §6.8.
#[inline]
pub fn pbrt_offset(
    center: Point3,
    radius: f64,
    point: Point3,
    direction: Vec3,
    precision: Precision,
) -> Option<Departure> {
    let u = precision.epsilon() / 2.0;
    let gamma = |n: f64| n * u / (1.0 - n * u);
    let from_center = point - center;
    let on_sphere = rounded(precision, radius / from_center.length() * from_center);
    let error = (1.0 + gamma(3.0)) * gamma(5.0) * on_sphere.abs()
        + gamma(3.0) * (on_sphere.abs() + center.abs());
    let normal = onwards(on_sphere.normalize(), direction);
    let offset = normal.abs().dot(error) * normal;
    let origin = rounded(precision, rounded(precision, center + on_sphere) + offset);
    let origin = Point3::new(
        next(precision, origin.x, offset.x),
        next(precision, origin.y, offset.y),
        next(precision, origin.z, offset.z),
    );
    Some(departure(origin, direction))
}

/// From `origin` on, and every hit counts.
#[inline]
fn departure(origin: Point3, direction: Vec3) -> Departure {
    Departure {
        ray: Ray::new(origin, direction),
        t_min: 0.0,
    }
}

/// The normal, or its opposite if the direction is against it.
#[inline]
fn onwards(normal: Vec3, direction: Vec3) -> Vec3 {
    if direction.dot(normal) < 0.0 {
        -normal
    } else {
        normal
    }
}

/// The numbers of that precision that are nearest to those of `v`.
#[inline]
fn rounded(precision: Precision, v: Vec3) -> Vec3 {
    match precision {
        Precision::Double => v,
        Precision::Single => v.as_vec3().as_dvec3(),
    }
}

/// The number after `x` on the side to which the sign of `way` points; `x` if that is 0.
#[inline]
fn next(precision: Precision, x: f64, way: f64) -> f64 {
    match precision {
        _ if way == 0.0 => x,
        Precision::Double if way > 0.0 => x.next_up(),
        Precision::Double => x.next_down(),
        Precision::Single if way > 0.0 => (x as f32).next_up().into(),
        Precision::Single => (x as f32).next_down().into(),
    }
}

/// Lengths whose fourth powers do not overflow, nor underflow where they are rounded.
#[inline]
fn ordinary_lengths(precision: Precision) -> RangeInclusive<f64> {
    match precision {
        Precision::Double => 1e-67..=1e67,
        Precision::Single => 1e-7..=1e9,
    }
}
