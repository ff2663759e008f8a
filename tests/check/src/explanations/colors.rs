//! Least squares: the colors that a reader chose, from the picture.

use std::collections::HashSet;

use common::rtweekend::{Color, Vec3};

use ::slips::{Chapter, Ends, Program, Room, Slip};

use super::slips::name_of;
use super::{Evidence, Hypothesis, spread};
use crate::bits::{Pixel, number};
use crate::reading::Reading;
use crate::scene::{Chosen, Scene};

/// How many pixels the colors are taken from, and how many while other numbers are searched.
pub(super) const LOOK: u32 = 4000;
pub(super) const GLANCE: u32 = 300;
/// How many levels a pixel may be off, since fractions were cut off.
const ROUNDING: f64 = 1.5;
/// The share of pixels that have to follow the colors: the others may be anything.
const MOST: f64 = 0.5;
/// Half a level, and a little more: at a level's lower end lie the components 0 and 1.
const HALF: f64 = 0.51;
/// The same of the ends of a line, times the square root of how many levels it is fitted to: some
/// three standard deviations.
const FITTED: f64 = 2.0;
/// How many halvings find a component to less than a rounding.
const HALVINGS: u32 = 40;
/// Two levels that are far from each other and from both ends.
const LEVELS: [i32; 2] = [64, 192];
/// Of what is hit there is at most so many times as much as of the sky.
const SKY: usize = 8;
/// A pixel that is off by more levels may be anything.
const FAR: f64 = 24.0;
/// How many lines are tried, one for so many points.
const LINES: std::ops::RangeInclusive<usize> = 8..=24;
const POINTS: usize = 100;

/// Components that people type: some forget where they end.
const BEYOND: std::ops::RangeInclusive<f64> = -1.0..=3.0;

/// That there are colors of the reader's own, beside their numbers.
const NAME: f64 = 6.0;
/// That a component is none that a color has: a slip in the blend is likelier.
const TOO_FAR: f64 = 8.0;
/// Which component of three.
const AXIS: f64 = 1.6;
/// What a component of a color is where that of the normal is -1, and where it is 1.
const BOOKS_ENDS: [f64; 2] = [0.0, 1.0];
/// That a number is the book's.
pub(super) const KEPT: f64 = 1.0;

/// The program in the reader's own colors, if those of so many of the picture's pixels are not the
/// book's.
pub(crate) fn in_colors(evidence: &Evidence, right: &Hypothesis, look: u32) -> Option<Hypothesis> {
    let reading = evidence.reading;
    // A picture of one color says nothing about a sky.
    let has_a_sky = right.scene.chapter != Chapter::BuildTest;
    if reading.is_plain() || has_a_sky && reading.outside().is_some() {
        return None;
    }
    let scene = with_slips(&right.scene, &right.slips, reading, look);
    (scene.chosen != right.scene.chosen).then(|| Hypothesis {
        scene,
        name: right.name + name(&scene),
        ..right.clone()
    })
}

/// The program in the colors that so many pixels have, where these are not the book's.
pub(super) fn colored(it: &Hypothesis, reading: &Reading, look: u32) -> Hypothesis {
    Hypothesis {
        scene: with_slips(&it.scene, &it.slips, reading, look),
        ..it.clone()
    }
}

/// The scene in the book's colors.
pub(super) fn books(scene: &Scene) -> Scene {
    scene.with(Chosen {
        sky: None,
        paint: None,
        blue: None,
        ..scene.chosen
    })
}

/// The scene in colors near its own that have a digit less: where a level is not the book's
/// multiple of a component, colors look a level darker or lighter than they are.
pub(super) fn simple(scene: &Scene) -> Scene {
    let number = |it: f64| Scale::BOOK.simplest(it * Scale::BOOK.factor, 2.0);
    let simple = |color: Color| Color::from_array(color.to_array().map(number));
    let ends = |(axis, ends): Ends| (axis, ends.map(number));
    scene.with(Chosen {
        sky: scene.chosen.sky.map(|sky| sky.map(simple)),
        paint: scene.chosen.paint.map(simple),
        shade: scene.chosen.shade.map(|shade| shade.map(ends)),
        ..scene.chosen
    })
}

