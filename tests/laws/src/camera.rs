//! The law for the map from pixels to rays, which all pictures rest on.

use common::rtweekend::*;

use crate::case::{numbers_of_ray, point_at, ray_from, vector};
use crate::question::nearly_equal;
use crate::verdict::{BrokenLaw, LawResult};

/// A pixel of a picture with the aspect ratio 16:9: the argument of a camera's function that
/// returns the ray through a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraPixel {
    /// The width of the picture, in pixels.
    pub width: u32,
    /// The column of the pixel, from 0 at the left.
    pub i: u32,
    /// The row of the pixel, from 0 at the top.
    pub j: u32,
}

/// Returns the height, in pixels, of a picture with the aspect ratio 16:9, at least 1.
pub(crate) fn height(width: u32) -> u32 {
    ((f64::from(width) / (16.0 / 9.0)) as u32).max(1)
}

/// Tests that a camera's `ray` for `pixel` starts at the origin, and is in the pixel's center on
/// the viewport at `t` = 1.
pub fn the_ray_of_a_pixel_goes_through_its_center(ray: &Ray, pixel: &CameraPixel) -> LawResult {
    let right = pixel.expected_ray();
    BrokenLaw::unless(
        nearly_equal(&numbers_of_ray(*ray), &numbers_of_ray(right)),
        || BrokenLaw {
            law: "the ray of a pixel goes from the eye through the pixel's center".into(),
            found: format!("from {} to {} at t = 1", ray.origin, point_at(ray, 1.0)),
            allowed: format!("from the origin to {}, for {pixel:?}", right.direction),
            read: "chapter 1: the viewport and its grid of pixels".into(),
        },
    )
}

impl CameraPixel {
    /// Returns the ray that the book's camera casts for the pixel: from the origin through the
    /// pixel's center, in a viewport at z = −1 that is 2 units high and has the aspect ratio of the
    /// picture. Also for a pixel outside of the picture.
    pub fn expected_ray(&self) -> Ray {
        let [width, i, j] = [self.width, self.i, self.j].map(f64::from);
        let height = f64::from(height(self.width));
        let (u, v) = ((i + 0.5) / width, (j + 0.5) / height);
        let center = Point3::new(2.0 * width / height * (u - 0.5), 2.0 * (0.5 - v), -1.0);
        ray_from(Point3::ZERO, center)
    }

    /// Writes the body of a test that asks about this pixel again.
    pub(crate) fn as_test(&self) -> String {
        let Self { width, i, j } = self;
        let center = vector(self.expected_ray().direction);
        format!(
            "let ray = Camera::new({width}).ray({i}, {j});\n\
             assert!((ray.at(1.0) - {center}).length() < 1e-9);"
        )
    }
}
