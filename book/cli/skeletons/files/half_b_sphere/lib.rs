use common::rtweekend::*;

/// Returns the picture of the sphere's normals, `width` pixels wide: that of chapter 3.
pub fn picture(width: u32) -> Picture {
    render(width, ray_color)
}

/// Returns the unit normal as a color if the ray meets the sphere ahead of it,
/// else the sky's color.
pub fn ray_color(ray: &Ray) -> Color {
    todo!()
}

/// Finds the lesser `t` at which the line through `ray` meets or touches the
/// sphere, the nearer root of |C − P(t)|² = r².
pub fn hit_sphere(center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
    todo!()
}
