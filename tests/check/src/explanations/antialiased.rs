//! Supersampling: each pixel is the mean of several rays.
//!
//! Inside a surface that changes nothing. At an edge a pixel is a mixture of what is on
//! both sides: a normal distribution around the mean of very many rays, whose variance
//! falls with their number. So the mean position of the edges tells where the rays of a
//! pixel lie, and how far pixels are from it, how many they are.

use std::collections::HashMap;

use common::rtweekend::Camera;

use ::slips::{Edition, Program, Slip};

use super::colors::is_rescaled;
use super::{But, Conversion, Curve, Evidence, Explanation, Hypothesis, Seen, mark, spread};
use crate::bits::{self, Frequencies, Left, Pixel, class, distance};
use crate::reading::Reading;

/// That it was done, and how often.
const NAME: f64 = 9.0;
/// That the rays lie elsewhere: one of some forty places, and less likely than a slip.
const ELSEWHERE: f64 = 12.0;
/// By how much longer what lies where it should is not measured.
const ELSE: f64 = 1.05;
/// Components that differ by more within a pixel and its neighbors make an edge.
pub(super) const EDGE: i16 = 16;
/// How far neighbors are: an edge may lie a pixel beside where it should.
const NEAR: usize = 2;
/// What is off by more levels away from edges is of something else.
const FAR: u16 = 24;
/// How finely a pixel is divided to know what very many rays would see.
const FINE: usize = 6;
/// How many parts there are each way: a pixel, and a pixel on either side.
const PARTS: usize = 3 * FINE;
/// How many pixels at edges, and how many others, choose what is measured.
const LOOK: u32 = 100;
/// How many pixels at edges count rays.
const COUNTED: u32 = 1500;
/// How many programs are measured.
const MEASURED: usize = 3;
/// The variance of a fraction that is cut off.
const ROUNDING: f64 = 1.0 / 12.0;
/// The logistic function of so many times a number is nearly the normal distribution's (to 0.01).
const LOGISTIC: f64 = 1.702;
/// The share of pixels at edges that may be anything.
const ANYTHING: f64 = 0.03;
/// The variance of the difference of two levels that were cut off.
const ROUNDINGS: f64 = 1.0 / 6.0;
/// Of one ray's variance the mean of these parts has so much by itself: at straight edges of any
/// place and direction (computed from 4000).
const GRID: f64 = 0.0019;
/// Components at edges that are enough to count rays.
const ENOUGH: usize = 60;

/// Fewer rays are one.
pub(crate) const SINGLE: f64 = 1.5;

/// Where the rays of a pixel lie: a rectangle, in parts of the pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Rectangle {
    /// Its middle, in halves of a pixel from where it should be, along the two edges of
    /// the viewport.
    middle: [i8; 2],
    /// Its width and height in thirds of a pixel.
    size: [u8; 2],
}

/// As the next chapter of the book has it.
const WHOLE_PIXEL: Rectangle = Rectangle {
    middle: [0, 0],
    size: [3, 3],
};

/// The same with rows from above, where the edition has them from below.
const MIRRORED: Rectangle = Rectangle {
    middle: [0, -2],
    size: [3, 3],
};

impl Rectangle {
    /// Those that are looked for: a pixel anywhere near, a line across or up, part of a pixel, four pixels.
    fn all() -> impl Iterator<Item = Self> {
        let places = (-2..=2).flat_map(|x| (-2..=2).map(move |y| [x, y]));
        let pixels = places.map(|middle| (middle, [3, 3]));
        let near = || (-1..=1).flat_map(|x| (-1..=1).map(move |y| [x, y]));
        let across = near().map(|middle| (middle, [3, 0]));
        let up = near().map(|middle| (middle, [0, 3]));
        let four = near().map(|middle| (middle, [6, 6]));
        let all = pixels.chain(across).chain(up).chain(four);
        let all = all.chain([([0, 0], [2, 2])]);
        all.map(|(middle, size)| Self { middle, size })
    }

