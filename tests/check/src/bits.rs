//! Minimum description length (Rissanen, 1978): how many bits it takes to tell a picture
//! to one who already has another.
//!
//! Every explanation is measured by this alone. Whole models (which program it is) are
//! priced where they are made; here is the price of what they leave.

use std::collections::{HashMap, HashSet};

use crate::reading::Reading;

/// Red, green and blue as they stand in a file.
pub(crate) type Pixel = [i16; 3];

/// What a picture still costs one who believes an explanation.
#[derive(Clone, Copy, Debug)]
pub struct Left {
    /// The price in bits.
    pub bits: f64,
    /// Pixels that are off at all.
    pub off: usize,
    /// Pixels that are off by more than one level.
    pub far: usize,
    /// Whether they are off both ways, neither much more often than the other.
    pub is_both_ways: bool,
    /// Whether they are so few, or in so small a box, that each is told by itself.
    pub is_one_by_one: bool,
    /// A small part in which all of them lie; of several rays, all that are far off.
    pub part: Option<Part>,
}

/// A box of a picture.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// The first and last column and row.
    pub bounds: [[u32; 2]; 2],
    /// How many pixels are off there.
    pub off: usize,
}

/// Below so many pixels a table of frequencies costs more than it saves.
const FEW: usize = 50;
/// One pixel in so many is many.
const MANY: usize = 16;
/// One in so many may be a level off by a rounding.
const ROUNDED: usize = 1000;
/// A part of the picture is small that has one pixel in so many.
const SMALL: f64 = 4.0;

impl Left {
    /// What is left of `reading` beside `drawn`, a picture of the same size.
    pub(crate) fn of(reading: &Reading, drawn: &[Pixel]) -> Self {
        let odd = Odd::of(reading, drawn);
        // Who tells many pixels one by one has no explanation of the picture.
        let one_by_one = match MANY * odd.places.len() > drawn.len() {
            true => f64::INFINITY,
            false => odd.one_by_one(reading),
        };
        let by_frequency = match odd.places.len() < FEW {
            true => f64::INFINITY,
            false => by_frequency(reading, drawn),
        };
        Self {
            bits: one_by_one.min(by_frequency),
            off: odd.places.len(),
            far: odd.far,
            is_both_ways: odd.is_both_ways(reading, drawn),
            is_one_by_one: one_by_one <= by_frequency,
            part: part(&odd.places, reading),
        }
    }

    /// Whether nothing but single roundings is left, in one pixel of a thousand at most.
    pub(crate) fn is_rounding(&self, pixels: usize) -> bool {
        self.far == 0 && ROUNDED * self.off <= pixels
    }

    /// Whether levels are off everywhere and both ways, which no program's rounding does.
    pub(crate) fn is_noise(&self, pixels: usize) -> bool {
        !self.is_one_by_one && self.is_both_ways && 4 * self.off > pixels
    }

    /// Whether nothing is.
    pub fn is_nothing(&self) -> bool {
        self.off == 0
    }
}

/// The pixels that differ.
struct Odd {
    places: Vec<u32>,
    far: usize,
}

impl Odd {
    fn of(reading: &Reading, drawn: &[Pixel]) -> Self {
        let mut odd = Self {
            places: Vec::new(),
            far: 0,
        };
        for (n, (drawn, found)) in (0..).zip(drawn.iter().zip(&reading.pixels)) {
            let off = distance(*drawn, *found);
            if off > 0 {
                odd.places.push(n);
                odd.far += usize::from(off > 1);
            }
        }
        odd
    }

    fn is_both_ways(&self, reading: &Reading, drawn: &[Pixel]) -> bool {
        let (mut lower, mut higher) = (0, 0);
        for n in self.places.iter().map(|&n| n as usize) {
            for (drawn, found) in drawn[n].iter().zip(&reading.pixels[n]) {
                lower += usize::from(found < drawn);
                higher += usize::from(found > drawn);
            }
        }
        lower.min(higher) > lower.max(higher) / 3
    }

    /// How many, where (anywhere, or in a box), which colors there are, and which of them
    /// each pixel has.
    fn one_by_one(&self, reading: &Reading) -> f64 {
        let count = self.places.len() as f64;
        if self.places.is_empty() {
            return 1.0;
        }
        let mut colors: Vec<Pixel> = self
            .places
            .iter()
            .map(|&n| reading.pixels[n as usize])
            .collect();
        colors.sort_unstable();
        colors.dedup();
        let colors = colors.len() as f64;
        1.0 + self.place(reading) + COLOR * colors + count * colors.log2()
    }

    /// How many there are, and where: anywhere, or in a box.
    fn place(&self, reading: &Reading) -> f64 {
        let (all, count) = (reading.pixels.len() as f64, self.places.len() as f64);
        let boxed = bounds(&self.places, reading).map_or(0.0, area);
        let corners = 4.0 * f64::from(reading.width.max(reading.height)).log2();
        all.log2() + choice(all, count).min(corners + choice(boxed, count))
    }
}

