//! Copies: files that no program has written, because their levels or their size changed on
//! the way. They are recognized, and not judged.

use common::rtweekend::Picture;

use crate::pixels::distance;
use crate::reading::Reading;

/// Compression and scaling change most pixels by no more than so many levels.
const LITTLE: u16 = 12;
/// One pixel in so many is changed by more, at an edge.
const AT_EDGES: usize = 32;
/// Of levels that are higher and lower there are at most so many times as many of the one.
const BOTH_WAYS: usize = 3;

/// What is said of a copy.
const ADVICE: &str = "Save it as PNG or PPM, at its own size, as the program wrote it.";

/// That a picture is a lossy, a scaled or a framed copy of a right one, if it is.
pub(crate) fn sentence(right: &Picture, reading: &Reading) -> Option<String> {
    let what = if is_framed(reading) {
        "It lies in a frame of one color, as a screenshot does."
    } else if is_lossy(right, reading) {
        "Levels are off up and down by little almost everywhere, as in a copy that was compressed or scaled."
    } else {
        return None;
    };
    Some(format!("{what} {ADVICE}"))
}

/// Whether much is off, almost all of it by little, and up as often as down.
fn is_lossy(right: &Picture, reading: &Reading) -> bool {
    let (right, _) = right.rgb().as_chunks::<3>();
    let (mut off, mut far, mut higher, mut lower) = (0, 0, 0, 0);
    for (right, found) in right.iter().zip(&reading.pixels) {
        let right = right.map(i16::from);
        let distance = distance(right, *found);
        off += usize::from(distance > 0);
        far += usize::from(distance > LITTLE);
        for c in 0..3 {
            higher += usize::from(found[c] > right[c]);
            lower += usize::from(found[c] < right[c]);
        }
    }
    let is_much = 4 * off > right.len() && AT_EDGES * far < right.len();
    is_much && higher.max(lower) <= BOTH_WAYS * higher.min(lower)
}

/// Whether the edge of the picture has one color, and a rectangle inside of it none of that at
/// its corners.
fn is_framed(reading: &Reading) -> bool {
    let (width, height) = (reading.width as usize, reading.height as usize);
    let color = reading.pixels[0];
    let is_other = |i: usize, j: usize| reading.pixels[j * width + i] != color;
    let has_other_in_row = |j: &usize| (0..width).any(|i| is_other(i, *j));
    let has_other_in_column = |i: &usize| (0..height).any(|j| is_other(*i, j));
    let ends = |mut all: Vec<usize>| Some([*all.first()?, all.pop()?]);
    let rows = ends((0..height).filter(has_other_in_row).collect());
    let columns = ends((0..width).filter(has_other_in_column).collect());
    let (Some([top, bottom]), Some([left, right])) = (rows, columns) else {
        return false;
    };
    let is_around = top > 0 && left > 0 && bottom + 1 < height && right + 1 < width;
    let corners = [(left, top), (right, top), (left, bottom), (right, bottom)];
    is_around && corners.into_iter().all(|(i, j)| is_other(i, j))
}
