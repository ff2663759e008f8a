//! The sphere of chapter 5, typed by somebody else.
use crate::hittable::{HitRecord, Hittable};
use common::rtweekend::*;

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere { middle: Point3, size: f64 }

impl Sphere
{
    /// The sphere of that size; a negative one is 0.
    pub fn new(middle: Point3, size: f64) -> Self { Self { middle, size: size.max(0.0) } }
}

impl Hittable for Sphere
{
    fn hit(&self, r: &Ray, low: f64, high: f64) -> Option<HitRecord>
    {
        let (d, way) = (r.direction, self.middle - r.origin);
        let (a, h, c) = (d.dot(d), way.dot(d), way.dot(way) - self.size * self.size);
        let q = h * h - c * a;
        if q < 0.0 { return None; }
        let mut t = (h - q.sqrt()) / a;
        if !(low < t && t < high) {
            t = (q.sqrt() + h) / a;
            if !(low < t && t < high) { return None; }
        }
        let point = r.at(t);
        let mut found = HitRecord { point, t, ..HitRecord::default() };
        found.set_face_normal(r, (1.0 / self.size) * (point - self.middle));
        Some(found)
    }
}
