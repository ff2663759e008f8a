//! Degradation models: what happened to a picture between the program and the file.
//!
//! A hypothesis is drawn as its program draws it, degraded as the file seems to be, and
//! compared then. So a right picture stays right, and a wrong one keeps its slip's name.

mod jpeg;
mod resampled;
mod traces;

use std::collections::{HashMap, HashSet};

use common::rtweekend::Picture;

use super::Hypothesis;
use crate::bits::{Left, Pixel, distance};
use crate::evidence::Evidence;
use crate::reading::Reading;
use crate::scene::Scene;

pub use jpeg::Quality;
pub use resampled::Filter;
pub(crate) use traces::palette;

/// What happened to a picture on its way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Degradation {
    /// It was enlarged or reduced.
    Scaled {
        /// Width and height before.
        from: (u32, u32),
        /// How its pixels were mixed.
        filter: Filter,
    },
    /// Rows or columns are missing.
    Cropped {
        /// Width and height before.
        from: (u32, u32),
        /// Columns that are missing on the left, rows above.
        corner: (u32, u32),
    },
    /// Red, green and blue of each pixel were mixed with these weights.
    Gray([f64; 3]),
    /// Each pixel has the nearest of some colors, as in a GIF.
    Palette {
        /// How many there are.
        colors: usize,
    },
    /// It was compressed with loss.
    Jpeg(Quality),
}

/// That a file was changed on its way: one in some hundred, as many as have one slip.
const NAME: f64 = 8.0;
/// Bits of a size or a place, where some thirty are looked for.
const SIZE: f64 = 5.0;
/// One of a hundred qualities, and one of two ways to halve colors.
const QUALITY: f64 = 8.0;
/// A picture of fewer pixels across tells nothing of its way.
const SMALLEST: u32 = 16;
/// Bits of a color of a palette.
const COLOR: f64 = 24.0;

/// Finds what happened to a picture, if that did: by its pixels alone, or by what brings
/// one of the likeliest programs nearest to it.
type Search = fn(&Evidence, &[Hypothesis]) -> Option<Degradation>;

/// The surest first.
const SEARCHES: [Search; 6] = [
    |evidence, _| traces::gray(evidence.reading, traces::REC_601),
    |evidence, _| traces::gray(evidence.reading, traces::REC_709),
    |evidence, _| traces::gray(evidence.reading, [1.0 / 3.0; 3]),
    resampled::cropped,
    resampled::scaled,
    |evidence, likeliest| jpeg::compressed(evidence.reading, likeliest).map(Degradation::Jpeg),
];

/// Degradations that the picture may have gone through, each looked for when it is asked
/// for.
pub(crate) fn degradations<'a>(
    evidence: &'a Evidence,
    likeliest: &'a [Hypothesis],
) -> impl Iterator<Item = Degradation> + 'a {
    let reading = evidence.reading;
    // A program's own output goes through nothing.
    let has_a_way = evidence.known.sources.is_empty();
    let is_large = reading.width.min(reading.height) >= SMALLEST;
    let is_told = has_a_way && is_large && !evidence.has_no_levels && !reading.is_plain();
    let searches = SEARCHES.iter().filter(move |_| is_told);
    searches.filter_map(|search| search(evidence, likeliest))
}

/// The same that leave traces which a program leaves as well: a sky has few colors by itself, and
/// one without a color may be what was typed.
pub(crate) fn doubtful(reading: &Reading) -> impl Iterator<Item = Degradation> {
    let alone = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let gray = alone
        .into_iter()
        .filter_map(|weights| traces::gray(reading, weights));
    traces::palette(reading).into_iter().chain(gray)
}

impl Degradation {
    /// Width and height before.
    pub(crate) fn size(self, reading: &Reading) -> (u32, u32) {
        match self {
            Self::Scaled { from, .. } | Self::Cropped { from, .. } => from,
            Self::Gray(_) | Self::Palette { .. } | Self::Jpeg(_) => (reading.width, reading.height),
        }
    }

    /// Whether pixels became others, so that single ones tell little.
    pub(crate) fn is_lossy(self) -> bool {
        match self {
            Self::Scaled { .. } | Self::Palette { .. } | Self::Jpeg(_) => true,
            Self::Cropped { .. } | Self::Gray(_) => false,
        }
    }

    /// About how many pixels one rounding changes: a block, or a row's part.
    pub(crate) fn together(self) -> f64 {
        match self.quality() {
            Some(quality) if quality.has_half_colors => 256.0,
            _ if self.is_lossy() => 64.0,
            _ => 1.0,
        }
    }

    /// How it was compressed, if it was.
    fn quality(self) -> Option<Quality> {
        match self {
            Self::Jpeg(quality) => Some(quality),
            _ => None,
        }
    }

    /// Bits that tell it.
    pub(crate) fn name(self) -> f64 {
        let compressed = self.quality().map_or(0.0, |_| QUALITY);
        NAME + compressed
            + match self {
                Self::Scaled { .. } => SIZE + 2.0,
                Self::Cropped { .. } => 3.0 * SIZE,
                Self::Gray(_) => 2.0,
                Self::Palette { colors } => COLOR * colors as f64,
                Self::Jpeg(_) => 0.0,
            }
    }

