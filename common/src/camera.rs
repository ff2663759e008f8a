//! The book's camera: which ray belongs to which pixel.

use crate::ray::Ray;
use crate::vec3::{Point3, Vec3};

/// An eye at the origin that looks down the negative z axis, through a viewport
/// one unit away that is divided into a grid of pixels.
///
/// The frame is right-handed: x to the right, y up, z towards the viewer.
/// Pixel (0, 0) is at the upper left, rows run downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The number of pixels in a row.
    pub image_width: u32,
    /// The number of rows in the picture.
    pub image_height: u32,
    /// The eye, where every ray starts.
    pub center: Point3,
    /// The center of the upper left pixel, a point of the viewport.
    pub pixel00: Point3,
    /// The vector from the center of a pixel to that of its neighbor on the right.
    pub pixel_delta_u: Vec3,
    /// The vector from the center of a pixel to that of its neighbor below; y is negative.
    pub pixel_delta_v: Vec3,
}

impl Camera {
    /// Returns the camera of the chapters: 16:9, the height in pixels rounded down and at least 1.
    /// The width, in pixels, must not be 0.
    pub fn new(image_width: u32) -> Self {
        let aspect_ratio = 16.0 / 9.0;
        let image_height = ((f64::from(image_width) / aspect_ratio) as u32).max(1);
        Self::with_size(image_width, image_height)
    }

    /// Returns a camera for a picture of any shape, in pixels: at least one in each direction. The
    /// eye is at the origin and looks along −z.
    ///
    /// The viewport is 2 units high and 1 unit away. Its width follows from the real ratio of width
    /// to height; in the chapters that only comes near 16:9, because both are integers.
    pub fn with_size(image_width: u32, image_height: u32) -> Self {
        debug_assert!(
            image_width > 0 && image_height > 0,
            "a camera needs at least one pixel, but got {image_width} × {image_height}"
        );
        let focal_length = 1.0;
        let viewport_height = 2.0;
        let viewport_width = viewport_height * (f64::from(image_width) / f64::from(image_height));
        let center = Point3::ZERO;

        let viewport_u = Vec3::new(viewport_width, 0.0, 0.0);
        let viewport_v = Vec3::new(0.0, -viewport_height, 0.0);
        let pixel_delta_u = viewport_u * (1.0 / f64::from(image_width));
        let pixel_delta_v = viewport_v * (1.0 / f64::from(image_height));

        let viewport_upper_left =
            center - Vec3::new(0.0, 0.0, focal_length) - 0.5 * viewport_u - 0.5 * viewport_v;
        let pixel00 = viewport_upper_left + 0.5 * (pixel_delta_u + pixel_delta_v);

        Self {
            image_width,
            image_height,
            center,
            pixel00,
            pixel_delta_u,
            pixel_delta_v,
        }
    }

    /// Returns the ray from the eye through the center of the pixel in column `i` and row `j`,
    /// counted from 0 at the upper left. Its `direction` ends at that center, where `t` = 1. A
    /// pixel beyond the picture has its ray, too.
    #[inline]
    pub fn ray(&self, i: u32, j: u32) -> Ray {
        let pixel_center =
            self.pixel00 + f64::from(i) * self.pixel_delta_u + f64::from(j) * self.pixel_delta_v;
        Ray::new(self.center, pixel_center - self.center)
    }
}
