//! Traces: what the pixels of a file alone tell of its way.

use std::cmp::Reverse;
use std::collections::BTreeSet;
use std::ops::RangeInclusive;

use super::{Degradation, off};
use crate::bits::Pixel;
use crate::evidence::Evidence;
use crate::reading::Reading;

/// Weights of red, green and blue in the gray of old television, and of most programs.
pub(super) const REC_601: [f64; 3] = [0.299, 0.587, 0.114];
/// In that of newer television.
pub(super) const REC_709: [f64; 3] = [0.2126, 0.7152, 0.0722];
/// As many colors as the smallest palettes have, and as a byte can tell apart: a picture
/// of less was not made of one of the book's by choosing the nearest.
const COLORS: RangeInclusive<usize> = 6..=256;
/// How many of the sharpest edges may be a side of a frame.
const SIDES: usize = 8;
/// So many lines within an edge nothing of it is left, be it compressed.
const WITHIN: u32 = 3;
/// At least this part of the width is no frame.
const LEAST: u32 = 3;

/// Whether no pixel has a color.
pub(super) fn gray(reading: &Reading, weights: [f64; 3]) -> Option<Degradation> {
    let is_gray = |[red, green, blue]: &Pixel| red == green && green == blue;
    let is_gray = reading.pixels.iter().all(is_gray);
    is_gray.then_some(Degradation::Gray(weights))
}

/// Whether there are as few colors as in a GIF.
pub(crate) fn palette(reading: &Reading) -> Option<Degradation> {
    let colors = colors(reading).len();
    COLORS
        .contains(&colors)
        .then_some(Degradation::Palette { colors })
}

/// The different colors.
pub(super) fn colors(reading: &Reading) -> BTreeSet<Pixel> {
    reading.pixels.iter().copied().collect()
}

/// The rectangle of the chapter's shape with the sharpest sides.
pub(super) fn framed(evidence: &Evidence) -> Option<Degradation> {
    let reading = evidence.reading;
    let [columns, rows] = [
        Edges::between_columns(reading),
        Edges::between_rows(reading),
    ];
    let is_plain = |[left, right, above, below]: [u32; 4]| {
        let pixel = |i: u32, j: u32| reading.pixels[(j * reading.width + i) as usize];
        let mut places = (above..below).flat_map(|j| (left..right).map(move |i| (i, j)));
        places.all(|(i, j)| pixel(i, j) == pixel(left, above))
    };
    let mut best = None;
    for (left, right) in columns.pairs() {
        let width = right - left;
        for height in evidence.heights(width) {
            for above in rows.starts(height) {
                let sharp = columns.sharp(left) + columns.sharp(right);
                let sharp = sharp + rows.sharp(above) + rows.sharp(above + height);
                let is_sharper = best.is_none_or(|(most, _)| sharp > most);
                let is_part = (width, height) != (reading.width, reading.height);
                if is_sharper && is_part && !is_plain([left, right, above, above + height]) {
                    let (size, corner) = ((width, height), (left, above));
                    let quality = None;
                    best = Some((
                        sharp,
                        Degradation::Framed {
                            size,
                            corner,
                            quality,
                        },
                    ));
                }
            }
        }
    }
    best.map(|(_, framed)| framed)
}

/// How far neighboring columns, or rows, are off on the average.
struct Edges {
    sharp: Vec<u32>,
    /// The sharpest, and the edges of the picture.
    sharpest: Vec<u32>,
}

impl Edges {
    fn between_columns(reading: &Reading) -> Self {
        let column = |i: u32| (0..reading.height).map(move |j| j * reading.width + i);
        Self::new(reading, reading.width, column)
    }

    fn between_rows(reading: &Reading) -> Self {
        let row = |j: u32| (0..reading.width).map(move |i| j * reading.width + i);
        Self::new(reading, reading.height, row)
    }

    fn new<L: Iterator<Item = u32>>(
        reading: &Reading,
        count: u32,
        line: impl Fn(u32) -> L,
    ) -> Self {
        let sharp = |at: u32| {
            let pairs = line(at - 1).zip(line(at));
            let pairs = pairs.map(|(one, other)| [one, other].map(|n| reading.pixels[n as usize]));
            let (mut sum, mut all) = (0, 0);
            for [one, other] in pairs {
                sum += off(one, other);
                all += 1;
            }
            64 * sum / all
        };
        let sharp: Vec<u32> = (0..=count)
            .map(|at| if at == 0 || at == count { 0 } else { sharp(at) })
            .collect();
        let mut sharpest: Vec<u32> = (1..count).collect();
        sharpest.sort_by_key(|&at| Reverse(sharp[at as usize]));
        sharpest.truncate(SIDES);
        sharpest.extend([0, count]);
        Self { sharp, sharpest }
    }

    fn sharp(&self, at: u32) -> u32 {
        self.sharp[at as usize]
    }

    /// Whether something begins there, or ends: it is smoother than its edge.
    fn begins(&self, at: u32) -> bool {
        at == 0 || self.sharp(at) > self.within(at + WITHIN)
    }

    fn ends(&self, at: u32) -> bool {
        at == self.count() || self.sharp(at) > self.within(at.saturating_sub(WITHIN))
    }

    fn within(&self, at: u32) -> u32 {
        self.sharp(at.min(self.count())) * 5 / 4
    }

    fn count(&self) -> u32 {
        self.sharp.len() as u32 - 1
    }

    fn pairs(&self) -> impl Iterator<Item = (u32, u32)> {
        let least = self.count() / LEAST;
        let all = self
            .sharpest
            .iter()
            .flat_map(|&one| self.sharpest.iter().map(move |&other| (one, other)));
        let all = all.filter(move |&(one, other)| one + least.max(1) <= other);
        all.filter(|&(one, other)| self.begins(one) && self.ends(other))
    }

    /// Where something of that length may begin, with a sharp edge at either end.
    fn starts(&self, length: u32) -> impl Iterator<Item = u32> {
        let ends = self
            .sharpest
            .iter()
            .filter_map(move |end| end.checked_sub(length));
        let starts = self.sharpest.iter().copied().chain(ends);
        let starts = starts.filter(move |start| start + length <= self.count());
        starts.filter(move |&start| self.begins(start) && self.ends(start + length))
    }
}
