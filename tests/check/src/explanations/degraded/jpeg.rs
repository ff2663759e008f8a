//! JPEG without its bits: colors to luma and chroma, cosines, and back, which loses what
//! the file lost (ITU T.81, with the tables of its annex K scaled as libjpeg does it).

use std::cmp::Reverse;
use std::f32::consts::PI;
use std::sync::LazyLock;

use super::Hypothesis;
use crate::bits::{Left, Pixel};
use crate::explanations::spread;
use crate::reading::Reading;

/// How much is lost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quality {
    /// From 1 to 100, as libjpeg counts it.
    pub percent: u8,
    /// Whether colors have half the resolution each way.
    pub has_half_colors: bool,
    /// Whether brightness and colors are integers before they become cosines, as in libjpeg; in
    /// stb_image_write, which many programs have with them, they are not.
    pub has_integers: bool,
}

/// An 8 × 8 block of a component, row by row.
type Block = [f32; 64];

/// How coarsely each cosine of brightness is kept at quality 50.
const LUMA: [u8; 64] = [
    16, 11, 10, 16, 24, 40, 51, 61, 12, 12, 14, 19, 26, 58, 60, 55, //
    14, 13, 16, 24, 40, 57, 69, 56, 14, 17, 22, 29, 51, 87, 80, 62, //
    18, 22, 37, 56, 68, 109, 103, 77, 24, 35, 55, 64, 81, 104, 113, 92, //
    49, 64, 78, 87, 103, 121, 120, 101, 72, 92, 95, 98, 112, 100, 103, 99,
];
/// How coarsely those of color are: the rest is 99.
const CHROMA: [[u8; 4]; 4] = [
    [17, 18, 24, 47],
    [18, 21, 26, 66],
    [24, 26, 56, 99],
    [47, 66, 99, 99],
];

/// Qualities that are looked for.
const QUALITIES: std::ops::RangeInclusive<u8> = 30..=98;
/// Cosines are sums of 64 products of `f32`.
const ROUNDING: f32 = 1e-3;
/// A square this far off is another color, or an edge elsewhere.
const FAR: f32 = 8.0;
/// What is less far by a smaller part may be so by roundings.
const NEARER: f32 = 0.95;
/// In how many blocks, which choose the quality.
const BLOCKS: u32 = 60;

/// The quality with which a program comes nearest.
pub(super) fn compressed(reading: &Reading, likeliest: &[Hypothesis]) -> Option<Quality> {
    let [integers, floats] = [true, false].map(|it| nearest(reading, likeliest, it));
    let nearest = match (integers, floats) {
        (Some(integers), Some(floats)) if floats.off >= NEARER * integers.off => integers,
        (integers, floats) => floats.or(integers)?,
    };
    let drawn = nearest.program.drawn(reading)?;
    // Saturated colors make the cosines of the file others than those that were kept.
    let near = nearest.percent - 1..=nearest.percent + 1;
    let all = near.flat_map(|percent| {
        [false, true].map(|has_half_colors| Quality {
            percent,
            has_half_colors,
            has_integers: nearest.has_integers,
        })
    });
    let left = |quality: &Quality| {
        let bits = Left::of(reading, &through(&drawn, reading, *quality)).bits;
        bits as u64
    };
    all.min_by_key(left)
}

/// A program whose picture comes near by a quality.
struct Near<'a> {
    program: &'a Hypothesis,
    percent: u8,
    has_integers: bool,
    /// How far its cosines are from those of the file, beside what is lost at full quality.
    off: f32,
}