    /// Its first part along an edge, and the one after its last: a line is two parts thick.
    fn parts(self, along: usize) -> (usize, usize) {
        let twice = PARTS as i32 + FINE as i32 * i32::from(self.middle[along]);
        let half = match self.size[along] {
            0 => 1,
            size => i32::from(size) * FINE as i32 / 6,
        };
        ((twice / 2 - half) as usize, (twice / 2 + half) as usize)
    }

    /// Its length beside the pixel of a program.
    fn name(self, program: &Program) -> f64 {
        match self.is_whole(program) {
            true => 0.0,
            false => ELSEWHERE,
        }
    }

    /// Whether it is where the edition has it. Who counts rows from above, where the edition
    /// counts from below, adds the same part of a row the other way.
    fn is_whole(self, program: &Program) -> bool {
        let is_mirrored = program.edition.counts_from_below() && self == MIRRORED;
        self == WHOLE_PIXEL || is_mirrored
    }

    /// Where the rays lie, if that is not where they should.
    fn said(self, program: &Program) -> Option<String> {
        if self.is_whole(program) {
            return None;
        }
        let [x, y] = self.middle.map(f64::from);
        let away = |by: f64, there: &str, back: &str| {
            let there = if by > 0.0 { there } else { back };
            let by = if by.abs() < 1.5 {
                "half a pixel"
            } else {
                "a pixel"
            };
            format!("{by} too far {there}")
        };
        let (up, down) = if program.edition.counts_from_below() {
            ("up", "down")
        } else {
            ("down", "up")
        };
        let ways = [(x, "to the right", "to the left"), (y, up, down)];
        let away: Vec<String> = ways
            .into_iter()
            .filter(|(by, ..)| *by != 0.0)
            .map(|(by, there, back)| away(by, there, back))
            .collect();
        let spread = match self.size {
            [3, 3] => "anywhere in a square as large as a pixel",
            [2, 2] => "anywhere in a part of it, about two thirds wide and high",
            [_, 0] => "beside each other, all at one height",
            [0, _] => "above each other, all in one column",
            _ => "anywhere in a square of two by two pixels",
        };
        let place = match away.is_empty() {
            true => String::new(),
            false => format!(", {}", away.join(" and ")),
        };
        Some(format!(
            "Each pixel is the mean of several rays, {spread}{place}: they should be anywhere in the pixel."
        ))
    }
}

