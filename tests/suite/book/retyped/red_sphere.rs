//! Chapter 2, typed by somebody else.
use common::rtweekend::*;

/// The sphere, at `w` pixels wide.
pub fn picture(w: u32) -> Picture { render(w, ray_color) }

/// Red or sky.
pub fn ray_color(r: &Ray) -> Color
{
    let ball = (Point3::new(0.0, 0.0, -1.0), 0.5);
    if hit_sphere(ball.0, ball.1, r) { Color::X } else { sky(r) }
}

/// Whether the line of `r` meets the sphere.
pub fn hit_sphere(middle: Point3, size: f64, r: &Ray) -> bool
{
    let d = r.direction;
    let to_middle = middle - r.origin;
    let (a, c) = (d.length_squared(), to_middle.dot(to_middle) - size.powi(2));
    let b = to_middle.dot(d) * -2.0;
    (b * b) - c * (a * 4.0) >= 0.0
}
