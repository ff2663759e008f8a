/// The picture at `width` pixels wide.
pub fn picture(width: u32) -> Picture {
    render(width, ray_color)
}

/// The color of the sky in the direction of the ray.
pub fn ray_color(ray: &Ray) -> Color {
    todo!()
}
