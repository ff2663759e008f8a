//! Functions of glam's vectors and of rays, for programs in which they are mistyped or have fewer
//! digits.

use common::rtweekend::*;

fn length_squared(v: Vec3) -> f64 {
    v.x * v.x + v.y * v.y + v.z * v.z
}

fn length(v: Vec3) -> f64 {
    v.length_squared().sqrt()
}

fn normalize(v: Vec3) -> Vec3 {
    v * (1.0 / v.length())
}

fn at(ray: &Ray, t: f64) -> Point3 {
    ray.origin + t * ray.direction
}
