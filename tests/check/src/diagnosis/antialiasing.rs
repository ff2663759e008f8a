//! Supersampling: recognizing a picture of which each pixel is the mean of several rays.
//!
//! Inside a surface that changes nothing. Along an edge a pixel becomes a mixture of what
//! is on both sides: it lies between its neighbors in a picture of one ray a pixel, and
//! is none of them.

use common::rtweekend::Camera;

use super::candidates::distance;
use crate::reading::Reading;
use slips::Program;

/// A component that differs by more within a pixel and its neighbors is at an edge.
const EDGE: i16 = 16;
/// So far a mixture is from what it is made of, at least.
const MIXED: u16 = 3;
/// The mean of many rays is another number than the one in the middle, by the bend of
/// what they see, and its rounding is another one.
const MEAN: i16 = 2;

/// The variance of what cutting off a fraction of a level takes from a component.
const ROUNDING: f64 = 1.0 / 12.0 / (256.0 * 256.0);
/// So many pixels at edges are enough to count rays.
const EDGES: usize = 400;

/// What pixels say, beside what one ray each would draw.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Seen {
    /// How many were compared.
    pub(super) compared: usize,
    /// How many are another color at all.
    pub(super) off: usize,
    /// How many are farther off than a rounding.
    pub(super) far: usize,
    /// Neither the pixel's own color nor between its neighbors.
    pub(super) strange: usize,
    /// How many are at edges.
    edges: usize,
    /// At an edge, and the color of a neighbor.
    moved: usize,
    /// At an edge, and between its neighbors without being one of them.
    mixed: usize,
}

impl Seen {
    /// Adds a pixel. A color is the same if it is no more than `slack` levels off.
    pub(super) fn add(&mut self, around: &Around, found: [i16; 3], slack: u16) {
        let off = distance(around.middle, found);
        self.compared += 1;
        self.off += usize::from(off > 0);
        self.far += usize::from(off > slack);
        if !around.includes(found) {
            self.strange += 1;
        } else if around.is_edge() {
            self.edges += 1;
            let nearest = around.nearest(found);
            self.moved += usize::from(off > slack && nearest <= slack);
            self.mixed += usize::from(nearest > MIXED);
        }
    }

    /// Whether nothing is off but by a rounding, a few edges by a neighbor, and so few
    /// pixels by anything.
    pub(super) fn is_rounded_but_for(self, few: usize) -> bool {
        self.far <= self.moved + few && 10 * self.moved <= self.edges
    }

    /// Whether no more than a few pixels speak against several rays, and many edges for
    /// them. A picture of one ray a pixel has no mixtures.
    pub(super) fn is_antialiased(self) -> bool {
        200 * self.strange <= self.compared && 10 * self.mixed >= self.edges && self.mixed >= 5
    }
}

/// About how many rays each pixel is the mean of, from how far the pixels at edges
/// are from the mean of very many: the variance of a mean falls with their number.
/// `None` if there are too few edges to tell.
pub(super) fn samples(
    program: &Program,
    reading: &Reading,
    places: impl IntoIterator<Item = u32>,
) -> Option<f64> {
    let camera = program.camera(reading.width);
    let cameras = parts(program, &camera);
    let is_edge = |n: &u32| Around::of(program, &camera, *n).is_edge();
    let (mut of_one, mut of_mean, mut count) = (0.0, 0.0, 0_u32);
    for n in places.into_iter().filter(is_edge).take(EDGES) {
        let (i, j) = (n % reading.width, n / reading.width);
        let color = |camera: &Camera| (program.color)(program, camera, i, j).to_array();
        let colors: Vec<[f64; 3]> = cameras.iter().map(color).collect();
        for channel in 0..3 {
            let components = colors.iter().map(|color| color[channel].clamp(0.0, 1.0));
            let (mean, variance) = mean_and_variance(components);
            let found = (f64::from(reading.pixels[n as usize][channel]) + 0.5) / 256.0;
            of_one += variance;
            of_mean += (found - mean) * (found - mean) - ROUNDING;
            count += 1;
        }
    }
    // The mean of very many is itself a mean of some.
    (count >= 60 && of_one > 0.0).then(|| of_one / of_mean.max(of_one / 1000.0))
}