fn with_slips(scene: &Scene, slips: &[&Slip], reading: &Reading, look: u32) -> Scene {
    let plain = books(scene);
    let program = plain.program(slips);
    let chosen = match scene.chapter {
        Chapter::BuildTest => Chosen {
            blue: blue(reading).filter(|blue| *blue != program.blue),
            ..plain.chosen
        },
        _ => {
            let pixels = Pixels::new(&program, reading, look);
            Chosen {
                sky: pixels.sky().filter(|sky| !are_near(*sky, program.sky)),
                paint: pixels
                    .paint(&program)
                    .filter(|paint| *paint != program.paint),
                ..plain.chosen
            }
        }
    };
    plain.with(chosen)
}

/// The program with a color of what is hit that is made of the normal otherwise, each component of
/// one of the normal's.
pub(super) fn shaded(it: &Hypothesis, reading: &Reading, look: u32) -> Option<Hypothesis> {
    let plain = Chosen {
        shade: None,
        ..it.scene.chosen
    };
    let program = it.scene.with(plain).program(&it.slips);
    let shade = Pixels::new(&program, reading, look).shade(&program)?;
    let is_the_books = |(channel, &(axis, ends)): (usize, &Ends)| {
        let mut pairs = ends.iter().zip(BOOKS_ENDS);
        axis == channel && pairs.all(|(end, book)| (end - book).abs() * Scale::BOOK.factor < 2.0)
    };
    if shade.iter().enumerate().all(is_the_books) {
        return None;
    }
    let chosen = Chosen {
        shade: Some(shade),
        ..plain
    };
    Some(Hypothesis {
        scene: it.scene.with(chosen),
        ..it.clone()
    })
}

/// Whether they draw the same but for roundings: less than two levels apart.
fn are_near(sky: [Color; 2], other: [Color; 2]) -> bool {
    let mut pairs = sky.into_iter().zip(other);
    pairs.all(|(one, other)| (one - other).abs().max_element() * Scale::BOOK.factor < 2.0)
}

/// Bits of the reader's own colors.
pub(super) fn name(scene: &Scene) -> f64 {
    let Chosen {
        sky,
        paint,
        shade,
        blue,
        ..
    } = scene.chosen;
    let book = scene.without_choices().program(&[]);
    let components = |colors: Option<&[Color]>, book: &[Color]| -> f64 {
        let colors = colors.unwrap_or_default().iter();
        let pairs = colors
            .zip(book)
            .flat_map(|(own, book)| own.to_array().into_iter().zip(book.to_array()));
        pairs
            .map(|(own, book)| match own {
                own if own == book => KEPT,
                own if (0.0..=1.0).contains(&own) => number(own),
                own => number(own) + TOO_FAR,
            })
            .sum()
    };
    let numbers = components(sky.as_ref().map(|it| &it[..]), &book.sky)
        + components(paint.as_ref().map(std::slice::from_ref), &[book.paint])
        + shade
            .iter()
            .flatten()
            .enumerate()
            .map(end_name)
            .sum::<f64>()
        + blue.map_or(0.0, number);
    if numbers > 0.0 { NAME + numbers } else { 0.0 }
}

/// Bits of what a component of a hit's color is made of.
fn end_name((channel, &(axis, ends)): (usize, &Ends)) -> f64 {
    match (channel, ends) {
        book if book == (axis, BOOKS_ENDS) => KEPT,
        _ => AXIS + ends.map(number).iter().sum::<f64>(),
    }
}

/// A straight line from components to levels: what a program does before it cuts off.
#[derive(Clone, Copy)]
struct Scale {
    factor: f64,
    offset: f64,
}

impl Scale {
    const BOOK: Self = Self {
        factor: 255.999,
        offset: 0.0,
    };

    /// That of a function, by the least components that give two levels (bisection).
    fn of(level: fn(f64) -> i32) -> Self {
        let least = |wanted: i32| {
            let (mut below, mut above) = (0.0, 1.0);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (below + above);
                match level(middle) < wanted {
                    true => below = middle,
                    false => above = middle,
                }
            }
            above
        };
        let [low, high] = LEVELS.map(least);
        let factor = f64::from(LEVELS[1] - LEVELS[0]) / (high - low);
        Self {
            factor,
            offset: f64::from(LEVELS[0]) - factor * low,
        }
    }

    /// The component with the fewest digits that gives this level.
    fn component(&self, level: i16) -> f64 {
        self.simplest(f64::from(level) + 0.5, HALF)
    }

    /// The same of the middle of a level, give or take so much.
    fn simplest(&self, level: f64, give: f64) -> f64 {
        let component = (level - self.offset) / self.factor;
        let is_near = |simple: &f64| (simple - component).abs() * self.factor <= give;
        [10.0, 20.0, 100.0, 255.0, 1000.0]
            .into_iter()
            .map(|parts: f64| (component * parts).round() / parts)
            .find(is_near)
            .unwrap_or(component)
    }
}

