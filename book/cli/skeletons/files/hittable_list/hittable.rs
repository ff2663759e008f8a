//! The record of a hit.

use common::rtweekend::*;

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
    pub fn set_face_normal(&mut self, ray: &Ray, outward_normal: Vec3) {
        todo!()
    }
}
