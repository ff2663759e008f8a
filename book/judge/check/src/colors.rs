//! Least squares: the colors that a reader chose, from the picture.

use common::rtweekend::Color;
use slips::{Chapter, Program};

use crate::candidate::Candidate;
use crate::pixels::spread;
use crate::reading::Reading;
use crate::scene::Chosen;

/// How many pixels the colors are taken from.
const LOOK: u32 = 4000;
/// From a component to a level, before the fraction is cut off.
const SCALE: f64 = 255.999;
/// How many levels a pixel may be off a line, since fractions were cut off.
const ROUNDING: f64 = 1.5;
/// Half a level, and a little more: at a level's lower end lie the components 0 and 1.
const HALF: f64 = 0.51;
/// How many lines through two points each are tried: half of the points may be anything.
const LINES: usize = 24;

/// The right program in the reader's own colors, if those that the picture has are not the
/// book's, and somebody may have typed them.
pub(crate) fn own(reading: &Reading, right: &Candidate) -> Option<Candidate> {
    // A picture of one color says nothing about a sky.
    if reading.is_plain() || reading.outside().is_some() {
        return None;
    }
    let program = right.scene.program(&[]);
    let chosen = if right.scene.chapter == Chapter::BuildTest {
        Chosen {
            blue: blue(reading).filter(|blue| *blue != program.blue),
            ..Chosen::default()
        }
    } else {
        let pixels = Pixels::new(&program, reading);
        Chosen {
            sky: pixels.sky().filter(|sky| !are_near(*sky, program.sky)),
            paint: pixels.paint().filter(|paint| *paint != program.paint),
            blue: None,
        }
    };
    let is_own = chosen != Chosen::default() && is_typed(chosen.sky) && !is_a_mixture(chosen.sky);
    is_own.then(|| Candidate {
        scene: right.scene.with(chosen),
        ..right.clone()
    })
}

/// Whether they draw the same but for roundings: less than two levels apart.
fn are_near(sky: [Color; 2], other: [Color; 2]) -> bool {
    let mut pairs = sky.into_iter().zip(other);
    pairs.all(|(one, other)| (one - other).abs().max_element() * SCALE < 2.0)
}

/// Whether both ends are the book's white and blue in some mixture, black and gray among them:
/// a wrong weight draws such a sky.
fn is_a_mixture(sky: Option<[Color; 2]>) -> bool {
    let [white, blue] = Program::right(Chapter::Gradient).sky;
    let across = white.cross(blue);
    sky.is_some_and(|sky| sky.iter().all(|color| across.dot(*color).abs() < 1e-3))
}

/// Whether all components are hundredths from 0 to 1, or all are levels.
fn is_typed(sky: Option<[Color; 2]>) -> bool {
    let all = sky.iter().flatten().flat_map(|color| color.to_array());
    let all: Vec<f64> = all.collect();
    let are_parts = |parts: f64| {
        let is_part = |it: &f64| (it * parts - (it * parts).round()).abs() < 1e-3;
        all.iter().all(is_part)
    };
    let are_colors = all.iter().all(|it| (0.0..=1.0).contains(it));
    are_colors && (are_parts(100.0) || are_parts(255.0))
}

/// The component with the fewest digits within `give` levels of a level.
fn simplest(level: f64, give: f64) -> f64 {
    let component = level / SCALE;
    let is_near = |simple: &f64| (simple - component).abs() * SCALE <= give;
    [10.0, 20.0, 100.0, 255.0, 1000.0]
        .into_iter()
        .map(|parts: f64| (component * parts).round() / parts)
        .find(is_near)
        .unwrap_or(component)
}

/// A weight of the sky's upper color, and the levels that are there.
type Point = (f64, [i16; 3]);

/// What the picture has where the right program sees sky, and where it hits.
struct Pixels {
    sky: Vec<Point>,
    hits: Vec<[i16; 3]>,
    /// Whether all that is hit has one color.
    is_painted: bool,
}

impl Pixels {
    fn new(program: &Program, reading: &Reading) -> Self {
        let camera = program.camera(reading.width);
        let mut pixels = Self {
            sky: Vec::new(),
            hits: Vec::new(),
            is_painted: program.chapter == Chapter::RedSphere,
        };
        for n in spread(LOOK, reading.pixels.len() as u32) {
            let (i, j) = (program.order)(n, reading.width, reading.height);
            let ray = program.ray(&camera, i, j);
            let found = reading.pixels[n as usize];
            if program.search(&ray).is_some() {
                pixels.hits.push(found);
            } else {
                let weight = program.weight_of_blue(ray.direction);
                pixels.sky.push((weight, found));
            }
        }
        pixels
    }

