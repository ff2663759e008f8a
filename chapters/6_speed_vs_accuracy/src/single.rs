//! Methods in single precision.

use glam::Vec3;

/// A ray in `f32`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SingleRay {
    /// Where it starts.
    pub origin: Vec3,
    /// Where it points; one `t` long.
    pub direction: Vec3,
}

/// As [`half_b`](crate::half_b), in `f32`.
#[inline]
pub fn half_b_f32(
    center: Vec3,
    radius: f32,
    ray: &SingleRay,
    t_min: f32,
    t_max: f32,
) -> Option<f32> {
    let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let h = ray.direction.dot(oc);
    let c = oc.length_squared() - radius * radius;
    let discriminant = h * h - a * c;
    if discriminant < 0.0 {
        return None;
    }
    let sqrtd = discriminant.sqrt();
    let in_range = |t: &f32| t_min < *t && *t < t_max;
    Some((h - sqrtd) / a)
        .filter(in_range)
        .or_else(|| Some((h + sqrtd) / a).filter(in_range))
}
