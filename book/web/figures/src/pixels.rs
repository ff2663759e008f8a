//! A picture with its pixels as large squares.

use common::rtweekend::*;
use glam::DVec2;

use crate::plane::Plane;
use crate::svg::Svg;

/// A place on the sheet for a picture whose pixels are large squares.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PixelGrid {
    /// The upper left corner of the picture.
    pub(crate) corner: DVec2,
    /// The side of a pixel.
    pub(crate) side: f64,
}

impl PixelGrid {
    pub(crate) const fn new(x: f64, y: f64, side: f64) -> Self {
        let corner = DVec2::new(x, y);
        Self { corner, side }
    }

    /// Draws the pixels of `picture`, and a thin line around it.
    pub(crate) fn draw(&self, svg: &mut Svg, picture: &Picture) {
        // Strip by strip: so small a picture needs no threads, and a page has none.
        let mut rgb = Vec::new();
        (0..picture.strips()).for_each(|strip| picture.push_strip(strip, &mut rgb));
        let [width, height] = [picture.width(), picture.height()].map(f64::from);
        svg.group("pixels", |svg| {
            for (row, j) in rgb.as_chunks().0.chunks(width as usize).zip(0..) {
                let mut i = 0.0;
                // Neighbors that are equal are one bar.
                for equal in row.chunk_by(<[u8; 3]>::eq) {
                    let corner = self.corner + self.side * DVec2::new(i, f64::from(j));
                    let run = equal.len() as f64;
                    svg.pixel(corner, self.side * DVec2::new(run, 1.0), equal[0]);
                    i += run;
                }
            }
        });
        let size = DVec2::new(width, height);
        svg.rect("faint thin", self.corner, self.side * size);
    }

    /// Returns the plane of the viewport of `camera`, so that a point of the viewport lies on its
    /// pixel.
    pub(crate) fn viewport(&self, camera: &Camera) -> Plane {
        let scale = self.side / camera.pixel_delta_u.x;
        let first = scale * DVec2::new(camera.pixel00.x, -camera.pixel00.y);
        let origin = self.corner + 0.5 * self.side - first;
        Plane { origin, scale }
    }
}
