//! Resampling: pictures that a viewer scaled, or that lost some rows or columns.

use image::imageops::{self, FilterType};
use image::{Rgb, RgbImage};

use ::slips::{Edition, Output};

use super::{Degradation, FAR, Hypothesis, off};
use crate::bits::{Left, Pixel};
use crate::evidence::Evidence;
use crate::explanations::spread;
use crate::reading::Reading;

/// How pixels are mixed into one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Filter {
    /// The nearest one alone.
    Nearest,
    /// All that lie in its square, in equal parts.
    Box,
    /// The nearest two each way, as linear interpolation has it.
    Triangle,
    /// The nearest four each way.
    Cubic,
    /// The nearest six each way.
    Lanczos,
}

const FILTERS: [Filter; 5] = [
    Filter::Nearest,
    Filter::Box,
    Filter::Triangle,
    Filter::Cubic,
    Filter::Lanczos,
];

/// What viewers and screens scale by.
const FACTORS: [f64; 13] = [
    0.25,
    1.0 / 3.0,
    0.5,
    2.0 / 3.0,
    0.75,
    0.8,
    1.25,
    4.0 / 3.0,
    1.5,
    1.75,
    2.0,
    3.0,
    4.0,
];
/// The largest of these.
const MOST: u32 = 4;
/// Widths that people draw.
const WIDTHS: [u32; 9] = [200, 256, 400, 600, 640, 800, 1000, 1200, 1920];
/// How many rows and columns may be missing each way.
const MISSING: u32 = 12;
/// How many where as many are missing on either side.
const MARGINS: u32 = 80;
/// With how many sizes and programs all pixels are compared.
const MEASURED: usize = 3;
/// How many pixels choose the scale or the place, and how many of them rule out most.
const LOOK: u32 = 600;
const GLANCE: usize = 100;

/// The scale and filter with which a program comes nearest, if that is any nearer.
pub(super) fn scaled(evidence: &Evidence, likeliest: &[Hypothesis]) -> Option<Degradation> {
    let reading = evidence.reading;
    let by_factor = FACTORS.map(|factor| (f64::from(reading.width) / factor).round() as u32);
    let mut sizes: Vec<(u32, u32)> = Vec::new();
    for width in by_factor.into_iter().chain(WIDTHS) {
        let factor = f64::from(reading.width) / f64::from(width);
        let is_as_high =
            |height: &u32| (f64::from(*height) * factor - f64::from(reading.height)).abs() <= 1.0;
        let heights = evidence.heights(width).into_iter().filter(is_as_high);
        sizes.extend(heights.map(|height| (width, height)));
    }
    // Of what is reduced by more than any factor too little is left.
    let may_be = |width: u32| width <= MOST * reading.width;
    sizes.retain(|&size| size != (reading.width, reading.height) && may_be(size.0));
    let places = Sharp::of(reading);
    let [glance, least] = places.as_it_is(likeliest);
    let most = [glance, least * 5 / 6];
    // By rounding, a slip's picture may be a little nearer than the right one.
    let tried = likeliest
        .iter()
        .flat_map(|it| sizes.iter().map(move |&from| (it, from)));
    let tried = tried.filter_map(|(it, from)| {
        let output = it.of_size(from)?;
        let nearest = Degradation::Scaled {
            from,
            filter: Filter::Nearest,
        };
        let nearest = |n: u32| it.pixel(&output, nearest.source(n, reading).unwrap_or_default());
        let between = |n: u32| between(&output, from, n, reading, it);
        let boxed = |n: u32| boxed(|n| it.pixel(&output, n), from, n, reading);
        let ways: [(Filter, &dyn Fn(u32) -> Pixel); 3] = [
            (Filter::Nearest, &nearest),
            (Filter::Triangle, &between),
            (Filter::Box, &boxed),
        ];
        // The means of still larger squares are like those of many rays.
        let has_small_squares = from.0 <= 2 * reading.width;
        let ways = ways.into_iter().take(if has_small_squares { 3 } else { 2 });
        let offs = ways.filter_map(|(filter, pixel)| Some((places.off(pixel, most)?, filter)));
        let (off, filter) = offs.min_by_key(|(off, _)| *off)?;
        Some((off, it, from, filter))
    });
    let mut tried: Vec<(u32, &Hypothesis, (u32, u32), Filter)> = tried.collect();
    let weight = |it: &Hypothesis| if it.slips.is_empty() { 4 } else { 5 };
    tried.sort_by_key(|(off, it, ..)| weight(it) * off);
    let (nearest, ..) = *tried.first()?;
    // In a smooth picture another size may be as near by chance.
    let alike = tried.into_iter().filter(|(off, ..)| *off <= 2 * nearest);
    let measured = |before: &[Pixel], from: (u32, u32), filter: Filter| {
        Left::of(reading, &resized(before, from, reading, filter)).bits
    };
    let alike = alike.take(MEASURED).filter_map(|(_, it, from, filter)| {
        let before = it.before(&it.of_size(from)?);
        let bits = [filter, Filter::Triangle].map(|filter| measured(&before, from, filter));
        Some((bits[0].min(bits[1]), before, from))
    });
    let (_, before, from) = alike.min_by(|one, other| one.0.total_cmp(&other.0))?;
    let bits = FILTERS.map(|filter| (measured(&before, from, filter), filter));
    let best = bits
        .into_iter()
        .min_by(|one, other| one.0.total_cmp(&other.0));
    best.map(|(_, filter)| Degradation::Scaled { from, filter })
}

