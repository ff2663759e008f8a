//! The trait of anything that a ray can hit, and the record of a hit.

use common::rtweekend::*;

/// Anything that a ray can hit: a sphere, a list of such things, or a shape of
/// your own.
pub trait Hittable {
    /// Finds the nearest hit with `t_min` < `t` < `t_max`, or returns `None`.
    ///
    /// Both ends are left out, so a ray that starts on a surface does not hit it at `t` = 0. Where
    /// rounding makes that `t` 1e-17, it does.
    fn hit(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<HitRecord>;
}

/// The place where a ray hits a surface, and the side from which it comes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HitRecord {
    /// The ray parameter, in lengths of the ray's direction.
    pub t: f64,
    /// The point of the surface that is hit.
    pub point: Point3,
    /// The unit normal at that point; it always points against the ray.
    pub normal: Vec3,
    /// True if the ray comes from outside, false from inside.
    pub front_face: bool,
}

impl HitRecord {
    /// Sets `front_face`, and `normal` to whichever of `outward_normal` and its
    /// opposite points against `ray`.
    ///
    /// `outward_normal` must have unit length. For a ray at a right angle to it, which only grazes
    /// the surface, `front_face` is false.
    pub fn set_face_normal(&mut self, ray: &Ray, outward_normal: Vec3) {
        self.front_face = ray.direction.dot(outward_normal) < 0.0;
        self.normal = if self.front_face {
            outward_normal
        } else {
            -outward_normal
        };
    }
}
