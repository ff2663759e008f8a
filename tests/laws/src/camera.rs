//! Laws for the map from pixels to rays, which all pictures rest on.

use common::rtweekend::*;

use crate::nearer_root::U;
use crate::verdict::{Broken, Verdict};

/// How wide a picture is, in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Width(pub u32);

/// A picture of 16:9 is 9w/16 high, rounded down, and at least 1.
pub fn the_height_is_rounded_down_and_at_least_one(
    height: &dyn Fn(u32) -> u32,
    &Width(width): &Width,
) -> Verdict {
    let (found, expected) = (height(width), (9 * width / 16).max(1));
    if found == expected {
        return Ok(());
    }
    Err(Broken {
        law: "the height of a picture is rounded down, and at least 1",
        found: format!("{found} rows at {width} wide"),
        allowed: format!("{expected}"),
        usually: "the height is rounded to nearest, or the ratio 16/9 is that of integers, or \
                  nothing keeps it from being 0",
        page: "chapter 1: the size of the picture",
    })
}

/// A pixel of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// Columns and rows of the picture.
    pub size: [u32; 2],
    /// Column and row of the pixel.
    pub place: [u32; 2],
}

/// The ray of pixel (i, j) starts at the eye and meets the viewport at t = 1 in
/// ((2i + 1 − w) / h, (h − 2j − 1) / h, −1), for a picture of w × h pixels.
///
/// That place is the pixel's center: the viewport is 2 high, so a pixel is 2/h
/// wide and high. The camera rounds a handful of times, at numbers no larger
/// than the viewport.
pub fn the_ray_of_a_pixel_goes_through_its_center(
    ray: &dyn Fn([u32; 2], [u32; 2]) -> Ray,
    &Pixel { size, place }: &Pixel,
) -> Verdict {
    let ([w, h], [i, j]) = (size.map(f64::from), place.map(f64::from));
    let expected = Point3::new((2.0 * i + 1.0 - w) / h, (h - 2.0 * j - 1.0) / h, -1.0);
    let ray = ray(size, place);
    let bound = 16.0 * U * (w / h).max(1.0);
    let off = (ray.at(1.0) - expected).abs().max_element();
    if off <= bound && ray.origin == Point3::ZERO {
        return Ok(());
    }
    Err(Broken {
        law: "the ray of a pixel goes from the eye through the pixel's center",
        found: format!("from {:?} to {:?} at t = 1", ray.origin, ray.at(1.0)),
        allowed: format!(
            "from the origin to {expected:?} ± {bound:.1e}, for pixel {place:?} of {size:?}"
        ),
        usually: "x and y, or rows and columns, are swapped; y points down; the half step into the \
                first pixel is missing; the viewport is not centered, or has the ideal ratio and \
                not the real one; the focal length points backwards",
        page: "chapter 1: the viewport and its grid of pixels",
    })
}