/// The place in a slightly larger picture at which a right program of some edition comes nearest.
pub(super) fn cropped(evidence: &Evidence, likeliest: &[Hypothesis]) -> Option<Degradation> {
    let reading = evidence.reading;
    let (width, height) = (reading.width, reading.height);
    let places = Sharp::of(reading);
    let [glance, least] = places.as_it_is(likeliest);
    let mut least = least * 4 / 5;
    let mut best = None;
    // With a slip in it a part of a larger picture is like many.
    let right = likeliest.first()?.without_slips();
    let editions = evidence.scene.by_editions(width, 1);
    for scene in editions.filter(|it| it.edition != Edition::V1) {
        let it = &Hypothesis {
            scene: scene.in_own_shape(),
            ..right.clone()
        };
        for wide in width..=width + MARGINS {
            for high in evidence.heights(wide) {
                let from = (wide, high);
                let is_larger =
                    from != (width, height) && (height..=height + MARGINS).contains(&high);
                let Some(output) = it.of_size(from).filter(|_| is_larger) else {
                    continue;
                };
                for corner in corners(wide - width, high - height) {
                    let cropped = Degradation::Cropped { from, corner };
                    let pixel =
                        |n: u32| it.pixel(&output, cropped.source(n, reading).unwrap_or_default());
                    if let Some(off) = places.off(pixel, [glance, least]) {
                        (least, best) = (off, Some(cropped));
                    }
                }
            }
        }
    }
    best
}

/// Any, where few are missing; else the same on either side.
fn corners(columns: u32, rows: u32) -> impl Iterator<Item = (u32, u32)> {
    let some = move |missing: u32| match columns.max(rows) <= MISSING {
        true => 0..=missing,
        false => missing / 2..=missing.div_ceil(2),
    };
    some(columns).flat_map(move |left| some(rows).map(move |above| (left, above)))
}

/// Pixels to look at, half of them at edges, where scale and place are to be seen.
struct Sharp<'a> {
    reading: &'a Reading,
    places: Vec<u32>,
}

impl<'a> Sharp<'a> {
    fn of(reading: &'a Reading) -> Self {
        const SHARP: u32 = 16;
        let all = reading.pixels.len() as u32;
        let is_sharp = |n: &u32| {
            let [one, other] = [*n, n + 1].map(|n| reading.pixels[n as usize]);
            off(one, other) >= SHARP
        };
        let sharp: Vec<u32> = (0..all - 1).filter(is_sharp).collect();
        let sharp = spread(LOOK / 2, sharp.len() as u32).map(|n| sharp[n as usize]);
        let places = sharp.chain(spread(LOOK / 2, all)).collect();
        Self { reading, places }
    }

    /// How far a picture is off in the first of them, and in all; `None` as soon as one is
    /// no less than what it may be at most.
    fn off(&self, pixel: impl Fn(u32) -> Pixel, [glance, most]: [u32; 2]) -> Option<u32> {
        let off = |&n: &u32| off(pixel(n), self.reading.pixels[n as usize]);
        let (first, rest) = self.places.split_at(GLANCE.min(self.places.len()));
        let first: u32 = first.iter().map(off).sum();
        if first >= glance {
            return None;
        }
        let mut sum = first;
        for n in rest {
            sum += off(n);
            if sum >= most {
                return None;
            }
        }
        (sum < most).then_some(sum)
    }

