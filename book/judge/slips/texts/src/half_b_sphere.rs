use common::rtweekend::*;

pub fn picture(width: u32) -> Picture {
    render(width, ray_color)
}

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
