//! A coarse map: where pixels differ, as a few lines of text.

use crate::comparison::differing_pixels;
use common::rtweekend::Picture;

/// Letters in a line of the map.
const COLUMNS: u32 = 48;
/// No higher than this, even for a picture that is much higher than wide.
const MOST_LINES: u32 = 27;

/// A line for each strip of the picture; the darker a letter, the more of its
/// pixels differ. A point means that none does.
pub(crate) fn map(right: &Picture, yours: &Picture) -> Vec<String> {
    let (width, height) = (right.width(), right.height());
    let columns = COLUMNS.min(width);
    // A letter is about twice as high as wide.
    let shape = f64::from(columns) * f64::from(height) / f64::from(width) / 2.0;
    let lines = (shape.round() as u32).clamp(1, MOST_LINES.min(height));
    let cell = |i: u32, j: u32| {
        let part = |n: u32, of: u32, cells: u32| u64::from(n) * u64::from(cells) / u64::from(of);
        (part(j, height, lines) * u64::from(columns) + part(i, width, columns)) as usize
    };
    let mut counts = vec![0; (columns * lines) as usize];
    for (i, j, ..) in differing_pixels(right, yours) {
        counts[cell(i, j)] += 1;
    }
    let most = f64::from(width) / f64::from(columns) * f64::from(height) / f64::from(lines);
    counts
        .chunks(columns as usize)
        .map(|line| {
            line.iter()
                .map(|&count| letter(f64::from(count) / most))
                .collect()
        })
        .collect()
}

fn letter(share: f64) -> char {
    match share {
        0.0 => '·',
        ..0.25 => '░',
        ..0.5 => '▒',
        ..0.75 => '▓',
        _ => '█',
    }
}
