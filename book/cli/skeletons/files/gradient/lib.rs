use common::rtweekend::*;

/// Returns the gradient as a picture, `width` pixels wide.
pub fn picture(width: u32) -> Picture {
    render(width, ray_color)
}

/// Blends linearly (*lerp*) from white, straight down, to blue, straight up.
pub fn ray_color(ray: &Ray) -> Color {
    todo!()
}