/// The part in which some places lie, if it is small.
pub(crate) fn part(places: &[u32], reading: &Reading) -> Option<Part> {
    let bounds = bounds(places, reading)?;
    let is_small = SMALL * area(bounds) <= reading.pixels.len() as f64;
    is_small.then_some(Part {
        bounds,
        off: places.len(),
    })
}

/// The first and last column and row, if there are any.
fn bounds(places: &[u32], reading: &Reading) -> Option<[[u32; 2]; 2]> {
    let columns = || places.iter().map(|n| n % reading.width);
    let rows = || places.iter().map(|n| n / reading.width);
    Some([
        [columns().min()?, columns().max()?],
        [rows().min()?, rows().max()?],
    ])
}

/// How many pixels lie between these columns and rows.
fn area(bounds: [[u32; 2]; 2]) -> f64 {
    let [columns, rows] = bounds.map(|[first, last]| f64::from(last - first + 1));
    columns * rows
}

/// Bits of a color: eight for each component.
const COLOR: f64 = 24.0;

/// Bits of a choice of `some` out of `all`: the binary entropy of their share.
fn choice(all: f64, some: f64) -> f64 {
    let entropy = |share: f64| match share {
        0.0 => 0.0,
        share => -share * share.log2(),
    };
    all * (entropy(some / all) + entropy(1.0 - some / all))
}

/// Whether pixels are off whatever others, so many places before them, are: so no other numbers of
/// the program bring it nearer.
pub(crate) fn is_grain(reading: &Reading, drawn: &[Pixel], before: usize) -> bool {
    let pairs = drawn.iter().zip(&reading.pixels);
    let off = pairs.map(|(drawn, found)| {
        [0, 1, 2].map(|c| i64::from(difference(drawn[c], found[c]).clamp(-NOISE, NOISE)))
    });
    let off: Vec<[i64; 3]> = off.collect();
    let product = |one: &[i64; 3], other: &[i64; 3]| (0..3).map(|c| one[c] * other[c]).sum::<i64>();
    let squares: i64 = off.iter().map(|it| product(it, it)).sum();
    let others = off.iter().skip(before);
    let together: i64 = off
        .iter()
        .zip(others)
        .map(|(one, it)| product(one, it))
        .sum();
    squares > 0 && 4 * together < squares
}

/// The largest difference of two pixels in a component, in levels.
///
/// C++ prints −2³¹ for NaN and for what an integer can't hold, where Rust has 0
/// or the nearest integer: that counts as the same.
pub(crate) fn distance(drawn: Pixel, found: Pixel) -> u16 {
    let [red, green, blue] = [0, 1, 2].map(|c| difference(drawn[c], found[c]).unsigned_abs());
    red.max(green).max(blue)
}

fn difference(drawn: i16, found: i16) -> i16 {
    match (drawn, found) {
        (0 | i16::MAX, i16::MIN) => 0,
        _ => found.saturating_sub(drawn),
    }
}

/// Differences by their frequency, in each component and in each class of contrast: so
/// noise and rounding are cheap where they are even, dear where they are not.
fn by_frequency(reading: &Reading, drawn: &[Pixel]) -> f64 {
    let mut code = Frequencies::of_noise();
    let width = reading.width as usize;
    for (n, (pixel, found)) in drawn.iter().zip(&reading.pixels).enumerate() {
        // Beside an edge a pixel may be anything.
        let near = [n.wrapping_sub(1), n + 1, n.wrapping_sub(width), n + width];
        let near = near.map(|near| drawn.get(near).unwrap_or(pixel));
        for c in 0..3 {
            let contrast = near.map(|near| near[c].abs_diff(pixel[c]));
            let contrast = contrast.into_iter().max().unwrap_or_default();
            code.add(c, class(pixel[c], contrast), difference(pixel[c], found[c]));
        }
    }
    code.bits()
}

/// Bits of a picture to one who knows nothing of it: each pixel from its neighbors, as
/// PNG's Paeth filter does it.
pub(crate) fn alone(reading: &Reading) -> f64 {
    told(reading, |_| true)
}

/// The same to one who knows which pixels are those of `drawn`, and of the others nothing.
pub(crate) fn beside(reading: &Reading, drawn: &[Pixel]) -> f64 {
    let odd = Odd::of(reading, drawn);
    let is_odd: HashSet<u32> = odd.places.iter().copied().collect();
    let is_odd = |n: usize| is_odd.contains(&(n as u32));
    odd.place(reading) + told(reading, is_odd)
}

/// The same to one who is told the color that most pixels have: half of such pictures are
/// black or white.
pub(crate) fn of_one_color(reading: &Reading) -> f64 {
    let color = commonest(reading.pixels.iter().copied());
    let name = match color {
        [0, 0, 0] | [255, 255, 255] => 2.0,
        _ => 1.0 + COLOR,
    };
    name + Left::of(reading, &vec![color; reading.pixels.len()]).bits
}

