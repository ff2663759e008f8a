//! A list of things to hit, which can be hit itself.

use common::rtweekend::*;

use crate::hittable::{HitRecord, Hittable};

/// A list of hittable things, other lists among them.
///
/// The book keeps `shared_ptr`s here. Each thing has one owner, this list, so a
/// `Box` does: it is there because a sphere and a list differ in size. `Send +
/// Sync` says that several threads may look at one world together.
#[derive(Default)]
pub struct HittableList {
    objects: Vec<Box<dyn Hittable + Send + Sync>>,
}

impl HittableList {
    /// Appends `object` to the list, which then owns it.
    pub fn add(&mut self, object: impl Hittable + Send + Sync + 'static) {
        self.objects.push(Box::new(object));
    }
}

impl Hittable for HittableList {
    /// Finds the nearest hit of all: of two equally near, the one added first.
    fn hit(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<HitRecord> {
        let mut nearest = None;
        let mut closest_so_far = t_max;
        for object in &self.objects {
            if let Some(record) = object.hit(ray, t_min, closest_so_far) {
                closest_so_far = record.t;
                nearest = Some(record);
            }
        }
        nearest
    }
}