/// The likeliest of these programs, perhaps on a curve, with several rays a pixel. Where
/// `drawn`, the picture of one of them, has its edges, all have them nearly.
pub(crate) fn antialiased<'a>(
    evidence: &Evidence,
    drawn: &[Pixel],
    all: impl Iterator<Item = (&'a Hypothesis, Option<&'a Curve>)>,
) -> Vec<Explanation> {
    let reading = evidence.reading;
    let contrast: Vec<i16> = contrast(drawn, reading.width as usize);
    let (edges, smooth): (Vec<u32>, Vec<u32>) =
        (0..drawn.len() as u32).partition(|&n| contrast[n as usize] > EDGE);
    // Where almost all is edge, rays see anything.
    if edges.is_empty() || edges.len() > smooth.len() {
        return Vec::new();
    }
    let near = all.filter_map(|(it, curve)| {
        let program = it.scene.program(&it.slips);
        let rays = Rays::of(it, &program, reading, curve)?;
        let found = rays.are_like(&smooth).then(|| rays.rectangle(&edges))?;
        // Who makes a slip puts the rays where they should be, unless it is in the scale of levels.
        let right = it.scene.program(&[]);
        let is_of_scale = |slip: &&&Slip| is_rescaled(&right, &slip.put_to(right));
        let is_anywhere = it.slips.iter().filter(is_of_scale).count() == it.slips.len();
        let (bits, whole) = *found.iter().find(|(_, it)| it.is_whole(&program))?;
        let (_, pixel) = *found.iter().find(|(_, it)| it.size == [3, 3])?;
        let (least, first) = found[0];
        // By chance rays that lie elsewhere are a little shorter.
        let mut rectangles = match is_anywhere && bits > ELSE * least {
            true => vec![pixel, first],
            false => vec![whole],
        };
        rectangles.dedup();
        let least = found.iter().find(|(_, it)| rectangles.contains(it))?.0;
        Some((least, rectangles, it, curve))
    });
    let mut near: Vec<_> = near.collect();
    near.sort_by(|(one, _, it, _), (other, _, than, _)| {
        (one + it.name).total_cmp(&(other + than.name))
    });
    let (mut explained, mut known) = (Vec::new(), HashMap::new());
    for (least, rectangles, it, curve) in near.into_iter().take(MEASURED) {
        let program = it.scene.program(&it.slips);
        let Some(rays) = Rays::of(it, &program, reading, curve) else {
            continue;
        };
        for rectangle in rectangles {
            let measure = || {
                let drawn = rays.through_the_middle(rectangle);
                let mut left = rays.left(&drawn, &contrast, &smooth);
                let (bits, samples) = rays.at_edges(&edges, rectangle);
                left.bits += bits;
                let is_one = samples.is_some_and(|it| it < SINGLE);
                let is_grain = is_one && bits::is_grain(reading, &drawn, 1);
                (left, mark(&drawn), samples, is_grain)
            };
            // Who is as long to the last bit at those edges draws the same.
            let measured = known.entry((least.to_bits(), rectangle));
            let (left, mark, samples, is_grain) = *measured.or_insert_with(measure);
            // A single one that lies elsewhere is like rows that are missing, or numbers that are off,
            // and so is one whose place does not change from pixel to pixel.
            let is_anywhere = rectangle.is_whole(&program) && is_grain;
            if !is_anywhere && samples.is_some_and(|it| it < SINGLE) {
                continue;
            }
            let mut explanation = it.leaving(left, mark);
            explanation.name += NAME + rectangle.name(&program) + curve.map_or(0.0, Curve::name);
            let is_lower = rectangle != WHOLE_PIXEL && rectangle.is_whole(&program);
            explanation.but = vec![But::Antialiased { samples, is_lower }];
            explanation.but.extend(curve.cloned().map(But::Curve));
            let said = rectangle.said(&program);
            explanation.seen = said.map(Seen::Said);
            explained.push(explanation);
        }
    }
    explained
}

/// What rays in parts of a pixel see.
struct Rays<'a> {
    program: &'a Program,
    camera: Camera,
    reading: &'a Reading,
    level: fn(f64) -> i32,
    conversion: Conversion,
    curve: Option<&'a Curve>,
}

/// How the next chapter of the book scales a mean, since version 3.0.
pub(super) const WITH_SAMPLES: fn(f64) -> i32 = |mean| (256.0 * mean.clamp(0.0, 0.999)) as i32;

/// The pairs of components, each with itself first.
const PAIRS: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [0, 2], [1, 2]];

/// Three components, and the products of pairs of them: summed or on the average.
#[derive(Clone, Copy, Default)]
struct Moments {
    components: [f64; 3],
    products: [f64; PAIRS.len()],
}

/// Sums over all parts before one each way: a summed area table (Crow, 1984).
type Sums = Vec<Moments>;

/// How far a pixel is from the mean of very many rays, and the covariance of one ray, in levels.
struct Beside {
    off: [f64; 3],
    covariance: [[f64; 3]; 3],
}

impl<'a> Rays<'a> {
    /// Those of a program whose picture has the reader's size.
    fn of(
        it: &Hypothesis,
        program: &'a Program,
        reading: &'a Reading,
        curve: Option<&'a Curve>,
    ) -> Option<Self> {
        let camera = program.camera(reading.width);
        let has_its_size =
            (camera.image_width, camera.image_height) == (reading.width, reading.height);
        let own = it.scene.program(&[]).level;
        // Two places in each level tell cutting off from rounding.
        let mut places = (0..512).map(|n| (f64::from(n) + 0.5) / 512.0);
        let is_same = |it: f64| own(it) == (program.level)(it);
        let has_samples = program.edition >= Edition::V3_0 && places.all(is_same);
        (it.conversion != Conversion::Wrapped && has_its_size).then_some(Self {
            conversion: it.conversion,
            program,
            camera,
            reading,
            level: if has_samples {
                WITH_SAMPLES
            } else {
                program.level
            },
            curve,
        })
    }

