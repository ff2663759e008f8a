//! # Chapter 4: half of b
//!
//! The same picture from less arithmetic: with b = −2h every factor of two and
//! four in the quadratic formula cancels.

use common::rtweekend::*;

/// Returns the picture of chapter 3, `width` pixels wide.
pub fn picture(width: u32) -> Picture {
    render(width, ray_color)
}

/// Returns the unit normal as a color where the sphere is in front, else the sky.
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

/// Finds the nearer root `t` of |C − P(t)|² = r², if the line of the ray meets
/// the sphere; a tangent does.
///
/// It is the `t` of chapter 3 to the last bit, barring overflow and underflow, and NaN,
/// −∞ or negative where that is: multiplying by two and four never rounds.
/// Source: equations (13)–(15) of the notes with h = d·(C − Q) = b/−2.
pub fn hit_sphere(center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
    let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let h = ray.direction.dot(oc);
    let c = oc.length_squared() - radius * radius;
    let discriminant = h * h - a * c;
    if discriminant < 0.0 {
        return None;
    }
    Some((h - discriminant.sqrt()) / a)
}
