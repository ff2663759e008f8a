//! Methods in plain `f64`.

use common::rtweekend::*;
use hittable_list::{Hittable, Sphere};

/// The full quadratic formula of chapter 3; the farther root is the nearer one
/// of the ray turned round, to the bit.
///
/// Cost: 1 √, 1 ÷, and both again if only the farther root is in range.
#[inline]
pub fn full_b(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let in_range = |t: &f64| t_min < *t && *t < t_max;
    let nearer = normals::hit_sphere(center, radius, ray)?;
    Some(nearer).filter(in_range).or_else(|| {
        let turned = Ray::new(ray.origin, -ray.direction);
        normals::hit_sphere(center, radius, &turned)
            .map(|t| -t)
            .filter(in_range)
    })
}

/// Half of b: what chapter 5 does.
///
/// Cost: 1 √, 1 ÷, and a second ÷ if only the farther root is in range.
#[inline]
pub fn half_b(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    Sphere::new(center, radius.abs())
        .hit(ray, t_min, t_max)
        .map(|hit| hit.t)
}

/// The same discriminant; each root by the division that does not cancel:
/// q = h + sign(h)·√D, and the roots are c/q and q/a.
///
/// Cost: 1 √, 1 ÷ for the root that is returned. Source: Numerical Recipes, §5.6.
#[inline]
pub fn half_b_q(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let h = ray.direction.dot(oc);
    let c = oc.length_squared() - radius * radius;
    let discriminant = h * h - a * c;
    if discriminant < 0.0 {
        return None;
    }
    let q = h + discriminant.sqrt().copysign(h);
    let in_range = |t: &f64| t_min < *t && *t < t_max;
    let [nearer, farther] = if h > 0.0 {
        [(c, q), (q, a)]
    } else {
        [(q, a), (c, q)]
    };
    Some(nearer.0 / nearer.1)
        .filter(in_range)
        .or_else(|| Some(farther.0 / farther.1).filter(in_range))
}
