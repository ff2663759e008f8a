//! A sphere, inside and out.

use common::rtweekend::*;

use crate::hittable::{Hit, Hittable};

/// All points at distance `radius` from `center`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    pub(crate) center: Point3,
    pub(crate) radius: f64,
}

impl Sphere {
    /// A sphere; a negative `radius` counts as 0, as in the book.
    pub fn new(center: Point3, radius: f64) -> Self {
        Self {
            center,
            radius: radius.max(0.0),
        }
    }

    /// The unit normal at `point` of the surface, pointing out.
    ///
    /// Dividing by the radius makes it a unit vector without a square root, as
    /// far as `point` really is on the surface. A sphere of radius 0 is a point
    /// and has no normal: the result is NaN.
    #[inline(always)]
    pub fn outward_normal(&self, point: Point3) -> Vec3 {
        (point - self.center) * (1.0 / self.radius)
    }
}

impl Hittable for Sphere {
    /// The nearer root if it lies in the interval, else the farther one: from
    /// inside the sphere, the nearer root is behind the ray.
    #[inline(always)]
    fn hit(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Hit> {
        let oc = self.center - ray.origin;
        let a = ray.direction.length_squared();
        let h = ray.direction.dot(oc);
        let c = oc.length_squared() - self.radius * self.radius;
        let discriminant = h * h - a * c;
        if discriminant < 0.0 {
            return None;
        }
        let sqrtd = discriminant.sqrt();

        let hit_at = |t: f64| (t_min < t && t < t_max).then_some(Hit { t, sphere: *self });
        hit_at((h - sqrtd) / a).or_else(|| hit_at((h + sqrtd) / a))
    }
}