    /// The pixel before that tells most of the nth one; `None` in a frame.
    pub(crate) fn source(self, n: u32, reading: &Reading) -> Option<u32> {
        let (i, j) = (n % reading.width, n / reading.width);
        match self {
            Self::Scaled {
                from: (width, height),
                ..
            } => {
                let nearest =
                    |at: u32, before: u32, after: u32| (2 * at + 1) * before / (2 * after);
                let row = nearest(j, height, reading.height);
                Some(row * width + nearest(i, width, reading.width))
            }
            Self::Cropped {
                from: (width, _),
                corner: (left, above),
            } => Some((j + above) * width + i + left),
            Self::Gray(_) | Self::Palette { .. } | Self::Jpeg(_) => Some(n),
        }
    }

    /// About what becomes of a pixel.
    pub(crate) fn color(self, pixel: Pixel) -> Pixel {
        let Self::Gray(weights) = self else {
            return pixel;
        };
        let weighted = weights
            .iter()
            .zip(pixel)
            .map(|(weight, level)| weight * f64::from(level));
        [(weighted.sum::<f64>() + 0.5) as i16; 3]
    }

    /// What becomes of the right picture of a scene.
    pub(crate) fn of_picture(self, scene: &Scene, reading: &Reading) -> Picture {
        let (width, height) = self.size(reading);
        let drawn = Reading::of(&scene.right(width, height)).pixels;
        let degraded = Reading {
            pixels: self.of(&drawn, reading),
            encoding: None,
            ..*reading
        };
        degraded.picture()
    }

    /// What becomes of a whole picture.
    pub(crate) fn of(self, drawn: &[Pixel], reading: &Reading) -> Vec<Pixel> {
        let placed = match self {
            Self::Scaled { from, filter } => resampled::resized(drawn, from, reading, filter),
            Self::Palette { .. } => in_palette(drawn, reading),
            _ => (0..)
                .zip(&reading.pixels)
                .map(|(n, found)| {
                    let source = self.source(n, reading);
                    source.map_or(*found, |source| self.color(drawn[source as usize]))
                })
                .collect(),
        };
        let Some(quality) = self.quality() else {
            return placed;
        };
        jpeg::through(&placed, reading, quality)
    }
}

/// What a picture leaves of a file of few colors: how many of these are nearer to each pixel than
/// the one that it has. Whoever chose them, and however they were mixed, few are.
pub(super) fn left_in_palette(reading: &Reading, drawn: &[Pixel]) -> Left {
    let palette: Vec<Pixel> = traces::colors(reading).into_iter().collect();
    // A picture that has no more colors by itself was not made one of few.
    let own: HashSet<Pixel> = drawn.iter().copied().collect();
    let is_of_few = own.len() <= 2 * palette.len();
    let mut known: HashMap<(Pixel, Pixel), usize> = HashMap::new();
    let mut counts = [0_u32; 9];
    let (mut bits, mut far) = (0.0, 0);
    for pair in drawn.iter().copied().zip(reading.pixels.iter().copied()) {
        let rank = *known.entry(pair).or_insert_with(|| rank(pair, &palette));
        let digits = (usize::BITS - rank.leading_zeros()) as usize;
        counts[digits] += 1;
        bits += digits.saturating_sub(1) as f64;
        far += usize::from(rank * rank > 4 * palette.len());
    }
    let all = drawn.len() as f64;
    for count in counts.iter().filter(|count| **count > 0) {
        bits += f64::from(*count) * (all / f64::from(*count)).log2() + all.log2();
    }
    Left {
        bits: if is_of_few { f64::INFINITY } else { bits },
        off: far,
        far,
        is_both_ways: false,
        is_one_by_one: false,
        part: None,
    }
}

/// How many colors are nearer to a pixel than the one that was found.
fn rank((drawn, found): (Pixel, Pixel), palette: &[Pixel]) -> usize {
    let most = apart(drawn, found);
    let is_nearer = |color: &&Pixel| apart(drawn, **color) < most;
    palette.iter().filter(is_nearer).count()
}

/// The square of the distance of two colors.
fn apart(one: Pixel, other: Pixel) -> i64 {
    let off = [0, 1, 2].map(|c| i64::from(one[c]) - i64::from(other[c]));
    off.map(|off| off * off).iter().sum()
}

/// Each pixel in the nearest color that the file has.
fn in_palette(drawn: &[Pixel], reading: &Reading) -> Vec<Pixel> {
    let palette = traces::colors(reading);
    let mut known: HashMap<Pixel, Pixel> = HashMap::new();
    let nearest = |pixel: Pixel| {
        let nearest = palette.iter().min_by_key(|color| apart(**color, pixel));
        nearest.copied().unwrap_or(pixel)
    };
    let mut nearest = |pixel: Pixel| *known.entry(pixel).or_insert_with(|| nearest(pixel));
    drawn.iter().map(|&pixel| nearest(pixel)).collect()
}

/// A pixel this far off may be another color for any reason.
const FAR: u32 = 24;

/// How far a pixel is off, up to that.
fn off(drawn: Pixel, found: Pixel) -> u32 {
    u32::from(distance(drawn, found)).min(FAR)
}