/// The color that most of the pixels have.
pub(crate) fn commonest(pixels: impl Iterator<Item = Pixel>) -> Pixel {
    let mut counts: HashMap<Pixel, usize> = HashMap::new();
    for pixel in pixels {
        *counts.entry(pixel).or_default() += 1;
    }
    let most = counts
        .into_iter()
        .max_by_key(|&(pixel, count)| (count, pixel));
    most.map_or([0; 3], |(pixel, _)| pixel)
}

/// The same of some pixels, beside which the others are known.
pub(crate) fn told(reading: &Reading, is_told: impl Fn(usize) -> bool) -> f64 {
    let mut code = Frequencies::of_anything();
    let width = reading.width as usize;
    let at = |n: Option<usize>| n.map_or([0; 3], |n| reading.pixels[n]);
    let pixels = reading.pixels.iter().enumerate();
    for (n, found) in pixels.filter(|(n, _)| is_told(*n)) {
        let (has_left, above) = (n % width > 0, n.checked_sub(width));
        let left = at(n.checked_sub(1).filter(|_| has_left));
        let corner = at(above.and_then(|n| n.checked_sub(1)).filter(|_| has_left));
        let above = at(above);
        for c in 0..3 {
            let (a, b, corner) = (left[c], above[c], corner[c]);
            let sum = a.saturating_add(b).saturating_sub(corner);
            let guess = [a, b, corner]
                .into_iter()
                .min_by_key(|one| one.abs_diff(sum))
                .unwrap_or_default();
            let contrast = a.abs_diff(corner).max(b.abs_diff(corner));
            code.add(c, class(guess, contrast), found[c].saturating_sub(guess));
        }
    }
    code.bits()
}

/// The class of a level with that contrast around it.
pub(crate) fn class(level: i16, contrast: u16) -> usize {
    let digits = (u16::BITS - (contrast / 2).leading_zeros()) as usize;
    match (digits, level) {
        (0, 0) => CONTRASTS,
        (0, 255) => CONTRASTS + 1,
        _ => digits.min(CONTRASTS - 1),
    }
}

/// A table of frequencies for each component and class.
pub(crate) struct Frequencies {
    counts: Vec<u32>,
    /// What is beyond this is told by itself.
    most: i16,
}

/// Classes of contrast, and two of levels that can be off one way only.
const CLASSES: usize = CONTRASTS + 2;
/// By the binary digits of the largest step to a neighbor.
const CONTRASTS: usize = 7;
/// What is off by more levels is no noise and no rounding.
const NOISE: i16 = 8;
/// Differences beyond this are rare even in a picture of which nothing is known.
const MOST: i16 = 511;
/// Bits of a difference that is told by itself: up to 255 levels up or down.
const BY_ITSELF: f64 = 9.0;

impl Frequencies {
    /// Of differences that may be anything.
    fn of_anything() -> Self {
        Self::up_to(MOST)
    }

    /// Of small differences.
    pub(crate) fn of_noise() -> Self {
        Self::up_to(NOISE)
    }

    fn up_to(most: i16) -> Self {
        let values = 2 * (most as usize + 1) + 1;
        Self {
            counts: vec![0; 3 * CLASSES * values],
            most,
        }
    }

    fn values(&self) -> usize {
        self.counts.len() / 3 / CLASSES
    }

    pub(crate) fn add(&mut self, component: usize, class: usize, difference: i16) {
        let table = component * CLASSES + class;
        let ends = self.most + 1;
        let value = (difference.clamp(-ends, ends) + ends) as usize;
        let at = table * self.values() + value;
        self.counts[at] += 1;
    }

    /// Their entropy, and what it costs to tell the tables first.
    pub(crate) fn bits(&self) -> f64 {
        let last = self.values() - 1;
        let mut bits = 1.0;
        for table in self.counts.chunks(self.values()) {
            let all = f64::from(table.iter().sum::<u32>());
            for (value, &count) in table.iter().enumerate().filter(|(_, count)| **count > 0) {
                let count = f64::from(count);
                bits += count * (all / count).log2() + BY_ITSELF + 0.5 * all.log2();
                if value == 0 || value == last {
                    bits += BY_ITSELF * count;
                }
            }
        }
        bits
    }
}

/// Bits of a number that somebody typed: the fewer digits, the fewer bits.
pub(crate) fn number(number: f64) -> f64 {
    const GRIDS: [(f64, f64); 7] = [
        (1.0, 2.0),
        (2.0, 3.0),
        (10.0, 5.0),
        (20.0, 6.0),
        (100.0, 8.0),
        (255.0, 9.0),
        (1000.0, 11.0),
    ];
    let is_on = |grid: f64| (number * grid - (number * grid).round()).abs() < 1e-9 * grid;
    let digits = GRIDS.into_iter().find(|&(grid, _)| is_on(grid));
    digits.map_or(12.0, |(_, bits)| bits) + 2.0 * (1.0 + number.abs()).log2()
}
