//! Chapter 4, typed by somebody else.
use common::rtweekend::*;

/// The ball, at `w` pixels wide.
pub fn picture(w: u32) -> Picture { render(w, ray_color) }

/// The normal as a color, or the sky.
pub fn ray_color(r: &Ray) -> Color
{
    let c = -Vec3::Z;
    let ahead = hit_sphere(c, 0.5, r).filter(|t| *t > 0.0);
    ahead.map_or_else(|| sky(r), |t| ((r.at(t) - c).normalize() + Color::ONE) * 0.5)
}

/// The nearer root, if there is one.
pub fn hit_sphere(middle: Point3, size: f64, r: &Ray) -> Option<f64>
{
    let (d, way) = (r.direction, middle - r.origin);
    let (a, h, c) = (d.dot(d), way.dot(d), way.dot(way) - size * size);
    let q = h * h - c * a;
    if q < 0.0 { return None; }
    Some((h - q.sqrt()) / a)
}