/// Whether one program cuts off other multiples of a component than the other, near the book's.
pub(super) fn is_rescaled(program: &Program, other: &Program) -> bool {
    let [scale, other] = [program, other].map(|it| Scale::of(it.level));
    let is_near = (other.factor - Scale::BOOK.factor).abs() < 2.0;
    is_near && (scale.factor - other.factor).abs() + (scale.offset - other.offset).abs() > 1e-6
}

/// Weights that show all colors of a sky.
const WEIGHTS: u32 = 4096;
/// One in so many is no chance.
const SOME: usize = 10;

/// The same with a slip in the scale of levels, if its sky has one pixel's color in ten, and of those
/// one in ten only so: colors tell that wherever they are seen.
pub(super) fn rescaled(evidence: &Evidence, it: &Hypothesis) -> Option<Hypothesis> {
    let reading = evidence.reading;
    let right = it.scene.program(&it.slips);
    if right.chapter == Chapter::BuildTest {
        return None;
    }
    let places: Vec<u32> = spread(LOOK, reading.pixels.len() as u32).collect();
    let count = |program: &Program| {
        let color = |n: u32| (program.lerp)(program.sky, f64::from(n) / f64::from(WEIGHTS));
        let levels = |n: u32| {
            let color = color(n).to_array();
            let level = |channel: usize| it.conversion.apply((program.level)(color[channel]));
            program.channels.map(level)
        };
        let colors: HashSet<Pixel> = (0..=WEIGHTS).map(levels).collect();
        let places = places.iter().map(|&n| reading.pixels[n as usize]);
        places.filter(|pixel| colors.contains(pixel)).count()
    };
    let slips = evidence.slips(&it.scene);
    let slips = slips.filter(|slip| is_rescaled(&right, &slip.put_to(right)));
    let counted = slips.map(|slip| (count(&slip.put_to(right)), slip));
    let (most, slip) = counted.max_by_key(|(count, _)| *count)?;
    let is_sky = SOME * most > places.len();
    (is_sky && SOME * (most - count(&right).min(most)) > most).then(|| Hypothesis {
        slips: vec![slip],
        name: it.name + name_of(&[slip]),
        ..it.clone()
    })
}

/// A weight, and the levels that are there.
type Point = (f64, [i16; 3]);

/// Where the right program sees sky and where it hits, and what the picture has there.
struct Pixels {
    scale: Scale,
    /// The weight of the upper color, and the levels.
    sky: Vec<Point>,
    hits: Vec<(Vec3, [i16; 3])>,
}

impl Pixels {
    fn new(program: &Program, reading: &Reading, look: u32) -> Self {
        let camera = program.camera(reading.width);
        let mut pixels = Self {
            scale: Scale::of(program.level),
            sky: Vec::new(),
            hits: Vec::new(),
        };
        for n in spread(look, reading.pixels.len() as u32) {
            let (i, j) = (program.order)(n, reading.width, reading.height);
            let ray = (program.ray)(program, &camera, i, j);
            let found = reading.pixels[n as usize];
            match program.normal(&ray) {
                Some(normal) => pixels.hits.push((normal, found)),
                None => pixels
                    .sky
                    .push(((program.blend)(program, ray.direction), found)),
            }
        }
        pixels
    }

    /// The two colors that the sky blends between, if it does.
    fn sky(&self) -> Option<[Color; 2]> {
        let mut sky = self.sky.clone();
        let ends = lines(&mut sky, self.scale);
        let [red, green, blue] = [ends[0]?, ends[1]?, ends[2]?];
        let color = |end: usize| Color::new(red[end], green[end], blue[end]);
        Some([color(0), color(1)])
    }

    /// Of which component of the normal each one of the color is made, and what of it.
    fn shade(&self, program: &Program) -> Option<[Ends; 3]> {
        let has_normals =
            program.chapter.room() != Room::None && program.chapter != Chapter::RedSphere;
        // Without a sky beside it, it may be anything.
        if !has_normals || SKY * self.sky.len() < self.hits.len() {
            return None;
        }
        let along = [0, 1, 2].map(|axis| {
            let weight = |normal: &Vec3| 0.5 * (normal[axis] + 1.0);
            let hits = self.hits.iter();
            let mut hits: Vec<Point> = hits.map(|(normal, it)| (weight(normal), *it)).collect();
            (lines(&mut hits, self.scale), hits)
        });
        let nearest = |channel: usize| {
            let all = (0..).zip(&along).filter_map(|(axis, (ends, hits))| {
                let ends = ends[channel]?;
                Some((self.off(hits, channel, ends), (axis, ends)))
            });
            let nearest = all.min_by(|(one, _), (other, _)| one.total_cmp(other));
            nearest.map(|(_, found)| found)
        };
        Some([nearest(0)?, nearest(1)?, nearest(2)?])
    }

