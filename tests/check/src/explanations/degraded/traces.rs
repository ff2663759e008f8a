//! Traces: what the pixels of a file alone tell of its way.

use std::collections::BTreeSet;
use std::ops::RangeInclusive;

use super::Degradation;
use crate::bits::Pixel;
use crate::reading::Reading;

/// Weights of red, green and blue in the gray of old television, and of most programs.
pub(super) const REC_601: [f64; 3] = [0.299, 0.587, 0.114];
/// In that of newer television.
pub(super) const REC_709: [f64; 3] = [0.2126, 0.7152, 0.0722];
/// As many colors as the smallest palettes have, and as a byte can tell apart: a picture
/// of less was not made of one of the book's by choosing the nearest.
const COLORS: RangeInclusive<usize> = 6..=256;
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