/// The quality with which a program's brightness comes nearest, if anything tells of one.
fn nearest<'a>(
    reading: &Reading,
    likeliest: &'a [Hypothesis],
    has_integers: bool,
) -> Option<Near<'a>> {
    let grid = Grid::of(reading);
    let luma = luma(&grid.filled(&reading.pixels), grid.width, has_integers);
    let some = luma.some(&grid);
    let found: Vec<_> = some.map(|at| (at, cosines(&luma.block(at)))).collect();
    let (mut best, mut without): (Option<Near>, f32) = (None, f32::MAX);
    for program in likeliest {
        let Some(output) = program.output(reading) else {
            continue;
        };
        let block = |(i, j): (usize, usize)| -> Block {
            let at = |n: usize| grid.place(luma.place(i + n % 8, j + n / 8) as u32);
            std::array::from_fn(|n| brightness(program.pixel(&output, at(n)), has_integers))
        };
        let luma: Vec<Block> = found.iter().map(|(at, _)| cosines(&block(*at))).collect();
        let off = |percent: u8| -> f32 {
            let table = table(luma_at, percent);
            let pairs = luma.iter().zip(&found);
            pairs
                .map(|(drawn, (_, found))| off(drawn, found, &table))
                .sum()
        };
        without = without.min(off(100));
        let offs = QUALITIES.map(|percent| (off(percent), percent));
        let (off, percent) = offs.min_by(|one, other| one.0.total_cmp(&other.0))?;
        // The first is right, and a picture that is another somewhere does not have its quality.
        if best.as_ref().is_none_or(|best| off < NEARER * best.off) {
            best = Some(Near {
                program,
                percent,
                has_integers,
                off,
            });
        }
    }
    // Where nothing is lost at full quality, that is no number, and tells of none.
    let best = best.map(|it| Near {
        off: it.off / without,
        ..it
    });
    best.filter(|it| it.off < NEARER)
}

/// How far cosines that are kept as coarsely as that are from those of the file.
fn off(drawn: &Block, found: &Block, table: &Block) -> f32 {
    let off = |n: usize| kept(drawn[n], table[n]) - found[n];
    (0..64).map(|n| off(n).powi(2).min(FAR)).sum()
}

/// The nearest multiple of the step; what a sum of floats leaves below a half is a half.
fn kept(cosine: f32, step: f32) -> f32 {
    (cosine.abs() / step + 0.5 + ROUNDING).floor() * step * cosine.signum()
}

/// A picture as JPEG gives it back.
pub(super) fn through(drawn: &[Pixel], reading: &Reading, quality: Quality) -> Vec<Pixel> {
    let grid = Grid::of(reading);
    let filled = (0..).zip(through_blocks(&grid.filled(drawn), grid.width, quality));
    let inside = filled.filter(|(n, _)| grid.is_inside(*n));
    inside.map(|(_, pixel)| pixel).collect()
}

/// The blocks of a file, as far as a picture lies in them that may begin within the first.
struct Grid {
    /// Columns and rows of the first block that lie before the picture.
    before: (u32, u32),
    width: u32,
    height: u32,
}

/// Where colors are halved, four blocks are one.
const BLOCK: u32 = 16;

impl Grid {
    fn of(reading: &Reading) -> Self {
        let (left, above) = reading.before;
        let before = (left % BLOCK, above % BLOCK);
        Self {
            before,
            width: reading.width + before.0,
            height: reading.height + before.1,
        }
    }

    /// The picture's pixel at the nth place, or the nearest to it.
    fn place(&self, n: u32) -> u32 {
        let (left, above) = self.before;
        let (i, j) = (n % self.width, n / self.width);
        j.saturating_sub(above) * (self.width - left) + i.saturating_sub(left)
    }

    fn is_inside(&self, n: u32) -> bool {
        n % self.width >= self.before.0 && n / self.width >= self.before.1
    }

    fn filled(&self, pixels: &[Pixel]) -> Vec<Pixel> {
        let all = 0..self.width * self.height;
        all.map(|n| pixels[self.place(n) as usize]).collect()
    }
}

fn through_blocks(drawn: &[Pixel], width: u32, quality: Quality) -> Vec<Pixel> {
    let has_integers = quality.has_integers;
    let luma = luma(drawn, width, has_integers).kept(&table(luma_at, quality.percent));
    let [blue, red] = chroma(drawn, width, has_integers).map(|plane| {
        let table = table(chroma_at, quality.percent);
        match quality.has_half_colors {
            true => plane
                .halved(has_integers)
                .kept(&table)
                .doubled(luma.width, luma.height),
            false => plane.kept(&table),
        }
    });
    let pixels = luma.values.iter().zip(blue.values.iter().zip(&red.values));
    let pixels = pixels.map(|(luma, (blue, red))| {
        let luma = luma + 128.0;
        [
            luma + (1.402 * red).round(),
            luma + (-0.344_136 * blue - 0.714_136 * red).round(),
            luma + (1.772 * blue).round(),
        ]
    });
    pixels
        .map(|pixel| pixel.map(|level| level.clamp(0.0, 255.0) as i16))
        .collect()
}