    /// How far levels are from a line.
    fn off(&self, points: &[Point], channel: usize, [start, end]: [f64; 2]) -> f64 {
        let off = |(weight, levels): &Point| {
            let component = start + (end - start) * weight;
            let level = self.scale.factor * component + self.scale.offset;
            let off = level.clamp(0.0, 255.0) - f64::from(levels[channel]);
            off.abs().min(FAR)
        };
        points.iter().map(off).sum()
    }

    /// The one color of all that is hit, where the chapter has only one.
    fn paint(&self, program: &Program) -> Option<Color> {
        if program.chapter != Chapter::RedSphere {
            return None;
        }
        let color = [0, 1, 2].map(|channel| {
            let levels = self
                .hits
                .iter()
                .map(|(_, levels)| levels[channel])
                .collect();
            constant(levels).map(|level| self.scale.component(level))
        });
        Some(Color::new(color[0]?, color[1]?, color[2]?))
    }
}

fn blue(reading: &Reading) -> Option<f64> {
    let places = spread(LOOK, reading.pixels.len() as u32);
    let level = constant(places.map(|n| reading.pixels[n as usize][2]).collect())?;
    Some(Scale::BOOK.component(level))
}

/// The level that most of these are.
fn constant(mut levels: Vec<i16>) -> Option<i16> {
    levels.sort_unstable();
    let middle = *levels.get(levels.len() / 2)?;
    let same = levels.iter().filter(|level| level.abs_diff(middle) <= 1);
    (same.count() as f64 >= MOST * levels.len() as f64).then_some(middle)
}

/// The ends of each channel's line.
fn lines(points: &mut [Point], scale: Scale) -> [Option<[f64; 2]>; 3] {
    points.sort_by(|(one, _), (other, _)| one.total_cmp(other));
    [0, 1, 2].map(|channel| {
        let points = points
            .iter()
            .map(|(weight, levels)| (*weight, levels[channel].into()));
        line(points.collect(), scale)
    })
}

/// The components at weight 0 and 1 of levels that lie on a line, if most do (random sample
/// consensus, Fischler and Bolles, 1981), from points in the order of their weights. Levels have
/// lost their fraction, which is half a level on the average.
fn line(mut points: Vec<(f64, f64)>, scale: Scale) -> Option<[f64; 2]> {
    let is_clipped = |point: &(f64, f64)| point.1 <= 0.0 || point.1 >= 255.0;
    // A component beyond 1 ends at 255, and the line is seen where it does not.
    if 4 * points.iter().filter(|point| !is_clipped(point)).count() > points.len() {
        points.retain(|point| !is_clipped(point));
    }
    let is_near = |[start, end]: [f64; 2]| {
        move |&&(weight, level): &&(f64, f64)| {
            (start + (end - start) * weight - level).abs() <= ROUNDING
        }
    };
    let count = |line| points.iter().filter(is_near(line)).count();
    // A few points tell nothing of a line.
    let half = Some(points.len() / 2).filter(|half| *half > 0)?;
    let through = |n: usize| {
        let ((x, y), (to_x, to_y)) = (points[n], points[n + half]);
        let slope = (to_y - y) / (to_x - x);
        [y - slope * x, y + slope * (1.0 - x)]
    };
    let count_of_lines = (points.len() / POINTS).clamp(*LINES.start(), *LINES.end());
    let lines = (0..count_of_lines).map(|n| through(n * half / count_of_lines));
    let mut best = lines.max_by_key(|line| count(*line))?;
    for _ in 0..2 {
        let near: Vec<(f64, f64)> = points.iter().filter(is_near(best)).copied().collect();
        let (start, slope) = least_squares(&near)?;
        best = [start, start + slope];
    }
    let give = FITTED / (points.len() as f64).sqrt();
    // At either end levels stop.
    let end = |level: f64| match level {
        level if level.abs() < give => 0.0,
        level if (level - 255.0).abs() < give => 1.0,
        level => scale.simplest(level + 0.5, give),
    };
    let ends = best.map(end);
    let is_line = count(best) as f64 >= MOST * points.len() as f64;
    (is_line && ends.iter().all(|end| BEYOND.contains(end))).then_some(ends)
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
