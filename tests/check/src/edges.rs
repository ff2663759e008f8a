//! Edge-free comparison: whether each pixel may be the mean of several rays of a program's.
//!
//! Where a picture has no edge, the mean of a pixel's rays is the ray through its middle, but
//! for a rounding. At an edge it lies between the colors on both sides. How many rays there
//! are, and where, is not asked.

use common::rtweekend::Ray;
use slips::Chapter;

use crate::candidate::Candidate;
use crate::pixels::{Pixel, distance, spread};
use crate::reading::Reading;

/// A component that changes by more levels from a pixel to the next makes an edge.
const CONTRAST: u16 = 16;
/// By so many levels a mean may be off where there is no edge, and outside of its neighbors,
/// since fractions are cut off; and by a part of the contrast, since few rays at random lie
/// more to one side.
const GIVE: u16 = 2;
const UNEVEN: u16 = 4;
/// One pixel in so many may be off by more, away from edges and at edges.
const ODD: usize = 100;
const ODD_AT_EDGES: usize = 20;
/// So many pixels that lie between both sides of an edge are no chance.
const MIXED: usize = 16;
/// How many pixels are looked at before all are, and of how many one has no edge at least.
const GLANCE: u32 = 200;
const SMOOTH: u32 = 4;

/// A picture whose pixels lie between those of a program.
pub(crate) struct Mean {
    /// How far it is from the program's where there are no edges, in levels of all pixels
    /// together.
    pub(crate) levels: u64,
    /// Whether there are pixels of several rays, and not of one.
    pub(crate) is_mixed: bool,
}

/// Whether each pixel may be the mean of one or several of the program's rays.
pub(crate) fn mean_of(candidate: &Candidate, reading: &Reading) -> Option<Mean> {
    let scene = candidate.scene;
    let has_rays = scene.chapter != Chapter::BuildTest && scene.step().is_none();
    if !has_rays || !may_be_mean_of(candidate, reading) {
        return None;
    }
    let drawn = through_the_middle(candidate, reading)?;
    let mut seen = Seen::default();
    for j in 1..reading.height - 1 {
        for i in 1..reading.width - 1 {
            seen.add(reading, &drawn, (j * reading.width + i) as usize);
        }
    }
    let is_mean = ODD * seen.odd <= seen.smooth && ODD_AT_EDGES * seen.odd_at_edges <= seen.edges;
    is_mean.then_some(Mean {
        levels: seen.levels,
        is_mixed: seen.mixed >= MIXED,
    })
}

/// Whether some pixels without an edge are the program's.
pub(crate) fn may_be_mean_of(candidate: &Candidate, reading: &Reading) -> bool {
    if reading.width < 3 || reading.height < 3 {
        return false;
    }
    let Some(output) = candidate.output(reading) else {
        return false;
    };
    let width = reading.width;
    let inside = |n: &u32| {
        let (i, j) = (n % width, n / width);
        i > 0 && i < width - 1 && j > 0 && j < reading.height - 1
    };
    let places = spread(GLANCE, reading.pixels.len() as u32).filter(inside);
    let (mut smooth, mut odd) = (0, 0);
    for n in places {
        let contrast = contrast(&reading.pixels, width as usize, n as usize);
        let off = distance(candidate.pixel(&output, n), reading.pixels[n as usize]);
        smooth += u32::from(contrast <= CONTRAST);
        odd += usize::from(contrast <= CONTRAST && off > GIVE + contrast);
        if odd > 2 * GLANCE as usize / ODD + 4 {
            return false;
        }
    }
    // A picture that is all edges is the mean of anything.
    SMOOTH * smooth >= GLANCE
}

/// The picture of rays through the middle of each pixel: before version 4 several rays lie
/// above and to the right of the one that a single ray takes.
fn through_the_middle(candidate: &Candidate, reading: &Reading) -> Option<Vec<Pixel>> {
    let program = candidate.scene.program(&candidate.slips);
    if !program.edition.counts_from_below() {
        return candidate.drawn(reading);
    }
    let camera = program.camera(reading.width);
    let ray = |i: u32, j: u32| (program.ray)(&program, &camera, i, j);
    let pixel = |n: u32| {
        let (i, j) = (program.order)(n, reading.width, reading.height);
        let here = ray(i, j);
        let right = ray(i + 1, j).direction - here.direction;
        let up = here.direction - ray(i, j + 1).direction;
        let middle = Ray::new(here.origin, here.direction + 0.5 * (right + up));
        let color = program.ray_color(&middle).to_array();
        let level = |channel: usize| candidate.conversion.apply((program.level)(color[channel]));
        program.channels.map(level)
    };
    Some((0..reading.pixels.len() as u32).map(pixel).collect())
}

/// What was counted.
#[derive(Default)]
struct Seen {
    smooth: usize,
    odd: usize,
    edges: usize,
    odd_at_edges: usize,
    /// Pixels at edges that lie between both sides, and are like none of the program's nearby:
    /// a picture that is moved a little has none.
    mixed: usize,
    levels: u64,
}

impl Seen {
    fn add(&mut self, reading: &Reading, drawn: &[Pixel], n: usize) {
        let (width, found) = (reading.width as usize, reading.pixels[n]);
        let contrast = contrast(&reading.pixels, width, n);
        if contrast <= CONTRAST {
            let off = distance(drawn[n], found);
            self.smooth += 1;
            self.odd += usize::from(off > GIVE + contrast / UNEVEN);
            self.levels += u64::from(off);
            return;
        }
        self.edges += 1;
        let (mut low, mut high) = ([i16::MAX; 3], [i16::MIN; 3]);
        let mut nearest = u16::MAX;
        for pixel in around(drawn, width, n) {
            nearest = nearest.min(distance(*pixel, found));
            for c in 0..3 {
                low[c] = low[c].min(pixel[c]);
                high[c] = high[c].max(pixel[c]);
            }
        }
        let is_between = |c: usize| found[c].clamp(low[c], high[c]).abs_diff(found[c]) <= GIVE;
        let is_odd = !(0..3).all(is_between);
        self.odd_at_edges += usize::from(is_odd);
        self.mixed += usize::from(!is_odd && nearest > CONTRAST);
    }
}

/// By how many levels the pixels around it differ from it at most.
fn contrast(pixels: &[Pixel], width: usize, n: usize) -> u16 {
    let around = [n - width, n, n + width].map(|row| &pixels[row - 1..=row + 1]);
    let around = around.into_iter().flatten();
    let off = around.map(|it| distance(*it, pixels[n]));
    off.max().unwrap_or_default()
}

/// The five times five pixels around it.
fn around(pixels: &[Pixel], width: usize, n: usize) -> impl Iterator<Item = &Pixel> {
    let (column, row, height) = (n % width, n / width, pixels.len() / width);
    let columns = column.saturating_sub(2)..(column + 3).min(width);
    let rows = row.saturating_sub(2)..(row + 3).min(height);
    rows.flat_map(move |row| &pixels[row * width + columns.start..row * width + columns.end])
}
