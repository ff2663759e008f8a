/// The picture at `width` pixels wide.
pub fn picture(width: u32) -> Picture {
    render(width, ray_color)
}

// show ray_color
/// The unit normal as a color where the sphere is in front, sky elsewhere.
pub fn ray_color(ray: &Ray) -> Color {
    todo!()
}

// show hit_sphere
/// The nearer root `t`, if the line of the ray meets the sphere; a tangent does.
pub fn hit_sphere(center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
    todo!()
}
