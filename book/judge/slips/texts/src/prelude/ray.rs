use common::rtweekend::*;

pub fn at(ray: &Ray, t: f64) -> Point3 {
    ray.origin + t * ray.direction
}
