//! Autocorrelation: the length of rows that fit each other.

use crate::bits::{Pixel, distance};
use crate::explanations::spread;
use crate::reading::Reading;

/// How many pixels are compared.
const LOOK: u32 = 600;
/// Rows that fit each other are off by so many times less than others; none is shorter.
const TIMES: f64 = 4.0;
const SHORTEST: usize = 8;

/// That rows of another length fit each other, where those of the picture's width do not.
pub(super) fn wrapped(reading: &Reading) -> Option<String> {
    let (pixels, own) = (&reading.pixels, reading.width);
    let total = pixels.len();
    let lengths = SHORTEST..=total / SHORTEST;
    let lengths = lengths.filter(|it| total.is_multiple_of(*it));
    let (least, width) = lengths
        .map(|it| (rows_differ(pixels, it), it))
        .min_by(|(one, _), (other, _)| one.total_cmp(other))?;
    (TIMES * least < rows_differ(pixels, own as usize)).then(|| {
        format!(
            "Rows of {width} pixels would fit each other, and those of {own} do not: are width and height exchanged, in the header or in the loops?"
        )
    })
}

/// By how many levels pixels differ from those below them on the average, in rows of a length.
pub(crate) fn rows_differ(pixels: &[Pixel], width: usize) -> f64 {
    let count = pixels.len().saturating_sub(width) as u32;
    let places = spread(LOOK, count).map(|n| n as usize);
    let off = places.map(|n| f64::from(distance(pixels[n], pixels[n + width])));
    off.sum::<f64>() / f64::from(count.clamp(1, LOOK))
}
