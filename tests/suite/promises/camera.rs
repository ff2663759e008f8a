//! The camera maps pixels to rays as the book's does, and rays to points.

use common::rtweekend::*;

/// The book's eye is at the origin, where a wrong sign of its coordinates can't be seen.
#[test]
fn a_ray_starts_at_the_eye_wherever_that_is() {
    // 4 × 2 pixels are unit squares, so no number is rounded.
    let moved = Camera {
        center: Point3::new(1.0, 2.0, 3.0),
        ..Camera::with_size(4, 2)
    };
    let ray = moved.ray(3, 1);
    assert_eq!(ray.origin, moved.center);
    assert_eq!(ray.at(1.0), Point3::new(1.5, -0.5, -1.0));
}

/// Rounded to the nearest integer, as the notes say, the height would be 226 at 401 wide.
#[test]
fn the_height_of_a_picture_is_rounded_down_and_at_least_1() {
    for width in (1..=2000).chain([16_384]) {
        let height = (9 * width / 16).max(1);
        assert_eq!(Camera::new(width).image_height, height, "{width} wide");
    }
}

/// The book divides a vector by multiplying with the reciprocal. To divide each component gives
/// another last bit at some widths, these among them.
#[test]
fn the_steps_from_pixel_to_pixel_are_products_with_a_reciprocal() {
    for (width, height) in [(7_u32, 3_u32), (9, 5), (13, 7), (49, 27)] {
        let camera = Camera::new(width);
        assert_eq!(camera.image_height, height);
        let (w, h) = (f64::from(width), f64::from(height));
        assert_eq!(
            camera.pixel_delta_u,
            Vec3::new(2.0 * (w / h) * (1.0 / w), 0.0, 0.0)
        );
        assert_eq!(camera.pixel_delta_v, Vec3::new(0.0, -2.0 * (1.0 / h), 0.0));
    }
}
