//! Laws for the small functions that everything else rests on: the dot product, the
//! point on a ray, and the map from pixels to rays.

use common::rtweekend::*;

use crate::nearer_root::U;
use crate::verdict::{Broken, Verdict};

/// Two vectors of small whole numbers, to be multiplied.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Letters(pub [[i32; 3]; 2]);

impl Letters {
    /// The two vectors.
    pub fn vectors(&self) -> [Vec3; 2] {
        self.0.map(|v| Vec3::from_array(v.map(f64::from)))
    }
}

/// u·v is the sum of the products of equal letters, and the same for v·u.
///
/// Small whole numbers are added without rounding, so this holds to the bit. A
/// swapped letter (`u.z * u.z`) draws the right picture in four chapters of
/// five, because there every z is −1.
pub fn dot_multiplies_equal_letters(dot: &dyn Fn(Vec3, Vec3) -> f64, letters: &Letters) -> Verdict {
    let [u, v] = letters.0;
    let expected: i32 = u.iter().zip(v).map(|(u, v)| u * v).sum();
    let [u, v] = letters.vectors();
    let found = [dot(u, v), dot(v, u)];
    if found == [f64::from(expected); 2] {
        return Ok(());
    }
    Err(Broken {
        law: "a dot product multiplies equal letters and adds",
        found: format!(
            "u·v = {:?}, v·u = {:?} for u = {u:?}, v = {v:?}",
            found[0], found[1]
        ),
        allowed: format!("{expected} for both"),
        usually: "a letter is swapped: u.x*v.x + u.y*v.y + u.z*v.z",
        page: "equation (5) of the notes",
    })
}

/// A vector of some length, to be made one of length 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrow(pub Vec3);

/// v/|v| has the length 1, and its dot product with v is |v|: it points along v.
///
/// The length, its reciprocal, the product and what is computed here round ten times
/// together at most.
pub fn a_unit_vector_has_length_1_and_points_along(
    unit: &dyn Fn(Vec3) -> Vec3,
    &Arrow(v): &Arrow,
) -> Verdict {
    let found = unit(v);
    let (length, along) = (found.length(), found.dot(v) / v.length());
    if [length, along].iter().all(|x| (x - 1.0).abs() <= 10.0 * U) {
        return Ok(());
    }
    Err(Broken {
        law: "a unit vector has length 1 and points where the vector does",
        found: format!("{found:?} for {v:?}: length {length:?}"),
        allowed: format!("length 1 ± {:.1e}", 10.0 * U),
        usually: "the vector is not divided by its length, the root of v.x² + v.y² + v.z²",
        page: "chapter 1: the color of the sky",
    })
}

/// A ray, and where on it to look.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The ray.
    pub ray: Ray,
    /// The ray parameter, in lengths of the ray's direction.
    pub t: f64,
}

/// P(t) = A + t·b, equation (1): at 0 the origin, at 1 one direction further on.
///
/// To be asked with small whole numbers, of which nothing rounds, and with a place
/// that tells a product that is rounded before the sum from a fused one: 10 · 0.1 is
/// 1 to an `f64`, though `0.1` is a little more than a tenth.
pub fn the_point_at_t_is_t_directions_from_the_origin(
    at: &dyn Fn(&Ray, f64) -> Point3,
    place: &Place,
) -> Verdict {
    let Place { ray, t } = *place;
    let (found, expected) = (at(&ray, t), ray.origin + t * ray.direction);
    if found == expected {
        return Ok(());
    }
    Err(Broken {
        law: "the point at t is t directions away from the origin",
        found: format!("{found:?} at t = {t} of {ray:?}"),
        allowed: format!("{expected:?}"),
        usually: "the origin is left out, the direction is changed first, or the product and the \
                  sum are fused",
        page: "equation (1) of the notes",
    })
}

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
