/// The picture at `width` pixels wide.
pub fn picture(width: u32) -> Picture {
    render(width, ray_color)
}

// carry ray_color as sky

/// Red where the ray meets a sphere of radius ½ at z = −1, sky elsewhere.
pub fn ray_color(ray: &Ray) -> Color {
    if hit_sphere(Point3::new(0.0, 0.0, -1.0), 0.5, ray) {
        return Color::new(1.0, 0.0, 0.0);
    }
    sky(ray)
}

/// Whether the line of the ray meets the sphere; a tangent does.
pub fn hit_sphere(center: Point3, radius: f64, ray: &Ray) -> bool {
    todo!()
}
