//! Least squares: the colors that a reader chose, from the picture.

use common::rtweekend::Color;

use ::slips::{Chapter, Program};

use super::{Evidence, Hypothesis, spread};
use crate::bits::number;
use crate::reading::Reading;
use crate::scene::{Chosen, Scene};

/// How many pixels the colors are taken from.
const LOOK: u32 = 4000;
/// What a level may be off, since its fraction was cut off.
const ROUNDING: f64 = 1.5;
/// The share of pixels that have to follow the colors: the others may be edges.
const MOST: f64 = 0.97;

/// Components that people type: some forget where they end.
const BEYOND: std::ops::RangeInclusive<f64> = -1.0..=3.0;

/// That there are colors of the reader's own, beside their numbers.
const NAME: f64 = 6.0;

/// The program in the reader's own colors, if those of the picture are not the book's.
pub(crate) fn in_colors(evidence: &Evidence, right: &Hypothesis) -> Option<Hypothesis> {
    let scene = chosen(&right.scene, evidence.reading)?;
    let Chosen {
        sky, paint, blue, ..
    } = scene.chosen;
    let colors = sky.into_iter().flatten().chain(paint);
    let numbers = colors.flat_map(|color| color.to_array()).chain(blue);
    Some(Hypothesis {
        scene,
        name: right.name + NAME + numbers.map(number).sum::<f64>(),
        ..right.clone()
    })
}

/// The scene in those colors.
pub(crate) fn chosen(scene: &Scene, reading: &Reading) -> Option<Scene> {
    // A picture of one color says nothing about a sky.
    if reading.is_plain() || reading.outside().is_some() {
        return None;
    }
    let program = scene.program(&[]);
    let pixels = Pixels::new(&program, reading);
    let chosen = match scene.chapter {
        Chapter::BuildTest => Chosen {
            blue: blue(reading).filter(|blue| *blue != program.blue),
            ..Chosen::default()
        },
        _ => Chosen {
            sky: pixels.sky().filter(|sky| *sky != program.sky),
            paint: pixels
                .paint(&program)
                .filter(|paint| *paint != program.paint),
            ..Chosen::default()
        },
    };
    (chosen != Chosen::default()).then_some(scene.with(chosen))
}

/// Where the right program sees sky and where it hits, and what the picture has there.
struct Pixels {
    /// The weight of the upper color, and the levels.
    sky: Vec<(f64, [i16; 3])>,
    hits: Vec<[i16; 3]>,
}

impl Pixels {
    fn new(program: &Program, reading: &Reading) -> Self {
        let camera = program.camera(reading.width);
        let mut pixels = Self {
            sky: Vec::new(),
            hits: Vec::new(),
        };
        for n in spread(LOOK, reading.pixels.len() as u32) {
            let ray = (program.ray)(program, &camera, n % reading.width, n / reading.width);
            let found = reading.pixels[n as usize];
            match program.search(&ray) {
                Some(_) => pixels.hits.push(found),
                None => pixels
                    .sky
                    .push(((program.blend)(program, ray.direction), found)),
            }
        }
        pixels
    }

    /// The two colors that the sky blends between, if it does.
    fn sky(&self) -> Option<[Color; 2]> {
        let ends = [0, 1, 2].map(|channel| {
            let points: Vec<(f64, f64)> = self
                .sky
                .iter()
                .map(|(weight, levels)| (*weight, levels[channel].into()))
                .collect();
            line(points)
        });
        let [red, green, blue] = [ends[0]?, ends[1]?, ends[2]?];
        let color = |end: usize| Color::new(red[end], green[end], blue[end]);
        Some([color(0), color(1)])
    }

    /// The one color of all that is hit, where the chapter has only one.
    fn paint(&self, program: &Program) -> Option<Color> {
        if program.chapter != Chapter::RedSphere {
            return None;
        }
        let color = [0, 1, 2].map(|channel| {
            let levels = self.hits.iter().map(|levels| levels[channel]).collect();
            constant(levels).map(component)
        });
        Some(Color::new(color[0]?, color[1]?, color[2]?))
    }
}

fn blue(reading: &Reading) -> Option<f64> {
    let places = spread(LOOK, reading.pixels.len() as u32);
    constant(places.map(|n| reading.pixels[n as usize][2]).collect()).map(component)
}

/// The level that almost all of these are.
fn constant(mut levels: Vec<i16>) -> Option<i16> {
    levels.sort_unstable();
    let middle = *levels.get(levels.len() / 2)?;
    let same = levels.iter().filter(|level| level.abs_diff(middle) <= 1);
    (same.count() as f64 >= MOST * levels.len() as f64).then_some(middle)
}

/// The simplest component that gives this level.
fn component(level: i16) -> f64 {
    simplest(f64::from(level) + 0.5, 0.5)
}

/// The components at weight 0 and 1 of levels that lie on a line, if almost all do. The
/// levels are components times 255.999 without their fraction, which is half a level on
/// the average.
fn line(mut points: Vec<(f64, f64)>) -> Option<[f64; 2]> {
    let is_clipped = |point: &(f64, f64)| point.1 <= 0.0 || point.1 >= 255.0;
    // A component beyond 1 ends at 255, and the line is seen where it does not.
    if 4 * points.iter().filter(|point| !is_clipped(point)).count() > points.len() {
        points.retain(|point| !is_clipped(point));
    }
    let all = points.len();
    // What does not lie on the line is left out, and the line drawn again.
    for _ in 0..4 {
        let (start, slope) = least_squares(&points)?;
        let off = |&(weight, level): &(f64, f64)| (start + slope * weight - level).abs();
        let near = points.iter().filter(|point| off(point) <= ROUNDING).count();
        if near as f64 >= MOST * all as f64 {
            let ends = [start, start + slope].map(|level| simplest(level + 0.5, 0.5));
            return ends.iter().all(|end| BEYOND.contains(end)).then_some(ends);
        }
        let mut offs: Vec<f64> = points.iter().map(off).collect();
        offs.sort_by(f64::total_cmp);
        let limit = offs[offs.len() * 9 / 10].max(ROUNDING);
        points.retain(|point| off(point) <= limit);
    }
    None
}

/// The component with the fewest digits that gives this level, give or take so much.
fn simplest(level: f64, give: f64) -> f64 {
    let is_near = |component: &f64| (component * 255.999 - level).abs() <= give;
    [10.0, 20.0, 100.0, 255.0]
        .into_iter()
        .map(|parts: f64| (level / 255.999 * parts).round() / parts)
        .find(is_near)
        .unwrap_or(level / 255.999)
}

/// The height at 0 and the slope of the line through points.
fn least_squares(points: &[(f64, f64)]) -> Option<(f64, f64)> {
    let count = points.len() as f64;
    let (mut x, mut y) = (0.0, 0.0);
    for point in points {
        x += point.0 / count;
        y += point.1 / count;
    }
    let (mut spread, mut together) = (0.0, 0.0);
    for point in points {
        spread += (point.0 - x) * (point.0 - x);
        together += (point.0 - x) * (point.1 - y);
    }
    let slope = together / spread;
    (spread > 0.0).then_some((y - slope * x, slope))
}
