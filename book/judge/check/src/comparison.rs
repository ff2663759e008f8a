//! Pixel-by-pixel comparison: where two pictures differ.

use common::rtweekend::Picture;

/// What sets `actual` apart from `expected`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// Every pixel is the same.
    Equal,
    /// The sizes differ: width and height in pixels, expected first.
    Size((u32, u32), (u32, u32)),
    /// The sizes are the same, some pixels are not.
    Pixels(Difference),
}

/// How many pixels differ, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// How many pixels differ in at least one component.
    pub count: usize,
    /// How many pixels the picture has.
    pub total: usize,
    /// The farthest that a component is off, in levels.
    pub levels: u8,
    /// The first and last column in which a pixel differs.
    pub columns: (u32, u32),
    /// The first and last row in which a pixel differs.
    pub rows: (u32, u32),
    /// Column and row of the first pixel that differs, in reading order.
    pub first: (u32, u32),
}

impl Comparison {
    /// Compares pixel by pixel, to the last bit.
    pub fn of(expected: &Picture, actual: &Picture) -> Self {
        let sizes = [expected, actual].map(|picture| (picture.width(), picture.height()));
        if sizes[0] != sizes[1] {
            return Self::Size(sizes[0], sizes[1]);
        }
        let mut difference: Option<Difference> = None;
        for (i, j, expected, actual) in differing_pixels(expected, actual) {
            let found = difference.get_or_insert(Difference {
                count: 0,
                total: sizes[0].0 as usize * sizes[0].1 as usize,
                levels: 0,
                columns: (i, i),
                rows: (j, j),
                first: (i, j),
            });
            found.count += 1;
            for (expected, actual) in expected.into_iter().zip(actual) {
                found.levels = found.levels.max(expected.abs_diff(actual));
            }
            found.columns = (found.columns.0.min(i), found.columns.1.max(i));
            found.rows.1 = j;
        }
        difference.map_or(Self::Equal, Self::Pixels)
    }
}

/// Column, row, expected and actual color of each pixel that differs, row by
/// row. The pictures must be of the same size.
pub fn differing_pixels<'a>(
    expected: &'a Picture,
    actual: &'a Picture,
) -> impl Iterator<Item = (u32, u32, [u8; 3], [u8; 3])> + 'a {
    let width = expected.width();
    let (expected, _) = expected.rgb().as_chunks::<3>();
    let (actual, _) = actual.rgb().as_chunks::<3>();
    (0u32..)
        .zip(expected.iter().zip(actual))
        .filter(|(_, (expected, actual))| expected != actual)
        .map(move |(n, (&expected, &actual))| (n % width, n / width, expected, actual))
}