    /// The two colors that the sky blends between, if it does.
    fn sky(&self) -> Option<[Color; 2]> {
        let mut sky = self.sky.clone();
        sky.sort_by(|(one, _), (other, _)| one.total_cmp(other));
        let ends = [0, 1, 2].map(|channel| {
            let points = sky
                .iter()
                .map(|(weight, levels)| (*weight, levels[channel].into()));
            line(&points.collect::<Vec<_>>())
        });
        let [red, green, blue] = [ends[0]?, ends[1]?, ends[2]?];
        let color = |end: usize| Color::new(red[end], green[end], blue[end]);
        Some([color(0), color(1)])
    }

    /// The one color of all that is hit, where the chapter has only one.
    fn paint(&self) -> Option<Color> {
        if !self.is_painted {
            return None;
        }
        let color = [0, 1, 2].map(|channel| {
            let levels = self.hits.iter().map(|levels| levels[channel]);
            constant(levels.collect()).map(component)
        });
        Some(Color::new(color[0]?, color[1]?, color[2]?))
    }
}

fn blue(reading: &Reading) -> Option<f64> {
    let places = spread(LOOK, reading.pixels.len() as u32);
    let levels = places.map(|n| reading.pixels[n as usize][2]);
    constant(levels.collect()).map(component)
}

fn component(level: i16) -> f64 {
    simplest(f64::from(level) + 0.5, HALF)
}

/// The level that most of these are.
fn constant(mut levels: Vec<i16>) -> Option<i16> {
    levels.sort_unstable();
    let middle = *levels.get(levels.len() / 2)?;
    let same = levels.iter().filter(|level| level.abs_diff(middle) <= 1);
    (2 * same.count() >= levels.len()).then_some(middle)
}

/// The components at weight 0 and 1 of levels that lie on a line, if most do (random sample
/// consensus, Fischler and Bolles, 1981), from points in the order of their weights. Levels
/// have lost their fraction, which is half a level on the average.
fn line(points: &[(f64, f64)]) -> Option<[f64; 2]> {
    let is_near = |[start, end]: [f64; 2]| {
        move |&&(weight, level): &&(f64, f64)| {
            (start + (end - start) * weight - level).abs() <= ROUNDING
        }
    };
    let count = |line| points.iter().filter(is_near(line)).count();
    // A few points say nothing of a line.
    let half = Some(points.len() / 2).filter(|half| *half > 0)?;
    let through = |n: usize| {
        let ((x, y), (to_x, to_y)) = (points[n], points[n + half]);
        let slope = (to_y - y) / (to_x - x);
        [y - slope * x, y + slope * (1.0 - x)]
    };
    let lines = (0..LINES).map(|n| through(n * half / LINES));
    let mut best = lines.max_by_key(|line| count(*line))?;
    let mut give = [HALF; 2];
    for _ in 0..2 {
        let near: Vec<(f64, f64)> = points.iter().filter(is_near(best)).copied().collect();
        (best, give) = least_squares(&near)?;
    }
    // At either end levels stop.
    let end = |end: usize| match (best[end], give[end]) {
        (level, give) if level.abs() < give => 0.0,
        (level, give) if (level - 255.0).abs() < give => 1.0,
        (level, give) => simplest(level + 0.5, give),
    };
    (2 * count(best) >= points.len()).then(|| [end(0), end(1)])
}

/// A line through points by its heights at 0 and at 1, and how far these may be off: some
/// three standard deviations, where each level has lost a fraction.
fn least_squares(points: &[(f64, f64)]) -> Option<([f64; 2], [f64; 2])> {
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
    // The deviation of a fraction is 1/√12.
    let give =
        |at: f64| 3.0 / 12.0_f64.sqrt() * (1.0 / count + (at - x) * (at - x) / spread).sqrt();
    let height = |at: f64| y + slope * (at - x);
    (spread > 0.0).then(|| ([height(0.0), height(1.0)], [give(0.0), give(1.0)]))
}
