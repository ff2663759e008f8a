//! The law for the map from pixels to rays, which all pictures rest on.

use common::rtweekend::*;
use proptest::prelude::*;
use slips::{Chapter, Program};

use crate::broken::{Broken, Verdict};
use crate::nearer_root::U;
use crate::question::{Question, of_ray, vector};
use crate::strategies;

/// A pixel of a picture of 16:9.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// How many columns the picture has.
    pub width: u32,
    /// Column and row of the pixel.
    pub place: [u32; 2],
}

/// What this law says.
pub const LAW: &str = "the ray of a pixel goes from the eye through the pixel's center";

/// The ray of a pixel starts at the eye and meets the viewport in the pixel's center.
///
/// The camera rounds a handful of times, at numbers no larger than the viewport.
pub fn the_ray_of_a_pixel_goes_through_its_center(ray: &Ray, pixel: &Pixel) -> Verdict {
    let expected = pixel.center();
    let bound = 16.0 * U * f64::from(pixel.width) / f64::from(Pixel::height(pixel.width));
    let off = (ray.at(1.0) - expected).abs().max_element();
    if off <= bound && ray.origin == Point3::ZERO {
        return Ok(());
    }
    Err(Broken {
        law: LAW,
        found: format!("from {} to {} at t = 1", ray.origin, ray.at(1.0)),
        allowed: format!("from the origin to {expected} ± {bound:.1e}, for {pixel:?}"),
        usually: "x and y, or rows and columns, are swapped; y points down; the half step into the \
                first pixel is missing; the viewport is not centered, or has the ideal ratio and \
                not the real one; the focal length points backwards; the height is rounded up",
        page: "chapter 1: the viewport and its grid of pixels",
    })
}

impl Pixel {
    /// How many rows: 9w/16, rounded down, and at least 1.
    pub(crate) fn height(width: u32) -> u32 {
        (9 * width / 16).max(1)
    }

    /// In a picture of w × h pixels ((2i + 1 − w) / h, (h − 2j − 1) / h, −1): the viewport is
    /// 2 high, so a pixel is 2/h wide and high.
    fn center(&self) -> Point3 {
        let [w, h] = [self.width, Self::height(self.width)].map(f64::from);
        let [i, j] = self.place.map(f64::from);
        Point3::new((2.0 * i + 1.0 - w) / h, (h - 2.0 * j - 1.0) / h, -1.0)
    }

    /// The ray that a program casts.
    pub fn ray_by(&self, program: &Program) -> Ray {
        let [i, j] = self.place;
        (program.ray)(program, &program.camera(self.width), i, j)
    }
}

impl Question for Pixel {
    fn kind(&self) -> &'static str {
        "pixel_ray"
    }

    fn as_test(&self, _: Chapter) -> String {
        let (width, [i, j]) = (self.width, self.place);
        let center = vector(self.center());
        format!(
            "let ray = Camera::new({width}).ray({i}, {j});\n\
             assert!((ray.at(1.0) - {center}).length() < 1e-9);"
        )
    }

    fn answer_of(&self, program: &Program) -> Vec<f64> {
        of_ray(self.ray_by(program))
    }

    fn ordinary(_: Chapter) -> BoxedStrategy<Self> {
        strategies::pixels().boxed()
    }
}
