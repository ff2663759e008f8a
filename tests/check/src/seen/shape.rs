//! Where things are: a picture that is turned, a disc that is too large or too small, and
//! levels that begin again at 0.

use slips::Room;

use super::view::View;
use crate::pixels::distance;

/// One pixel in so many may be another in a picture that is turned.
const TURNED: usize = 20;
/// Levels that were shown by rows in another order may be off by so many.
const NEAR: u16 = 2;
/// A column or a row in so many of a disc may be another by a rounding.
const ROUND: u32 = 20;
/// What lies so near to 255 and to 0 is a level that has begun again.
const END: i16 = 8;

impl View<'_> {
    /// Whether it is the right picture upside down or in a mirror.
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
        if self.scene.chapter.room() != Room::One {
            return None;
        }
        let sky = self.scene.of_sky(self.reading.width, self.reading.height);
        let (sky, _) = sky.rgb().as_chunks::<3>();
        let is_disc = |pixel: &dyn Fn(u32) -> [i16; 3], n: u32| {
            distance(sky[n as usize].map(i16::from), pixel(n)) > NEAR
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

    /// Whether levels above 255 begin again at 0: neighbors at both ends, as the right
    /// picture has none.
    pub(super) fn wrapped(&self) -> Option<String> {
        let width = self.reading.width;
        let pixels = self.reading.pixels.iter();
        let below = self.reading.pixels.iter().skip(width as usize);
        let jumps = |one: &[i16; 3], other: &[i16; 3]| {
            let is_jump = |c: usize| {
                let (low, high) = (one[c].min(other[c]), one[c].max(other[c]));
                (0..END).contains(&low) && (256 - END..256).contains(&high)
            };
            (0..3).any(is_jump)
        };
        let count = pixels
            .zip(below)
            .filter(|(one, other)| jumps(one, other))
            .count();
        let (right, _) = self.right.rgb().as_chunks::<3>();
        let right: Vec<[i16; 3]> = right.iter().map(|pixel| pixel.map(i16::from)).collect();
        let mut rights = right.iter().zip(right.iter().skip(width as usize));
        let has_none = !rights.any(|(one, other)| jumps(one, other));
        (has_none && 8 * count >= width as usize && width > 8).then(|| {
            "Levels jump from 255 to 0 from one row to the next, as where a number above 255 begins again at 0.".to_owned()
        })
    }
}