    /// The same of the nearest program if nothing happened to its picture.
    fn as_it_is(&self, likeliest: &[Hypothesis]) -> [u32; 2] {
        let off = |it: &Hypothesis| {
            let output = it.output(self.reading)?;
            let off = |n: &u32| off(it.pixel(&output, *n), self.reading.pixels[*n as usize]);
            let (first, rest) = self.places.split_at(GLANCE.min(self.places.len()));
            let first: u32 = first.iter().map(off).sum();
            Some([first, first + rest.iter().map(off).sum::<u32>()])
        };
        let offs = likeliest.iter().filter_map(off);
        let nearest = offs.min_by_key(|[_, all]| *all);
        nearest.unwrap_or([LOOK * FAR; 2])
    }
}

/// The nth pixel of the file, in a straight line between those of the program.
fn between(
    output: &Output,
    (width, height): (u32, u32),
    n: u32,
    reading: &Reading,
    it: &Hypothesis,
) -> Pixel {
    let at = |n: u32, before: u32, after: u32| {
        let at = (f64::from(n) + 0.5) * f64::from(before) / f64::from(after) - 0.5;
        let at = at.clamp(0.0, f64::from(before - 1));
        (at as u32, (at as u32 + 1).min(before - 1), at.fract())
    };
    let (left, right, x) = at(n % reading.width, width, reading.width);
    let (above, below, y) = at(n / reading.width, height, reading.height);
    let corners = [(left, above), (right, above), (left, below), (right, below)];
    let corners = corners.map(|(i, j)| it.pixel(output, j * width + i));
    let weights = [(1.0 - x) * (1.0 - y), x * (1.0 - y), (1.0 - x) * y, x * y];
    [0, 1, 2].map(|c| {
        let parts = weights.iter().zip(&corners);
        let level: f64 = parts
            .map(|(weight, corner)| weight * f64::from(corner[c]))
            .sum();
        (level + 0.5) as i16
    })
}

/// A picture in the file's size.
pub(super) fn resized(
    drawn: &[Pixel],
    (width, height): (u32, u32),
    reading: &Reading,
    filter: Filter,
) -> Vec<Pixel> {
    if filter == Filter::Box {
        let before = |n: u32| drawn[n as usize];
        let all = 0..reading.pixels.len() as u32;
        return all
            .map(|n| boxed(before, (width, height), n, reading))
            .collect();
    }
    let level = |level: i16| level.clamp(0, 255) as u8;
    let before = RgbImage::from_fn(width, height, |i, j| {
        Rgb(drawn[(j * width + i) as usize].map(level))
    });
    let (width, height) = (reading.width, reading.height);
    let filter = match filter {
        Filter::Nearest | Filter::Box => FilterType::Nearest,
        Filter::Triangle => FilterType::Triangle,
        Filter::Cubic => FilterType::CatmullRom,
        Filter::Lanczos => FilterType::Lanczos3,
    };
    let after = imageops::resize(&before, width, height, filter);
    after.pixels().map(|pixel| pixel.0.map(i16::from)).collect()
}

/// The mean of all pixels whose middle lies in the square of the nth one: first in each
/// row, then of the rows, with whole levels in between, as Pillow and libvips do it.
fn boxed(
    before: impl Fn(u32) -> Pixel,
    (width, height): (u32, u32),
    n: u32,
    reading: &Reading,
) -> Pixel {
    let places = |at: u32, before: u32, after: u32| {
        let edge = |at: u32| (2 * at * before + after) / (2 * after);
        let first = edge(at).min(before - 1);
        first..edge(at + 1).clamp(first + 1, before)
    };
    let columns = places(n % reading.width, width, reading.width);
    let rows = places(n / reading.width, height, reading.height);
    mean(rows.map(|j| mean(columns.clone().map(|i| before(j * width + i)))))
}

fn mean(pixels: impl ExactSizeIterator<Item = Pixel>) -> Pixel {
    let count = pixels.len() as i32;
    let mut sums = [count / 2; 3];
    for pixel in pixels {
        for (sum, level) in sums.iter_mut().zip(pixel) {
            *sum += i32::from(level);
        }
    }
    sums.map(|sum| (sum / count) as i16)
}
