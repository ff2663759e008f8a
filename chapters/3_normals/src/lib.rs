//! # Chapter 3: surface normals
//!
//! The roots of the quadratic say *where* the ray meets the sphere. The normal
//! at that point becomes its color, since there is no light yet.

use common::rtweekend::*;

/// Returns the picture of the sphere's normals, `width` pixels wide.
pub fn picture(width: u32) -> Picture {
    render(width, ray_color)
}

/// Returns the unit normal as a color if the ray meets the sphere ahead of it,
/// else the sky's color.
///
/// Each component of the normal, from −1 to 1, is mapped to 0 to 1.
#[inline]
pub fn ray_color(ray: &Ray) -> Color {
    let center = Point3::new(0.0, 0.0, -1.0);
    if let Some(t) = hit_sphere(center, 0.5, ray)
        && t > 0.0
    {
        let normal = (ray.at(t) - center).normalize();
        return 0.5 * (normal + Vec3::ONE);
    }
    sky(ray)
}

/// Finds the lesser `t` at which the line through `ray` meets or touches the
/// sphere, the nearer root of |C − P(t)|² = r². Returns `None` if it misses.
///
/// `t` counts lengths of `ray.direction`; negative, it lies behind the origin. The sign of `radius`
/// does not matter; ∞ gives −∞. NaN in any number or a direction of length 0 gives `Some(NaN)`; an
/// overflow gives that, ±∞ or `None`. Source: equations (12)–(15).
pub fn hit_sphere(center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
    let oc = center - ray.origin;
    let a = ray.direction.dot(ray.direction);
    let b = -2.0 * ray.direction.dot(oc);
    let c = oc.dot(oc) - radius * radius;
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return None;
    }
    Some((-b - discriminant.sqrt()) / (2.0 * a))
}
