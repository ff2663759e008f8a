//! Chapter 3, typed by somebody else.
use common::rtweekend::*;

/// The ball, at `w` pixels wide.
pub fn picture(w: u32) -> Picture { render(w, ray_color) }

/// The normal as a color, or the sky.
pub fn ray_color(r: &Ray) -> Color
{
    let c = Point3::new(0.0, 0.0, -1.0);
    match hit_sphere(c, 0.5, r)
    {
        Some(root) if root > 0.0 =>
        {
            let n = (r.at(root) - c).normalize();
            (n + Vec3::ONE) * 0.5
        }
        _ => sky(r),
    }
}

/// The nearer root, if there is one.
pub fn hit_sphere(
    middle: Point3,
    size: f64,
    r: &Ray,
) -> Option<f64>
{
    let to_middle = middle - r.origin;
    let a = r.direction.length_squared();
    let b = to_middle.dot(r.direction) * -2.0;
    let c = to_middle.length_squared() - size * size;
    let under_the_root = b * b - c * (a * 4.0);
    if under_the_root < 0.0 { None } else { Some((-b - under_the_root.sqrt()) / (a * 2.0)) }
}
