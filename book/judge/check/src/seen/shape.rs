//! Observations about places: a picture that is turned, a disc that is too large or too small.

use slips::SphereCount;

use super::side_by_side::SideBySide;
use crate::pixels::distance;

/// A picture is the turned right one if at most one in so many pixels differs from that.
const TURNED: usize = 20;
/// How many levels a pixel of a turned picture may be off, as one of the right picture may: more
/// would call one that is moved by a row a turned one.
const NEAR: u16 = 1;
/// How many levels a pixel of the sky may be off.
const SKY: u16 = 8;
/// How many times the error in the place of a disc fits into the disc, if it is rounding.
const ROUND: u32 = 20;

impl SideBySide<'_> {
    /// Notes that the picture is the right one upside down or in a mirror.
    pub(super) fn turned(&self) -> Option<String> {
        let (width, height) = (self.reading.width, self.reading.height);
        let is_like = |place: fn(u32, u32, u32, u32) -> (u32, u32)| {
            let is_off = |n: &&u32| {
                let (i, j) = place(**n % width, **n / width, width, height);
                distance(self.expected(j * width + i), self.found(**n)) > NEAR
            };
            // A picture that is nearly its own mirror image is none in a mirror.
            let off = self.places.iter().filter(is_off).count();
            TURNED * off <= self.places.len() && TURNED * off <= self.wrong.len()
        };
        if is_like(|i, j, _, height| (i, height - 1 - j)) {
            Some("The picture is the right one upside down.".to_owned())
        } else if is_like(|i, j, width, _| (width - 1 - i, j)) {
            Some("The picture is the right one in a mirror: left is right.".to_owned())
        } else {
            None
        }
    }

    /// Notes the columns and rows of all that is not sky beside those of the one sphere, if they
    /// differ. `None` if the sphere's pixels are right, or the chapter has no sphere or several.
    pub(super) fn disc(&self) -> Option<String> {
        let is_sphere_right = !self.wrong.iter().any(|n| self.is_hit(*n));
        if self.task.chapter.sphere_count() != SphereCount::One || is_sphere_right {
            return None;
        }
        let sky = self
            .task
            .sky_picture(self.reading.width, self.reading.height);
        let (sky, _) = sky.rgb().as_chunks::<3>();
        let is_disc = |pixel: &dyn Fn(u32) -> [i16; 3], n: u32| {
            distance(sky[n as usize].map(i16::from), pixel(n)) > SKY
        };
        let should = self.bounds(|n| is_disc(&|n| self.expected(n), n))?;
        let does = self.bounds(|n| is_disc(&|n| self.found(n), n))?;
        let [width, height] = [self.reading.width, self.reading.height];
        let is_all = does == [[0, width - 1], [0, height - 1]];
        let off = |axis: usize, end: usize| should[axis][end].abs_diff(does[axis][end]);
        let is_off = |axis: usize| {
            let length = should[axis][1] - should[axis][0] + 1;
            off(axis, 0).max(off(axis, 1)) * ROUND > length
        };
        if is_all || !(is_off(0) || is_off(1)) {
            return None;
        }
        let span = |[[left, right], [top, bottom]]: [[u32; 2]; 2]| {
            format!("columns {left} to {right} and rows {top} to {bottom}")
        };
        Some(format!(
            "What is not sky lies in {}; the sphere should lie in {}.",
            span(does),
            span(should)
        ))
    }

    /// Finds the first and the last column, and the first and the last row, of the pixels for which
    /// `is_meant` holds; `None` if there are none.
    fn bounds(&self, is_meant: impl Fn(u32) -> bool) -> Option<[[u32; 2]; 2]> {
        let width = self.reading.width;
        let all = (0..self.reading.pixels.len() as u32).filter(|n| is_meant(*n));
        all.fold(None, |bounds, n| {
            let (i, j) = (n % width, n / width);
            let [columns, rows] = bounds.unwrap_or([[i; 2], [j; 2]]);
            let wider = |[low, high]: [u32; 2], at: u32| [low.min(at), high.max(at)];
            Some([wider(columns, i), wider(rows, j)])
        })
    }
}
