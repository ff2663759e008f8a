//! The difference of two pictures, to the last bit: as numbers, and as a picture beside both.
//!
//! Tests, pages and the judge stand on it.

pub mod png;
pub mod snapshot;

use std::iter;

use common::rtweekend::Picture;

/// The result of comparing two pictures: equal, of different sizes, or different in some pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// The pictures have the same size and the same pixels.
    Equal,
    /// Width or height differs; no pixel was compared.
    AnotherSize,
    /// The pictures have the same size, and at least one pixel differs.
    Pixels(Difference),
}

/// The count, place and size of the differences between two pictures of the same size; at least one
/// pixel differs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// Number of pixels that differ in at least one component.
    pub count: usize,
    /// Number of pixels of each picture.
    pub total: usize,
    /// Largest difference of a component, in levels, from 1 to 255.
    pub levels: u8,
    /// First and last column in which a pixel differs, counted from 0.
    pub columns: [u32; 2],
    /// First and last row in which a pixel differs, counted from 0 at the top.
    pub rows: [u32; 2],
    /// Column and row, counted from 0, of the first pixel that differs, row by row from the top
    /// left.
    pub first: [u32; 2],
}

/// A pixel in which two pictures differ.
#[derive(Clone, Copy, Debug)]
pub struct DifferingPixel {
    /// Column, counted from 0.
    pub column: u32,
    /// Row, counted from 0 at the top.
    pub row: u32,
    /// Red, green and blue in the expected picture, in levels from 0 to 255.
    pub expected: [u8; 3],
    /// Red, green and blue in the actual picture, in levels from 0 to 255.
    pub actual: [u8; 3],
}

impl Comparison {
    /// Compares the right picture with a reader's, pixel by pixel; no pixel is compared if their
    /// sizes differ.
    pub fn of(expected: &Picture, actual: &Picture) -> Self {
        let sizes = [expected, actual].map(|picture| [picture.width(), picture.height()]);
        if sizes[0] != sizes[1] {
            return Self::AnotherSize;
        }
        let mut difference: Option<Difference> = None;
        for pixel in differing_pixels(expected, actual) {
            let (column, row) = (pixel.column, pixel.row);
            let found = difference.get_or_insert(Difference {
                count: 0,
                total: expected.rgb().len() / 3,
                levels: 0,
                columns: [column; 2],
                rows: [row; 2],
                first: [column, row],
            });
            found.count += 1;
            for (expected, actual) in pixel.expected.into_iter().zip(pixel.actual) {
                found.levels = found.levels.max(expected.abs_diff(actual));
            }
            found.columns = [found.columns[0].min(column), found.columns[1].max(column)];
            found.rows[1] = row;
        }
        difference.map_or(Self::Equal, Self::Pixels)
    }
}

/// Iterates over the pixels in which two pictures of the same size differ, row by row from the top
/// left; nothing if they are equal. The sizes are not checked.
pub fn differing_pixels<'a>(
    expected: &'a Picture,
    actual: &'a Picture,
) -> impl Iterator<Item = DifferingPixel> + 'a {
    let width = expected.width();
    let (expected, _) = expected.rgb().as_chunks::<3>();
    let (actual, _) = actual.rgb().as_chunks::<3>();
    (0u32..)
        .zip(expected.iter().zip(actual))
        .filter(|(_, (expected, actual))| expected != actual)
        .map(move |(n, (&expected, &actual))| DifferingPixel {
            column: n % width,
            row: n / width,
            expected,
            actual,
        })
}

/// Draws the pixels that differ in red, on a faint gray copy of the expected picture; `None` if the
/// sizes differ.
pub fn difference_picture(expected: &Picture, actual: &Picture) -> Option<Picture> {
    if Comparison::of(expected, actual) == Comparison::AnotherSize {
        return None;
    }
    let (pixels, _) = expected.rgb().as_chunks::<3>();
    let mut rgb: Vec<u8> = pixels
        .iter()
        .flat_map(|pixel| {
            let sum: u16 = pixel.iter().map(|&level| u16::from(level)).sum();
            iter::repeat_n(192 + (sum / 3 / 4) as u8, 3)
        })
        .collect();
    let (width, height) = (expected.width(), expected.height());
    for pixel in differing_pixels(expected, actual) {
        let at = 3 * (pixel.row as usize * width as usize + pixel.column as usize);
        rgb[at..at + 3].copy_from_slice(&[220, 0, 0]);
    }
    Picture::from_rgb(width, height, rgb)
}

/// Draws three panels in a row: the expected picture, the actual one, and [`difference_picture`],
/// which is left out if the sizes differ.
pub fn panels(expected: &Picture, actual: &Picture) -> Picture {
    let difference = difference_picture(expected, actual);
    let panels: Vec<&Picture> = [expected, actual].into_iter().chain(&difference).collect();
    in_a_row(&panels)
}

/// Draws pictures in a row, on white, with a gap between them.
fn in_a_row(pictures: &[&Picture]) -> Picture {
    const GAP: u32 = 8;
    let width: u32 = pictures.iter().map(|picture| picture.width() + GAP).sum();
    let height = pictures.iter().map(|picture| picture.height()).max();
    let (width, height) = (width.saturating_sub(GAP), height.unwrap_or_default());
    let mut rgb = vec![255; 3 * width as usize * height as usize];
    let mut left = 0;
    for picture in pictures {
        let rows = picture.rgb().chunks(3 * picture.width() as usize);
        for (row, line) in rows.zip(rgb.chunks_mut(3 * width as usize)) {
            line[left..left + row.len()].copy_from_slice(row);
        }
        left += 3 * (picture.width() + GAP) as usize;
    }
    Picture::from_rgb(width, height, rgb).expect("three bytes a pixel")
}
