//! The quadratic formula as the lesson has it: with b, and with half of it.

use common::rtweekend::*;
use hittable_list::{Hittable, Sphere};

use crate::method::Method;

impl Method {
    /// The full formula of chapter 3.
    pub const FULL_B: Self = Self {
        root_cancels: true,
        ..Self::double("full_b", full_b)
    };

    /// Half of b, as in chapter 5.
    pub const HALF_B: Self = Self {
        root_cancels: true,
        ..Self::double("half_b", half_b)
    };

    /// The method by which the others are measured: that of the chapters.
    pub const REFERENCE: Self = Self::HALF_B;
}

/// The full quadratic formula of chapter 3; the farther root is the nearer one
/// of the ray turned round, to the bit.
///
/// Cost: 1 √, 1 ÷, and both again if only the farther root is in range.
/// Error: that of [`half_b`], to the bit, because b is h with a factor of two
/// that never rounds. Fails: where `half_b` does, and a factor of two earlier
/// for want of exponents. Source: equations (12)–(15) of the notes.
#[inline]
pub fn full_b(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let in_range = |t: &f64| t_min < *t && *t < t_max;
    let nearer = normals::hit_sphere(center, radius, ray)?;
    Some(nearer).filter(in_range).or_else(|| {
        let turned = Ray::new(ray.origin, -ray.direction);
        normals::hit_sphere(center, radius, &turned)
            .map(|t| -t)
            .filter(in_range)
    })
}

/// Half of b: what chapter 5 does.
///
/// Cost: 1 √, 1 ÷, and a second ÷ if only the farther root is in range.
/// Error: 24u·a·M in D, and with it about 12u·M/√D in t. Fails: by the decision,
/// once in a million from 10⁵ radii away, and a hundred times as often with each
/// factor of ten; by the digits of t near the surface and above a large sphere,
/// where h − √D cancels; at |d|·|oc| above 1e154 or below 1e-154. Source: the
/// book, chapter 6.2.
#[inline]
pub fn half_b(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    Sphere::new(center, radius.abs())
        .hit(ray, t_min, t_max)
        .map(|hit| hit.t)
}
