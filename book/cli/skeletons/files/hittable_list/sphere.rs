//! A sphere, which a ray can hit from outside and from inside.

use common::rtweekend::*;

use crate::hittable::HitRecord;

/// A sphere: all points at distance `radius` from `center`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    center: Point3,
    radius: f64,
}

impl Sphere {
    /// Makes a sphere.
    pub fn new(center: Point3, radius: f64) -> Self {
        Self {
            center,
            radius: radius.max(0.0),
        }
    }
}

impl Sphere {
    /// Finds the nearer root if it lies in the interval, else the farther one:
    /// from inside the sphere, the nearer root is behind the ray.
    pub fn hit(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<HitRecord> {
        todo!()
    }
}
