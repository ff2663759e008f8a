//! Laws for the small functions that everything else rests on: the dot product, the
//! point on a ray, and the map from pixels to rays.

use common::rtweekend::*;

use crate::nearer_root::U;
use crate::verdict::{Broken, Verdict};

/// u·v is the sum of the products of equal letters, and the same for v·u.
///
/// Small whole numbers are added without rounding, so this holds to the bit. A
/// swapped letter (`u.z * u.z`) draws the right picture in four chapters of
/// five, because there every z is −1.
pub fn dot_multiplies_equal_letters(
    dot: &dyn Fn(Vec3, Vec3) -> f64,
    [u, v]: [[i32; 3]; 2],
) -> Verdict {
    let expected: i32 = u.iter().zip(v).map(|(u, v)| u * v).sum();
    let [u, v] = [u, v].map(|vector| Vec3::from_array(vector.map(f64::from)));
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
        cause: "a letter is swapped: u.x*v.x + u.y*v.y + u.z*v.z".to_owned(),
        page: "equation (5) of the notes",
    })
}

/// P(t) = A + t·b, equation (1): at 0 the origin, at 1 one direction further on.
///
/// With small whole numbers, nothing rounds. The last ray tells a product that
/// is rounded before the sum from a fused one: 10 · 0.1 is 1 to an `f64`, though
/// `0.1` is a little more than a tenth.
pub fn the_point_at_t_is_t_directions_from_the_origin(at: &dyn Fn(&Ray, f64) -> Point3) -> Verdict {
    let ray = Ray::new(Point3::new(1.0, -2.0, 3.0), Vec3::new(5.0, 7.0, -11.0));
    let rounding = Ray::new(Point3::splat(-1.0), Vec3::splat(10.0));
    let expected = [
        (ray, 0.0, ray.origin),
        (ray, 1.0, Point3::new(6.0, 5.0, -8.0)),
        (ray, -2.0, Point3::new(-9.0, -16.0, 25.0)),
        (rounding, 0.1, Point3::ZERO),
    ];
    for (ray, t, expected) in expected {
        let found = at(&ray, t);
        if found != expected {
            return Err(Broken {
                law: "the point at t is t directions away from the origin",
                found: format!("{found:?} at t = {t} of {ray:?}"),
                allowed: format!("{expected:?}"),
                cause:
                    "the origin is left out, the direction is changed first, or the product and \
                        the sum are fused"
                        .to_owned(),
                page: "equation (1) of the notes",
            });
        }
    }
    Ok(())
}

/// A picture of 16:9 is 9w/16 high, rounded down, and at least 1.
pub fn the_height_is_rounded_down_and_at_least_one(height: &dyn Fn(u32) -> u32) -> Verdict {
    for width in 1..=2000 {
        let (found, expected) = (height(width), (9 * width / 16).max(1));
        if found != expected {
            return Err(Broken {
                law: "the height of a picture is rounded down, and at least 1",
                found: format!("{found} rows at {width} wide"),
                allowed: format!("{expected}"),
                cause: "the height is rounded to nearest, or the ratio 16/9 is that of integers, \
                        or nothing keeps it from being 0"
                    .to_owned(),
                page: "chapter 1: the size of the picture",
            });
        }
    }
    Ok(())
}

/// The ray of pixel (i, j) starts at the eye and meets the viewport at t = 1 in
/// ((2i + 1 − w) / h, (h − 2j − 1) / h, −1), for a picture of w × h pixels.
///
/// That place is the pixel's center: the viewport is 2 high, so a pixel is 2/h
/// wide and high. The camera rounds a handful of times, at numbers no larger
/// than the viewport.
pub fn the_ray_of_a_pixel_goes_through_its_center(
    ray: &dyn Fn([u32; 2], [u32; 2]) -> Ray,
    size: [u32; 2],
    pixel: [u32; 2],
) -> Verdict {
    let ([w, h], [i, j]) = (size.map(f64::from), pixel.map(f64::from));
    let expected = Point3::new((2.0 * i + 1.0 - w) / h, (h - 2.0 * j - 1.0) / h, -1.0);
    let ray = ray(size, pixel);
    let bound = 16.0 * U * (w / h).max(1.0);
    let off = (ray.at(1.0) - expected).abs().max_element();
    if off <= bound && ray.origin == Point3::ZERO {
        return Ok(());
    }
    Err(Broken {
        law: "the ray of a pixel goes from the eye through the pixel's center",
        found: format!("from {:?} to {:?} at t = 1", ray.origin, ray.at(1.0)),
        allowed: format!(
            "from the origin to {expected:?} ± {bound:.1e}, for pixel {pixel:?} of {size:?}"
        ),
        cause: "x and y, or rows and columns, are swapped; y points down; the half step into the \
                first pixel is missing; the viewport is not centered, or has the ideal ratio and \
                not the real one; the focal length points backwards"
            .to_owned(),
        page: "chapter 1: the viewport and its grid of pixels",
    })
}
