//! # Chapter 1: rays, a camera and a gradient
//!
//! Nothing to hit yet. Each ray returns the color of the sky in its direction.

use common::rtweekend::*;

/// Returns the gradient as a picture, `width` pixels wide.
pub fn picture(width: u32) -> Picture {
    render(width, ray_color)
}

/// Blends linearly (*lerp*) from white, straight down, to blue, straight up.
/// The picture shows a part of it: it looks neither so far down nor so far up.
///
/// The height y of the unit direction lies between −1 and 1; equation (2)
/// wants a weight between 0 and 1. A direction of length zero has no color:
/// the result is NaN.
pub fn ray_color(ray: &Ray) -> Color {
    let white = Color::new(1.0, 1.0, 1.0);
    let blue = Color::new(0.5, 0.7, 1.0);

    let unit_direction = ray.direction.normalize();
    let a = 0.5 * (unit_direction.y + 1.0);
    (1.0 - a) * white + a * blue
}
