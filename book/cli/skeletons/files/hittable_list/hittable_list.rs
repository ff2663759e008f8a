//! A list of spheres.

use common::rtweekend::*;

use crate::hittable::HitRecord;
use crate::sphere::Sphere;

/// A list of spheres.
#[derive(Default)]
pub struct HittableList {
    objects: Vec<Sphere>,
}

impl HittableList {
    /// Appends `object` to the list, which then owns it.
    pub fn add(&mut self, object: Sphere) {
        self.objects.push(object);
    }
}

impl HittableList {
    /// Finds the nearest hit of all: of two equally near, the one added first.
    pub fn hit(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<HitRecord> {
        todo!()
    }
}
