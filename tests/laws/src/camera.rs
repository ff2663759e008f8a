//! The law for the map from pixels to rays, which all pictures rest on.

use common::rtweekend::*;

use crate::question::{nearly_equal, of_ray, vector};
use crate::verdict::{BrokenLaw, LawResult};

/// A pixel of a picture of 16:9.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraPixel {
    /// How many columns the picture has.
    pub width: u32,
    /// The column of the pixel.
    pub i: u32,
    /// The row of the pixel.
    pub j: u32,
}

/// Tests that the ray of a pixel starts at the eye and meets the viewport in the pixel's center.
///
/// # Errors
/// If it does not, but for roundings.
pub fn the_ray_of_a_pixel_goes_through_its_center(ray: &Ray, pixel: &CameraPixel) -> LawResult {
    let right = pixel.right_ray();
    BrokenLaw::unless(nearly_equal(&of_ray(*ray), &of_ray(right)), || BrokenLaw {
        law: "the ray of a pixel goes from the eye through the pixel's center".into(),
        found: format!("from {} to {} at t = 1", ray.origin, ray.at(1.0)),
        allowed: format!("from the origin to {}, for {pixel:?}", right.direction),
        read: "chapter 1: the viewport and its grid of pixels".into(),
    })
}

impl CameraPixel {
    /// Returns the ray from the origin to the center of the pixel, in a viewport that is 2 high and
    /// as wide as the picture has it.
    pub fn right_ray(&self) -> Ray {
        let [width, i, j] = [self.width, self.i, self.j].map(f64::from);
        let height = f64::from(((width / (16.0 / 9.0)) as u32).max(1));
        let (u, v) = ((i + 0.5) / width, (j + 0.5) / height);
        let center = Point3::new(2.0 * width / height * (u - 0.5), 2.0 * (0.5 - v), -1.0);
        Ray::new(Point3::ZERO, center)
    }

    /// Writes the body of a test that asks this.
    pub(crate) fn as_test(&self) -> String {
        let Self { width, i, j } = self;
        let center = vector(self.right_ray().direction);
        format!(
            "let ray = Camera::new({width}).ray({i}, {j});\n\
             assert!((ray.at(1.0) - {center}).length() < 1e-9);"
        )
    }
}
