//! A picture as large pixels.

use common::rtweekend::*;
use glam::DVec2;

use crate::svg::Svg;

/// A picture on the sheet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    /// The upper left corner.
    pub(crate) corner: DVec2,
    /// The side of a pixel.
    pub(crate) side: f64,
}

impl Frame {
    /// Draws `picture`, and a thin line around it.
    pub(crate) fn draw(&self, svg: &mut Svg, picture: &Picture) {
        svg.group("pixels", |svg| self.pixels(svg, picture));
        let size = DVec2::new(f64::from(picture.width()), f64::from(picture.height()));
        svg.rect("faint thin", self.corner, self.side * size);
    }

    /// Draws the pixels. Neighbors in a row that are equal become one.
    fn pixels(&self, svg: &mut Svg, picture: &Picture) {
        // Strip by strip: so small a picture needs no threads, and a page has none.
        let mut rgb = Vec::new();
        (0..picture.strips()).for_each(|strip| picture.push_strip(strip, &mut rgb));
        for (row, j) in rgb.chunks(3 * picture.width() as usize).zip(0..) {
            let mut i = 0;
            for equal in row.as_chunks::<3>().0.chunk_by(|one, other| one == other) {
                let corner = self.corner + self.side * DVec2::new(f64::from(i), f64::from(j));
                let run = equal.len() as i32;
                let size = self.side * DVec2::new(f64::from(run), 1.0);
                svg.pixel(corner, size, equal[0]);
                i += run;
            }
        }
    }

    /// Where a ray from the eye of `camera` goes through the picture.
    pub(crate) fn seen(&self, camera: &Camera, point: Point3) -> DVec2 {
        let way = point - camera.center;
        let on_viewport = camera.center + way * (camera.pixel00.z - camera.center.z) / way.z;
        let from_first = on_viewport - camera.pixel00;
        let column = from_first.x / camera.pixel_delta_u.x + 0.5;
        let row = from_first.y / camera.pixel_delta_v.y + 0.5;
        self.corner + self.side * DVec2::new(column, row)
    }
}
