//! The camera, the loop over all pixels, and the picture as text.

use crate::ray::Ray;
use crate::vec3::Color;

/// A picture as text: `P3`, width and height, 255, then three levels for each pixel.
pub type Picture = String;

/// Draws the view of the book's camera, `width` pixels wide: 16 to 9, the eye at the origin, a
/// viewport 2 units high, one unit away along −z.
pub fn render(width: u32, ray_color: impl Fn(&Ray) -> Color) -> Picture {
    todo!()
}