    /// Whether most pixels away from edges are nearly those of the picture: nothing else is
    /// worth many rays.
    fn are_like(&self, smooth: &[u32]) -> bool {
        let places = spread(LOOK, smooth.len() as u32).map(|at| smooth[at as usize]);
        let camera = self.middle(WHOLE_PIXEL);
        let is_far =
            |n: &u32| distance(self.pixel(*n, &camera), self.reading.pixels[*n as usize]) > 3;
        4 * places.filter(is_far).count() <= smooth.len().min(LOOK as usize)
    }

    /// What the picture leaves away from edges.
    fn left(&self, drawn: &[Pixel], contrast: &[i16], smooth: &[u32]) -> Left {
        let (mut code, mut off, mut far) = (Frequencies::of_noise(), 0, Vec::new());
        for at in smooth.iter().map(|&n| n as usize) {
            let (drawn, found) = (drawn[at], self.reading.pixels[at]);
            for c in 0..3 {
                code.add(c, class(drawn[c], contrast[at] as u16), found[c] - drawn[c]);
            }
            off += usize::from(distance(drawn, found) > 1);
            if distance(drawn, found) > FAR {
                far.push(at as u32);
            }
        }
        Left {
            bits: code.bits(),
            off,
            far: off,
            is_both_ways: false,
            is_one_by_one: false,
            part: bits::part(&far, self.reading),
        }
    }

    fn level(&self, component: f64) -> i16 {
        self.conversion.apply((self.level)(component))
    }

    fn middle(&self, rectangle: Rectangle) -> Camera {
        let [x, y] = rectangle
            .middle
            .map(|half| (PARTS as f64 + f64::from(half) * FINE as f64) / 2.0);
        self.moved(x, y)
    }

    fn pixel(&self, n: u32, camera: &Camera) -> Pixel {
        self.levels(self.color(n, camera))
    }

    fn levels(&self, color: [f64; 3]) -> Pixel {
        match self.curve {
            Some(curve) => color.map(|component| curve.of_component(component)),
            None => color.map(|component| self.level(component)),
        }
    }

    /// The picture with one ray through the middle of each rectangle.
    fn through_the_middle(&self, rectangle: Rectangle) -> Vec<Pixel> {
        let camera = self.middle(rectangle);
        let all = 0..self.reading.pixels.len() as u32;
        all.map(|n| self.pixel(n, &camera)).collect()
    }

    /// Bits of the pixels at edges, by some of them, and about how many rays they are the means of.
    fn at_edges(&self, edges: &[u32], rectangle: Rectangle) -> (f64, Option<f64>) {
        let ((left, right), (first, last)) = (rectangle.parts(0), rectangle.parts(1));
        let parts = (first..last).flat_map(|y| (left..right).map(move |x| (x, y)));
        let cameras: Vec<Camera> = parts
            .map(|(x, y)| self.moved(x as f64 + 0.5, y as f64 + 0.5))
            .collect();
        let (mut beside, mut one) = (Vec::new(), 0.0);
        let all = edges.len() as u32;
        for n in spread(COUNTED, all).map(|at| edges[at as usize]) {
            let colors: Vec<[f64; 3]> = cameras.iter().map(|it| self.color(n, it)).collect();
            one += self.by_one(n, &colors);
            beside.push(self.beside(n, &Moments::mean(&colors)));
        }
        let bits = (0..=10)
            .map(|twice| by_samples(&beside, f64::from(twice).exp2()))
            .fold(f64::INFINITY, f64::min);
        let times = f64::from(all) / f64::from(all.min(COUNTED));
        match one < bits {
            true => (times * one, Some(1.0)),
            false => (times * bits, samples(&beside)),
        }
    }

    /// Bits of a pixel that one of these rays may have seen, or one nearby.
    fn by_one(&self, n: u32, colors: &[[f64; 3]]) -> f64 {
        let found = self.reading.pixels[n as usize];
        let likely = |color: &[f64; 3]| match distance(self.levels(*color), found) {
            0 => 0.5,
            1..=4 => 0.5 / 9_f64.powi(3),
            _ => 0.0,
        };
        let seen = colors.iter().map(likely).sum::<f64>() / colors.len() as f64;
        -((1.0 - ANYTHING) * seen + ANYTHING / 256_f64.powi(3)).log2()
    }

