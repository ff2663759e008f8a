//! Colors: the color of the sky, and the bytes that a picture stores.

use crate::ray::Ray;
use crate::vec3::Vec3;

/// A color: red, green and blue as `x`, `y` and `z`, each from 0 to 1.
pub type Color = Vec3;

/// Returns the color of the sky: the steeper `ray` climbs, the bluer. Straight down it would be
/// white, straight up blue; the picture shows what lies between.
///
/// Chapter 1 is about this function and writes it out; the later chapters take it from here. A
/// direction of length zero has no color: the result is NaN.
#[inline]
pub fn sky(ray: &Ray) -> Color {
    let unit_direction = ray.direction.normalize();
    let a = 0.5 * (unit_direction.y + 1.0);
    (1.0 - a) * Color::new(1.0, 1.0, 1.0) + a * Color::new(0.5, 0.7, 1.0)
}

/// Stores `color` as the three bytes of `pixel`: red, green, blue.
///
/// Each component is scaled by 255.999 and cut off, as in the book, so that 1.0
/// becomes 255 and the 256 levels share the interval [0, 1] almost evenly. A
/// component outside the interval becomes the nearest level and NaN becomes 0.
/// (The book's C++ prints a number outside as it is: the file is then no valid
/// picture.)
#[inline]
pub fn write_color(pixel: &mut [u8; 3], color: Color) {
    *pixel = color
        .to_array()
        .map(|component| (255.999 * component) as u8);
}