/// How coarsely each cosine is kept, from the table of quality 50.
fn table(at: fn(usize) -> u8, percent: u8) -> Block {
    let percent = f32::from(percent);
    let scale = match percent < 50.0 {
        true => 5000.0 / percent,
        false => 200.0 - 2.0 * percent,
    };
    let step = |n: usize| {
        ((f32::from(at(n)) * scale.floor() + 50.0) / 100.0)
            .floor()
            .clamp(1.0, 255.0)
    };
    std::array::from_fn(step)
}

fn luma_at(n: usize) -> u8 {
    LUMA[n]
}

fn chroma_at(n: usize) -> u8 {
    let row = CHROMA.get(n / 8).and_then(|row| row.get(n % 8));
    row.copied().unwrap_or(99)
}

/// One component of a picture, around 0.
struct Plane {
    width: usize,
    height: usize,
    values: Vec<f32>,
}

fn luma(pixels: &[Pixel], width: u32, has_integers: bool) -> Plane {
    Plane::of(pixels, width, |pixel| brightness(pixel, has_integers))
}

fn brightness(pixel: Pixel, has_integers: bool) -> f32 {
    let [red, green, blue] = pixel.map(f32::from);
    kept_as(
        0.299 * red + 0.587 * green + 0.114 * blue - 128.0,
        has_integers,
    )
}

/// A component as a file of bytes has it, if it is one.
fn kept_as(component: f32, is_integer: bool) -> f32 {
    match is_integer {
        true => component.round().min(127.0),
        false => component,
    }
}

/// By how much blue, and red, is more than that.
fn chroma(pixels: &[Pixel], width: u32, has_integers: bool) -> [Plane; 2] {
    let weights = [[-0.168_736, -0.331_264, 0.5], [0.5, -0.418_688, -0.081_312]];
    weights.map(|weights| {
        Plane::of(pixels, width, |pixel| {
            let parts = weights.into_iter().zip(pixel);
            let sum = parts.map(|(weight, level)| weight * f32::from(level)).sum();
            kept_as(sum, has_integers)
        })
    })
}

impl Plane {
    fn of(pixels: &[Pixel], width: u32, component: impl Fn(Pixel) -> f32) -> Self {
        let width = width as usize;
        Self {
            width,
            height: pixels.len() / width,
            values: pixels.iter().map(|&pixel| component(pixel)).collect(),
        }
    }

    /// Where the value of a column and row stands; beyond the edge, the nearest one.
    fn place(&self, i: usize, j: usize) -> usize {
        j.min(self.height - 1) * self.width + i.min(self.width - 1)
    }

    fn at(&self, i: usize, j: usize) -> f32 {
        self.values[self.place(i, j)]
    }

    /// A value for each column and row.
    fn filled(width: usize, height: usize, value: impl Fn(usize, usize) -> f32) -> Self {
        let values = (0..width * height)
            .map(|n| value(n % width, n / width))
            .collect();
        Self {
            width,
            height,
            values,
        }
    }

    /// The first columns and rows of all blocks.
    fn blocks(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let width = self.width;
        let rows = (0..self.height).step_by(8);
        rows.flat_map(move |j| (0..width).step_by(8).map(move |i| (i, j)))
    }

