//! The law for the map from pixels to rays, which all pictures rest on.

use common::rtweekend::*;
use proptest::prelude::*;
use slips::{Chapter, Program};

use crate::Verdict;
use crate::question::{Question, of_ray, same, vector};

/// A pixel of a picture of 16:9.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// How many columns the picture has.
    pub width: u32,
    /// The column of the pixel.
    pub i: u32,
    /// The row of the pixel.
    pub j: u32,
}

/// What this law says.
pub const LAW: &str = "the ray of a pixel goes from the eye through the pixel's center";

/// The ray of a pixel starts at the eye and meets the viewport in the pixel's center.
pub fn the_ray_of_a_pixel_goes_through_its_center(ray: &Ray, pixel: &Pixel) -> Verdict {
    let right = pixel.right();
    prop_assert!(
        same(&of_ray(*ray), &of_ray(right)),
        "the law:  {LAW}\n\
         found:    from {} to {} at t = 1\n\
         allowed:  from the origin to {}, for {pixel:?}\n\
         read:     chapter 1: the viewport and its grid of pixels",
        ray.origin,
        ray.at(1.0),
        right.direction
    );
    Ok(())
}

impl Pixel {
    /// The ray that a program casts.
    pub fn ray_by(&self, program: &Program) -> Ray {
        program.ray(&program.camera(self.width), self.i, self.j)
    }

    fn right(&self) -> Ray {
        self.ray_by(&Program::right(Chapter::Gradient))
    }
}

impl Question for Pixel {
    fn kind(&self) -> &'static str {
        "pixel_ray"
    }

    fn as_test(&self, _: Chapter) -> String {
        let Self { width, i, j } = self;
        let center = vector(self.right().direction);
        format!(
            "let ray = Camera::new({width}).ray({i}, {j});\n\
             assert!((ray.at(1.0) - {center}).length() < 1e-9);"
        )
    }

    fn answer_of(&self, program: &Program) -> Vec<f64> {
        of_ray(self.ray_by(program))
    }
}
