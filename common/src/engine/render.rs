//! Ray casting: one ray through the center of each pixel.

use super::picture::Picture;
use crate::camera::Camera;
use crate::color::Color;
use crate::ray::Ray;

/// Draws the view of the book's camera in a picture `width` pixels wide, 16:9: `ray_color` returns
/// the color of the ray through each pixel.
pub fn render(width: u32, ray_color: impl Fn(&Ray) -> Color + Send + Sync + 'static) -> Picture {
    let camera = Camera::new(width);
    Picture::paint(
        camera.image_width,
        camera.image_height,
        #[inline(always)]
        move |i, j| ray_color(&camera.ray(i, j)),
    )
}