    /// Blocks to look at that are all of the picture, half of them with the most contrast.
    fn some(&self, grid: &Grid) -> impl Iterator<Item = (usize, usize)> {
        let is_inside = |&(i, j): &(usize, usize)| grid.is_inside((j * self.width + i) as u32);
        let mut all: Vec<_> = self.blocks().filter(is_inside).collect();
        let contrast = |at: &(usize, usize)| {
            let block = self.block(*at);
            let [low, high] = [f32::min as fn(f32, f32) -> f32, f32::max]
                .map(|one| block.into_iter().fold(block[0], one));
            Reverse((high - low) as u32)
        };
        all.sort_by_cached_key(contrast);
        let sharp = all.len().min(BLOCKS as usize / 2);
        let rest = spread(BLOCKS / 2, (all.len() - sharp) as u32).map(|n| n as usize + sharp);
        let some: Vec<_> = (0..sharp).chain(rest).map(|n| all[n]).collect();
        some.into_iter()
    }

    fn block(&self, (i, j): (usize, usize)) -> Block {
        std::array::from_fn(|n| self.at(i + n % 8, j + n / 8))
    }

    /// What is left when each cosine is rounded to a multiple of its step.
    fn kept(&self, table: &Block) -> Self {
        let [matrix, transposed] = &*COSINES;
        let mut kept = Self {
            values: vec![0.0; self.values.len()],
            ..*self
        };
        for (i, j) in self.blocks() {
            let mut block = cosines(&self.block((i, j)));
            for (cosine, step) in block.iter_mut().zip(table) {
                *cosine = self::kept(*cosine, *step);
            }
            let block = product(&product(transposed, &block), matrix);
            let (columns, rows) = (8.min(self.width - i), 8.min(self.height - j));
            for row in 0..rows {
                let from = (j + row) * self.width + i;
                let levels = block[8 * row..]
                    .iter()
                    .map(|level| (level + 0.5 + ROUNDING).floor().clamp(-128.0, 127.0));
                kept.values[from..from + columns]
                    .iter_mut()
                    .zip(levels)
                    .for_each(|(to, level)| *to = level);
            }
        }
        kept
    }

    /// The mean of each four: what is between two integers goes up in every other column.
    fn halved(&self, has_integers: bool) -> Self {
        let (width, height) = (self.width.div_ceil(2), self.height.div_ceil(2));
        Self::filled(width, height, |i, j| {
            let four = [(0, 0), (1, 0), (0, 1), (1, 1)];
            let sum: f32 = four
                .map(|(x, y)| self.at(2 * i + x, 2 * j + y))
                .iter()
                .sum();
            match has_integers {
                true => ((sum + (1 + i % 2) as f32) / 4.0).floor(),
                false => sum / 4.0,
            }
        })
    }

    /// In straight lines between the middles of each four.
    fn doubled(&self, width: usize, height: usize) -> Self {
        let near = |n: usize| {
            [
                n / 2,
                if n.is_multiple_of(2) {
                    (n / 2).saturating_sub(1)
                } else {
                    n / 2 + 1
                },
            ]
        };
        Self::filled(width, height, |column, row| {
            let ([i, beside], [j, next]) = (near(column), near(row));
            let mixed = |j| 0.75 * self.at(i, j) + 0.25 * self.at(beside, j);
            let up = if column % 2 == 0 { 8.0 } else { 7.0 } / 16.0;
            (0.75 * mixed(j) + 0.25 * mixed(next) + up).floor()
        })
    }
}

/// The matrix of the transform, and its transpose, which is its inverse.
static COSINES: LazyLock<[Block; 2]> = LazyLock::new(|| {
    let at = |u: usize, x: usize| {
        let angle = (2 * x + 1) as f32 * u as f32 * PI / 16.0;
        angle.cos() * if u == 0 { 0.125_f32.sqrt() } else { 0.5 }
    };
    [
        std::array::from_fn(|n| at(n / 8, n % 8)),
        std::array::from_fn(|n| at(n % 8, n / 8)),
    ]
});

/// The discrete cosine transform of a block.
fn cosines(block: &Block) -> Block {
    let [matrix, transposed] = &*COSINES;
    product(&product(matrix, block), transposed)
}

fn product(one: &Block, other: &Block) -> Block {
    let mut product = [0.0; 64];
    for (row, sums) in one.chunks(8).zip(product.chunks_mut(8)) {
        for (factor, other) in row.iter().zip(other.chunks(8)) {
            sums.iter_mut()
                .zip(other)
                .for_each(|(sum, other)| *sum += factor * other);
        }
    }
    product
}