    /// Where the rays of a pixel may lie, the likeliest first, by some pixels at edges.
    fn rectangle(&self, edges: &[u32]) -> Vec<(f64, Rectangle)> {
        let some = spread(LOOK, edges.len() as u32).map(|at| edges[at as usize]);
        let parts = (0..PARTS * PARTS).map(|n| ((n % PARTS) as f64, (n / PARTS) as f64));
        let cameras: Vec<Camera> = parts.map(|(x, y)| self.moved(x + 0.5, y + 0.5)).collect();
        let some: Vec<(u32, Sums)> = some.map(|n| (n, self.sums(n, &cameras))).collect();
        let bits = |rectangle: &Rectangle| {
            let beside: Vec<Beside> = some
                .iter()
                .map(|(n, sums)| self.beside(*n, &in_sums(sums, *rectangle)))
                .collect();
            let counts = [1.0, 4.0, 16.0, 64.0, 256.0];
            let bits = counts.map(|count| by_samples(&beside, count));
            rectangle.name(self.program) + bits.into_iter().fold(f64::INFINITY, f64::min)
        };
        let mut all: Vec<_> = Rectangle::all().map(|it| (bits(&it), it)).collect();
        all.sort_by(|(one, _), (other, _)| one.total_cmp(other));
        all
    }

    /// The colors in all parts of a pixel and around it.
    fn sums(&self, n: u32, cameras: &[Camera]) -> Sums {
        let mut sums = vec![Moments::default(); (PARTS + 1) * (PARTS + 1)];
        for y in 0..PARTS {
            let mut row = Moments::default();
            for x in 0..PARTS {
                let at = (y + 1) * (PARTS + 1) + x + 1;
                row = row.plus(1.0, &Moments::of(self.color(n, &cameras[y * PARTS + x])));
                sums[at] = row.plus(1.0, &sums[at - PARTS - 1]);
            }
        }
        sums
    }

    /// The camera whose rays go through that place, in parts from the first one on.
    fn moved(&self, x: f64, y: f64) -> Camera {
        let camera = self.camera;
        let (width, height) = (camera.image_width, camera.image_height);
        // Editions before version 4 begin at a pixel's corner, and a column is there a part
        // of the whole edge.
        let ([across, down], middle) = match self.program.edition.counts_from_below() {
            true => ((self.program.divisors)(width.into(), height.into()), FINE),
            false => ([1.0, 1.0], PARTS / 2),
        };
        let [x, y] = [x, y].map(|at| (at - middle as f64) / FINE as f64);
        Camera {
            pixel00: camera.pixel00
                + x / across * camera.pixel_delta_u
                + y / down * camera.pixel_delta_v,
            ..camera
        }
    }

    /// The components that a pixel's ray sees.
    fn color(&self, n: u32, camera: &Camera) -> [f64; 3] {
        let (program, width, height) = (self.program, camera.image_width, camera.image_height);
        let (i, j) = (program.order)(n, width, height);
        let color = (program.color)(program, camera, i, j).to_array();
        program.channels.map(|c| color[c])
    }

    /// How far a pixel is from such a mean.
    fn beside(&self, n: u32, means: &Moments) -> Beside {
        let Moments {
            components,
            products,
        } = means;
        let (mut off, mut times) = ([0.0; 3], [255.999; 3]);
        for c in 0..3 {
            let mut level = f64::from(self.level(components[c]));
            if let Some(curve) = self.curve {
                let variance = products[c] - components[c] * components[c];
                let deviation = 255.999 * variance.max(f64::EPSILON).sqrt();
                let along = curve.at(level + deviation) - curve.at(level - deviation);
                times[c] *= along.abs() / 2.0 / deviation;
                level = curve.at(level + 0.5) - 0.5;
            }
            off[c] = f64::from(self.reading.pixels[n as usize][c]) - level;
        }
        let mut covariance = [[0.0; 3]; 3];
        for ([c, d], product) in PAIRS.into_iter().zip(products) {
            let both = times[c] * times[d] * (product - components[c] * components[d]);
            // What is no number tells nothing.
            let both = if both.is_finite() { both } else { 0.0 };
            (covariance[c][d], covariance[d][c]) = (both, both);
        }
        Beside { off, covariance }
    }
}

