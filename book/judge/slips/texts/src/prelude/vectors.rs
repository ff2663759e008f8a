use common::rtweekend::*;

pub fn length_squared(v: Vec3) -> f64 {
    v.x * v.x + v.y * v.y + v.z * v.z
}

pub fn length(v: Vec3) -> f64 {
    v.length_squared().sqrt()
}

pub fn normalize(v: Vec3) -> Vec3 {
    v * (1.0 / v.length())
}
