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
pub fn hit_sphere(center: Point3, radius: f64, ray: &Ray) -> bool {
    todo!()
}