impl Moments {
    fn of(color: [f64; 3]) -> Self {
        Self {
            components: color,
            products: PAIRS.map(|[c, d]| color[c] * color[d]),
        }
    }

    fn plus(mut self, times: f64, other: &Self) -> Self {
        let components = self.components.iter_mut().zip(other.components);
        let products = self.products.iter_mut().zip(other.products);
        components
            .chain(products)
            .for_each(|(it, other)| *it += times * other);
        self
    }

    fn mean(colors: &[[f64; 3]]) -> Self {
        let sum = colors.iter().fold(Self::default(), |sum, color| {
            sum.plus(1.0, &Self::of(*color))
        });
        Self::default().plus(1.0 / colors.len() as f64, &sum)
    }
}

/// The mean in a rectangle.
fn in_sums(sums: &Sums, rectangle: Rectangle) -> Moments {
    let ((left, right), (first, last)) = (rectangle.parts(0), rectangle.parts(1));
    let part = 1.0 / ((right - left) * (last - first)) as f64;
    let at = |x: usize, y: usize| &sums[y * (PARTS + 1) + x];
    Moments::default()
        .plus(part, at(right, last))
        .plus(-part, at(left, last))
        .plus(-part, at(right, first))
        .plus(part, at(left, first))
}

/// The largest step in a component among each pixel and its neighbors.
pub(super) fn contrast(drawn: &[Pixel], width: usize) -> Vec<i16> {
    let near = |n: usize| {
        let (column, row) = (n % width, n / width);
        let columns = column.saturating_sub(NEAR)..(column + NEAR + 1).min(width);
        let rows = row.saturating_sub(NEAR)..=row + NEAR;
        rows.flat_map(move |row| columns.clone().map(move |column| row * width + column))
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

/// Bits of pixels at edges, if they are means of so many rays: of each component beside those
/// before it, since what covers a part of a pixel changes all three together.
fn by_samples(edges: &[Beside], samples: f64) -> f64 {
    edges.iter().map(|it| it.bits(samples)).sum()
}

impl Beside {
    /// Each component's normal distribution where those before it are known, by Cholesky's
    /// factors without roots.
    fn bits(&self, samples: f64) -> f64 {
        let (mut factors, mut variances) = ([[0.0; 3]; 3], [0.0; 3]);
        let (mut off, mut bits) = (self.off, 0.0);
        for c in 0..3 {
            variances[c] = self.covariance[c][c] / samples + ROUNDING;
            for d in 0..c {
                let known: f64 = (0..d)
                    .map(|n| factors[c][n] * factors[d][n] * variances[n])
                    .sum();
                factors[c][d] = (self.covariance[c][d] / samples - known) / variances[d];
                variances[c] -= factors[c][d] * factors[c][d] * variances[d];
                off[c] -= factors[c][d] * off[d];
            }
            variances[c] = variances[c].max(ROUNDING);
            let deviation = variances[c].sqrt();
            let below = |off: f64| 1.0 / (1.0 + (-LOGISTIC * off / deviation).exp());
            let in_level = below(off[c] + 0.5) - below(off[c] - 0.5);
            bits -= ((1.0 - ANYTHING) * in_level + ANYTHING / 256.0).log2();
        }
        bits
    }
}

/// About how many rays each pixel is the mean of: the variance of one over that of the
/// mean. `None` if there are too few edges to tell.
fn samples(edges: &[Beside]) -> Option<f64> {
    let components = |it: &Beside| [0, 1, 2].map(|c| (it.off[c], it.covariance[c][c]));
    let seen = edges.iter().flat_map(components);
    let seen = seen.filter(|(_, variance)| *variance > 16.0);
    let (mut of_one, mut of_mean, mut count) = (0.0, 0.0, 0);
    for (off, variance) in seen {
        of_one += variance;
        of_mean += off * off - ROUNDINGS - GRID * variance;
        count += 1;
    }
    (count >= ENOUGH).then(|| of_one / of_mean.max(of_one / 1000.0))
}
