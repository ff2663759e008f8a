//! # Chapter 4: half of b
//!
//! The same picture from less arithmetic: with b = −2h every factor of two and
//! four in the quadratic formula cancels.

use common::rtweekend::*;

/// Returns the picture of the sphere's normals, `width` pixels wide: that of chapter 3.
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
/// Unless a number overflows or underflows, it returns what chapter 3 does, to the last bit, NaN
/// and −∞ included: multiplying by two and four never rounds. Source: equations (13)–(15) with
/// h = d·(C − Q) = b/−2.
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