/// The colors of a pixel and its neighbors with one ray each.
pub(super) struct Around {
    middle: [i16; 3],
    all: Vec<[i16; 3]>,
}

impl Around {
    pub(super) fn of(program: &Program, camera: &Camera, n: u32) -> Self {
        let (width, height) = (camera.image_width, camera.image_height);
        let (i, j) = (n % width, n / width);
        let near = |at: u32, size: u32| at.saturating_sub(1)..=(at + 1).min(size - 1);
        let pixels = near(j, height).flat_map(|j| near(i, width).map(move |i| (i, j)));
        Self {
            middle: levels(program, camera, i, j),
            all: pixels.map(|(i, j)| levels(program, camera, i, j)).collect(),
        }
    }

    /// The color in the middle.
    pub(super) fn middle(&self) -> [i16; 3] {
        self.middle
    }

    /// Puts all levels through a curve.
    pub(super) fn map(&mut self, curve: impl Fn(i16) -> i16) {
        self.middle = self.middle.map(&curve);
        for pixel in &mut self.all {
            *pixel = pixel.map(&curve);
        }
    }

    fn range(&self) -> [[i16; 3]; 2] {
        let mut range = [self.middle; 2];
        for pixel in &self.all {
            for c in 0..3 {
                range[0][c] = range[0][c].min(pixel[c]);
                range[1][c] = range[1][c].max(pixel[c]);
            }
        }
        range
    }

    /// Whether no component is beyond all of theirs, but for what a mean is off.
    fn includes(&self, found: [i16; 3]) -> bool {
        let [low, high] = self.range();
        (0..3).all(|c| (low[c] - MEAN..=high[c] + MEAN).contains(&found[c]))
    }

    pub(super) fn is_edge(&self) -> bool {
        let [low, high] = self.range();
        (0..3).any(|c| high[c] - low[c] > EDGE)
    }

    /// Whether it is at an edge and the color one between those of its neighbors.
    pub(super) fn may_be_moved_to(&self, found: [i16; 3]) -> bool {
        self.is_edge() && self.includes(found)
    }

    /// How far the nearest of them is, in levels.
    fn nearest(&self, found: [i16; 3]) -> u16 {
        let distances = self.all.iter().map(|&pixel| distance(pixel, found));
        distances.min().unwrap_or(0)
    }
}

/// How finely a pixel is divided to know what very many rays would see: 12 by 12.
const FINE: u32 = 12;

/// The camera moved to parts of a pixel, evenly spread.
fn parts(program: &Program, camera: &Camera) -> Vec<Camera> {
    let [width, height] = [camera.image_width, camera.image_height].map(f64::from);
    let [across, down] = (program.divisors)(width, height);
    // Editions before version 4 begin at a pixel's corner, and a column is there a part
    // of the whole edge.
    let (pixel_u, pixel_v, middle) = match program.edition.counts_from_below() {
        true => (
            camera.pixel_delta_u / across,
            camera.pixel_delta_v / down,
            0.0,
        ),
        false => (camera.pixel_delta_u, camera.pixel_delta_v, 0.5),
    };
    let step = |n: u32| (f64::from(n) + 0.5) / f64::from(FINE) - middle;
    let steps = (0..FINE * FINE).map(|n| (step(n % FINE), step(n / FINE)));
    let moved = |(x, y): (f64, f64)| Camera {
        pixel00: camera.pixel00 + x * pixel_u + y * pixel_v,
        ..*camera
    };
    steps.map(moved).collect()
}

fn levels(program: &Program, camera: &Camera, i: u32, j: u32) -> [i16; 3] {
    (program.color)(program, camera, i, j)
        .to_array()
        .map(|component| (program.level)(component).clamp(0, 255) as i16)
}

/// The mean of values and their variance.
fn mean_and_variance(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (mut count, mut sum, mut squares) = (0.0, 0.0, 0.0);
    for value in values {
        count += 1.0;
        sum += value;
        squares += value * value;
    }
    let mean = sum / count;
    (mean, (squares / count - mean * mean).max(0.0))
}
