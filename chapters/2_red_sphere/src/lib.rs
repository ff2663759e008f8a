//! # Chapter 2: a red sphere
//!
//! A ray and a sphere make a quadratic equation. Its discriminant alone says
//! whether they meet, and that is enough to color the sphere red.

use common::rtweekend::*;

/// Returns the picture of a red sphere, `width` pixels wide.
pub fn picture(width: u32) -> Picture {
    render(width, ray_color)
}

/// Returns red if the line of `ray` meets a sphere of radius ½ around
/// (0, 0, −1), else the sky's color.
pub fn ray_color(ray: &Ray) -> Color {
    if hit_sphere(Point3::new(0.0, 0.0, -1.0), 0.5, ray) {
        return Color::new(1.0, 0.0, 0.0);
    }
    sky(ray)
}

/// Returns true if the whole line of `ray` meets or touches the sphere.
///
/// The sign of `radius` does not matter. NaN in any number gives false, a direction of length 0
/// true; an overflow may give either. Source: equations (11)–(15).
pub fn hit_sphere(center: Point3, radius: f64, ray: &Ray) -> bool {
    let oc = center - ray.origin;
    let a = ray.direction.dot(ray.direction);
    let b = -2.0 * ray.direction.dot(oc);
    let c = oc.dot(oc) - radius * radius;
    let discriminant = b * b - 4.0 * a * c;
    discriminant >= 0.0
}
