use common::rtweekend::*;

use crate::hittable::{HitRecord, Hittable};

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    center: Point3,
    radius: f64,
}

impl Sphere {
    pub fn new(center: Point3, radius: f64) -> Self {
        Self {
            center,
            radius: radius.max(0.0),
        }
    }
}

impl Hittable for Sphere {
    fn hit(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<HitRecord> {
        let oc = self.center - ray.origin;
        let a = ray.direction.length_squared();
        let h = ray.direction.dot(oc);
        let c = oc.length_squared() - self.radius * self.radius;
        let discriminant = h * h - a * c;
        if discriminant < 0.0 {
            return None;
        }
        let sqrtd = discriminant.sqrt();
        let roots = [(h - sqrtd) / a, (h + sqrtd) / a];
        let t = roots.into_iter().find(|&t| t_min < t && t < t_max)?;

        let mut record = HitRecord {
            t,
            point: ray.at(t),
            ..HitRecord::default()
        };
        let outward_normal = (record.point - self.center) * (1.0 / self.radius);
        record.set_face_normal(ray, outward_normal);
        Some(record)
    }
}
