use crate::hittable::{HitRecord, Hittable};

/// A list of hittable things.
#[derive(Default)]
pub struct HittableList {
    objects: Vec<Box<dyn Hittable + Send + Sync>>,
}

impl HittableList {
    /// Puts `object` into the list.
    pub fn add(&mut self, object: impl Hittable + Send + Sync + 'static) {
        self.objects.push(Box::new(object));
    }
}

impl Hittable for HittableList {
    /// The nearest hit of all.
    fn hit(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<HitRecord> {
        todo!()
    }
}
