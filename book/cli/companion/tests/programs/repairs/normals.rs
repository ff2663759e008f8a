use common::rtweekend::*;

pub fn picture(width: u32) -> Picture {
    render(width, ray_color)
}

/// Carried along from chapter 1.
pub fn sky(ray: &Ray) -> Color {
    let unit = ray.direction.normalize();
    let t = 0.5 * (unit.y + 1.0);
    Color::new(1.0, 1.0, 1.0) * (1.0 - t) + Color::new(0.5, 0.7, 1.0) * t
}

pub fn ray_color(r: &Ray) -> Color {
    let c = Point3::new(0.0, 0.0, -1.0);
    match hit_sphere(c, 0.5, r) {
        Some(t) if t > 0.0 => {
            let n = (r.at(t) - c).normalize();
            Color::new(n.x + 1.0, n.y + 1.0, n.z + 1.0) * 0.5
        }
        _ => sky(r),
    }
}

pub fn hit_sphere(center: Point3, radius: f64, r: &Ray) -> Option<f64> {
    let to_center = center - r.origin;
    let a = r.direction.length_squared();
    let b = r.direction.dot(to_center) * -2.0;
    let c = to_center.length_squared() - radius * radius;
    let disc = discriminant(a, b, c);
    match disc >= 0.0 {
        true => {
            let root = disc.sqrt();
            Some((-b - root) / (2.0 * a))
        }
        false => None,
    }
}

fn discriminant(a: f64, b: f64, c: f64) -> f64 {
    b * b - 4.0 * a * c
}
