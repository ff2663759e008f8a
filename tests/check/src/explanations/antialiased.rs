//! Supersampling: each pixel is the mean of several rays.
//!
//! Inside a surface that changes nothing. At an edge a pixel is a mixture of what is on
//! both sides: a normal distribution around the mean of very many rays, whose variance
//! falls with their number. The number that makes the picture shortest to tell is told.

use common::rtweekend::Camera;

use ::slips::Program;

use super::{But, Conversion, Curve, Evidence, Explanation, Hypothesis};
use crate::bits::{Frequencies, Left, Pixel, class};

/// That it was done, and how often.
const NAME: f64 = 9.0;
/// Components that differ by more within a pixel and its neighbors make an edge.
const EDGE: i16 = 16;
/// How finely a pixel is divided to know what very many rays would see: 6 by 6.
const FINE: u32 = 6;
/// The variance that cutting off the fraction of a level adds, and that 36 rays are not
/// very many.
const ROUNDING: f64 = 0.3;
/// The share of pixels at edges that may be anything.
const ANYTHING: f64 = 0.03;
/// Components at edges that are enough to count rays.
const ENOUGH: usize = 60;

/// The program's picture with several rays a pixel, perhaps on a curve.
pub(crate) fn antialiased(
    evidence: &Evidence,
    hypothesis: &Hypothesis,
    curve: Option<&Curve>,
) -> Option<Explanation> {
    let reading = evidence.reading;
    let program = hypothesis.scene.program(&hypothesis.slips);
    let camera = program.camera(reading.width);
    let has_its_size = (camera.image_width, camera.image_height) == (reading.width, reading.height);
    let is_degraded = hypothesis.degradation.is_some();
    if hypothesis.conversion != Conversion::Clamped || !has_its_size || is_degraded {
        return None;
    }
    let mut drawn = hypothesis.drawn(reading)?;
    let contrast: Vec<i16> = contrast(&drawn, reading.width as usize);
    if let Some(curve) = curve {
        drawn = drawn.iter().map(|pixel| curve.of_pixel(*pixel)).collect();
    }
    let parts = parts(&program, &camera);
    let (mut smooth, mut edges, mut off) = (Frequencies::of_noise(), Vec::new(), 0);
    for (n, found) in (0..).zip(&reading.pixels) {
        let at = n as usize;
        if contrast[at] <= EDGE {
            for c in 0..3 {
                let difference = found[c] - drawn[at][c];
                smooth.add(c, class(drawn[at][c], contrast[at] as u16), difference);
                off += usize::from(difference.abs() > 2);
            }
            continue;
        }
        let (i, j) = (program.order)(n, camera.image_width, camera.image_height);
        let colors = parts
            .iter()
            .map(|camera| (program.color)(&program, camera, i, j).to_array());
        let colors: Vec<[f64; 3]> = colors.collect();
        for c in 0..3 {
            let levels = colors
                .iter()
                .map(|color| 255.999 * color[program.channels[c]].clamp(0.0, 1.0));
            let (mut mean, mut deviation) = mean_and_deviation(levels);
            if let Some(curve) = curve {
                deviation = (curve.at(mean + deviation) - curve.at(mean - deviation)).abs() / 2.0;
                mean = curve.at(mean);
            }
            edges.push((f64::from(found[c]) + 0.5 - mean, deviation * deviation));
        }
    }
    if edges.is_empty() {
        return None;
    }
    let bits = (0..=20)
        .map(|half| by_samples(&edges, f64::from(half).exp2().sqrt()))
        .fold(f64::INFINITY, f64::min);
    let mut explanation = hypothesis.explaining(reading, &drawn);
    explanation.name += NAME + curve.map_or(0.0, Curve::name);
    explanation.left = Left {
        bits: smooth.bits() + bits,
        off,
        far: off,
        is_both_ways: false,
        is_one_by_one: false,
    };
    let samples = samples(&edges);
    explanation.but = vec![But::Antialiased { samples }];
    explanation.but.extend(curve.cloned().map(But::Curve));
    Some(explanation)
}

/// The largest step in a component among each pixel and its neighbors.
fn contrast(drawn: &[Pixel], width: usize) -> Vec<i16> {
    let near = |n: usize| {
        let columns = n % width..(n % width + 3).min(width + 1);
        columns.flat_map(move |column| {
            let row = n / width;
            (row..row + 3).filter_map(move |row| {
                let (column, row) = (column.checked_sub(1)?, row.checked_sub(1)?);
                Some(row * width + column)
            })
        })
    };
    let step = |n: usize| {
        let (mut low, mut high) = (drawn[n], drawn[n]);
        for pixel in near(n).filter_map(|near| drawn.get(near)) {
            for c in 0..3 {
                low[c] = low[c].min(pixel[c]);
                high[c] = high[c].max(pixel[c]);
            }
        }
        (0..3).map(|c| high[c] - low[c]).max().unwrap_or_default()
    };
    (0..drawn.len()).map(step).collect()
}

/// Bits of components at edges, each by how far it is from the mean and the variance of
/// one ray, if they are means of so many rays.
fn by_samples(edges: &[(f64, f64)], samples: f64) -> f64 {
    let bits = |&(off, variance): &(f64, f64)| {
        let variance = variance / samples + ROUNDING;
        let normal =
            (-off * off / variance / 2.0).exp() / (std::f64::consts::TAU * variance).sqrt();
        -((1.0 - ANYTHING) * normal + ANYTHING / 256.0).log2()
    };
    edges.iter().map(bits).sum()
}

/// About how many rays each pixel is the mean of: the variance of one over that of the
/// mean. `None` if there are too few edges to tell.
fn samples(edges: &[(f64, f64)]) -> Option<f64> {
    let seen = edges.iter().filter(|(_, variance)| *variance > 16.0);
    let (mut of_one, mut of_mean, mut count) = (0.0, 0.0, 0);
    for (off, variance) in seen {
        of_one += variance;
        of_mean += off * off - 1.0 / 12.0;
        count += 1;
    }
    (count >= ENOUGH).then(|| of_one / of_mean.max(of_one / 1000.0))
}

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

fn mean_and_deviation(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (mut count, mut sum, mut squares) = (0.0, 0.0, 0.0);
    for value in values {
        count += 1.0;
        sum += value;
        squares += value * value;
    }
    let mean = sum / count;
    (mean, (squares / count - mean * mean).max(0.0).sqrt())
}
