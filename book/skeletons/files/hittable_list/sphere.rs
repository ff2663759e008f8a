use crate::hittable::{HitRecord, Hittable};

/// All points at distance `radius` from `center`.
pub struct Sphere {
    center: Point3,
    radius: f64,
}

impl Sphere {
    /// A sphere; a negative `radius` counts as 0.
    pub fn new(center: Point3, radius: f64) -> Self {
        Self {
            center,
            radius: radius.max(0.0),
        }
    }
}

// show hit_sphere
impl Hittable for Sphere {
    /// The nearer root if it lies in the range, else the farther one.
    fn hit(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<HitRecord> {
        todo!()
    }
}
