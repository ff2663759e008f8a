//! Many things to hit, which together are one.

use common::rtweekend::*;

use crate::hittable::{Hit, Hittable};

/// A list of hittable things, other lists among them.
///
/// The book keeps `shared_ptr`s here. Each thing has one owner, this list, so a
/// `Box` does: it is there because a sphere and a list differ in size.
#[derive(Default)]
pub struct HittableList {
    objects: Vec<Box<dyn Hittable>>,
}

impl HittableList {
    /// Puts `object` into the list.
    pub fn add(&mut self, object: impl Hittable + 'static) {
        self.objects.push(Box::new(object));
    }

    /// All that was added, in this order.
    pub fn objects(&self) -> &[Box<dyn Hittable>] {
        &self.objects
    }
}

impl Hittable for HittableList {
    /// The nearest hit of all. Where two are equally near, the first one added.
    fn hit(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Hit> {
        let mut nearest = None;
        let mut closest_so_far = t_max;
        for object in &self.objects {
            if let Some(hit) = object.hit(ray, t_min, closest_so_far) {
                closest_so_far = hit.t;
                nearest = Some(hit);
            }
        }
        nearest
    }
}
