//! Where things are: a picture that is turned, a disc that is too large or too small.

use slips::SphereCount;

use super::view::View;
use crate::pixels::distance;

/// One pixel in so many may be another in a picture that is turned.
const TURNED: usize = 20;
/// Levels that were shown by rows in another order may be off by so many.
const NEAR: u16 = 2;
/// A sky may be off by so many and still be one.
const SKY: u16 = 8;
/// A column or a row in so many of a disc may be another by a rounding.
const ROUND: u32 = 20;

impl View<'_> {
    /// Returns true if it is the right picture upside down or in a mirror.
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
            Some("It is the right picture upside down.".to_owned())
        } else if is_like(|i, j, width, _| (width - 1 - i, j)) {
            Some("It is the right picture in a mirror: left is right.".to_owned())
        } else {
            None
        }
    }

    /// From where to where the one sphere reaches, if the sky around it is right.
    pub(super) fn disc(&self) -> Option<String> {
        let is_sphere_right = !self.wrong.iter().any(|n| self.is_hit(*n));
        if self.task.chapter.sphere_count() != SphereCount::One || is_sphere_right {
            return None;
        }
        let sky = self.task.of_sky(self.reading.width, self.reading.height);
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

    /// The first and last column and row of such pixels.
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
