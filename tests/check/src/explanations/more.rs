//! Segmentation by connected boxes: what is drawn beside all that a scene has.
//!
//! Each box is told, in each of its rows from which column to which something else is
//! drawn, and the pixels there alone. The rest is judged as a picture of its own.

use std::ops::Range;

use ::slips::{Program, World};

use super::antialiased::{EDGE, SINGLE, contrast};
use super::{But, Evidence, Explanation, Hypothesis, Seen, antialiased, spread};
use crate::bits::{Pixel, distance, told};
use crate::reading::Reading;
use crate::verdict::Near;

/// That something more is drawn: one picture in two hundred has a sphere that its chapter
/// has not.
const NAME: f64 = 11.0;
/// What is no farther from the next is of one thing.
const NEAR: u32 = 3;
/// Bits of a pixel by itself.
const ODD: f64 = 24.0;
/// In how many pixels the first sphere is looked for.
const LOOK: u32 = 10_000;
/// What is in more pieces is no few things.
const PIECES: usize = 64;
/// Of what is odd in a sphere one pixel in so many lies beside it.
const BESIDE: usize = 10;
/// One pixel in so many that are odd may be what lies behind a sphere that is not there.
const BEHIND: usize = 4;

/// The program's picture with something more in it: as it is, and with several rays a pixel.
pub(crate) fn more(evidence: &Evidence, it: &Hypothesis) -> Vec<Explanation> {
    let reading = evidence.reading;
    let Some(drawn) = it.drawn(reading) else {
        return Vec::new();
    };
    let odd = Odd::of(reading, &drawn);
    let boxes = odd.boxes(&drawn);
    let runs: Vec<Range<usize>> = boxes.iter().flat_map(|it| odd.runs(it)).collect();
    // Something is told to be added to a chapter that was named, or whose sphere is seen.
    let is_named = !evidence.scene.is_guessed() && it.scene.chapter == evidence.scene.chapter;
    if runs.is_empty()
        || !is_named && !odd.shows_the_first_sphere(it)
        || odd.shows_what_lies_behind(it, &runs)
        || odd.is_the_first_sphere(it, &runs)
    {
        return Vec::new();
    }
    let is_missing = odd.shows_the_sky(it, &runs);
    let mut is_more = vec![false; drawn.len()];
    let mut rest = reading.pixels.clone();
    for n in runs.into_iter().flatten() {
        (is_more[n], rest[n]) = (true, drawn[n]);
    }
    let rest = Reading {
        pixels: rest,
        encoding: None,
        ..*reading
    };
    let places: f64 = boxes.iter().map(|it| odd.place(it)).sum();
    let count = is_more.iter().filter(|is| **is).count();
    // Where the scene has the smaller part, it is not what something was added to.
    if 2 * count > drawn.len() {
        return Vec::new();
    }
    let bits = NAME + places + told(reading, |n| is_more[n]).min(ODD * count as f64);
    let of_the_rest = Evidence {
        reading: &rest,
        ..*evidence
    };
    let explained = antialiased(&of_the_rest, &drawn, [(it, None)].into_iter());
    let explained = explained.into_iter().filter(|it| it.seen.is_none());
    let explained = explained.chain([it.explaining(&rest, &drawn)]);
    let seen = if is_missing { Seen::Said } else { Seen::More };
    explained
        .map(|mut it| {
            // What was left out has no mixed edges.
            if let [But::Antialiased { samples, .. }, ..] = &mut it.but[..] {
                *samples = samples.filter(|samples| *samples < SINGLE);
            }
            Explanation {
                name: it.name + bits,
                seen: Some(seen(said(&it, &boxes, is_missing, drawn.len()))),
                ..it
            }
        })
        .collect()
}

/// Columns and rows.
type Box = [Range<u32>; 2];

/// The pixels of a picture that are not a program's.
struct Odd<'a> {
    reading: &'a Reading,
    is_odd: Vec<bool>,
}

impl<'a> Odd<'a> {
    fn of(reading: &'a Reading, drawn: &[Pixel]) -> Self {
        let pairs = drawn.iter().zip(&reading.pixels);
        let is_odd = pairs.map(|(drawn, found)| distance(*drawn, *found) > 1);
        Self {
            reading,
            is_odd: is_odd.collect(),
        }
    }

    /// The boxes that save more than they cost. With several rays a pixel all edges of the
    /// program's are odd, so it is looked for what lies beside them.
    fn boxes(&self, drawn: &[Pixel]) -> Vec<Box> {
        let width = self.reading.width;
        let contrast = contrast(drawn, width as usize);
        let is_core = |&n: &usize| self.is_odd[n] && contrast[n] <= EDGE;
        let pixel = |n: usize| {
            let (i, j) = (n as u32 % width, n as u32 / width);
            [i..i + 1, j..j + 1]
        };
        let boxes = joined((0..drawn.len()).filter(is_core).map(pixel));
        let boxes = boxes.iter().filter_map(|it| self.with_its_rim(it));
        let saves = |it: &Box| self.place(it) < ODD * self.count(self.runs(it));
        boxes.filter(saves).collect()
    }

    /// The box around all that is odd in one and near it.
    fn with_its_rim(&self, [columns, rows]: &Box) -> Option<Box> {
        let wider =
            |it: &Range<u32>, most: u32| it.start.saturating_sub(NEAR)..(it.end + NEAR).min(most);
        let Reading { width, height, .. } = *self.reading;
        let wider = [wider(columns, width), wider(rows, height)];
        let run = |run: Range<usize>| {
            let (from, to) = (run.start as u32, run.end as u32 - 1);
            [from % width..to % width + 1, from / width..to / width + 1]
        };
        self.runs(&wider)
            .map(run)
            .reduce(|one, other| around(&one, &other))
    }

    /// From the first to the last in each row of a box.
    fn runs(&self, [columns, rows]: &Box) -> impl Iterator<Item = Range<usize>> {
        rows.clone().filter_map(move |j| {
            let at = |i: u32| (j * self.reading.width + i) as usize;
            let mut odd = columns.clone().filter(|&i| self.is_odd[at(i)]);
            let first = odd.next()?;
            Some(at(first)..at(odd.next_back().unwrap_or(first)) + 1)
        })
    }

    fn count(&self, runs: impl Iterator<Item = Range<usize>>) -> f64 {
        runs.flatten().filter(|&n| self.is_odd[n]).count() as f64
    }

    /// Bits of a box, and of its runs.
    fn place(&self, [columns, rows]: &Box) -> f64 {
        let corners = 4.0 * f64::from(self.reading.width.max(self.reading.height)).log2();
        corners + 2.0 * rows.len() as f64 * (columns.len() as f64).log2()
    }

    /// Whether most of what the program's first sphere covers is as the program has it; not where
    /// it has none, or none is seen.
    fn shows_the_first_sphere(&self, it: &Hypothesis) -> bool {
        let shows_it = self.hits_the_first_sphere(it);
        let all = spread(LOOK, self.is_odd.len() as u32);
        let covered: Vec<u32> = all.filter(|&n| shows_it(n)).collect();
        let odd = covered.iter().filter(|&&n| self.is_odd[n as usize]);
        2 * odd.count() < covered.len()
    }

    /// Whether it is not that something more is there, but that the first sphere has other colors.
    fn is_the_first_sphere(&self, it: &Hypothesis, runs: &[Range<usize>]) -> bool {
        let shows_it = self.hits_the_first_sphere(it);
        let odd = runs.iter().cloned().flatten().filter(|&n| self.is_odd[n]);
        let count = odd.clone().filter(|&n| !shows_it(n as u32)).count();
        BESIDE * count < odd.count()
    }

    /// Whether the program's nth pixel shows its first sphere.
    fn hits_the_first_sphere(&self, it: &Hypothesis) -> impl Fn(u32) -> bool + use<> {
        let program = it.scene.program(&it.slips);
        let width = self.reading.width;
        let camera = program.camera(width);
        move |n| {
            let ray = (program.ray)(&program, &camera, n % width, n / width);
            let first = program.world.first();
            program
                .search(&ray)
                .is_some_and(|(_, ball)| Some(&ball) == first)
        }
    }

    /// Whether it is not that something is there, but that the first sphere is not.
    fn shows_what_lies_behind(&self, it: &Hypothesis, runs: &[Range<usize>]) -> bool {
        let program = it.scene.program(&it.slips);
        let behind = Program {
            world: program.world.without(1),
            ..program
        };
        BEHIND * self.count_of(it, &behind, runs) > self.count(runs.iter().cloned()) as usize
    }

    /// Whether nothing is there, where something should be.
    fn shows_the_sky(&self, it: &Hypothesis, runs: &[Range<usize>]) -> bool {
        let sky = Program {
            world: World::of(&[]),
            ..it.scene.program(&it.slips)
        };
        2 * self.count_of(it, &sky, runs) > self.count(runs.iter().cloned()) as usize
    }

    /// How many odd pixels are those of a program.
    fn count_of(&self, it: &Hypothesis, program: &Program, runs: &[Range<usize>]) -> usize {
        let drawn = program.run(self.reading.width);
        let odd = runs.iter().cloned().flatten().filter(|&n| self.is_odd[n]);
        let is_drawn =
            |&n: &usize| distance(it.pixel(&drawn, n as u32), self.reading.pixels[n]) <= 1;
        odd.filter(is_drawn).count()
    }
}

fn are_near(one: &Box, other: &Box) -> bool {
    let mut pairs = one.iter().zip(other);
    let is_near = |(one, other): (&Range<u32>, &Range<u32>)| {
        one.start < other.end + NEAR && other.start < one.end + NEAR
    };
    pairs.all(is_near)
}

fn around(one: &Box, other: &Box) -> Box {
    [0, 1].map(|n| one[n].start.min(other[n].start)..one[n].end.max(other[n].end))
}

/// Those that are near each other as one; none if there are too many.
fn joined(boxes: impl Iterator<Item = Box>) -> Vec<Box> {
    let mut joined: Vec<Box> = Vec::new();
    for mut it in boxes {
        while let Some(near) = joined.iter().position(|other| are_near(&it, other)) {
            it = around(&it, &joined.swap_remove(near));
        }
        joined.push(it);
        if joined.len() > PIECES {
            return Vec::new();
        }
    }
    joined
}

fn said(it: &Explanation, boxes: &[Box], is_missing: bool, pixels: usize) -> String {
    let near = Near {
        scene: it.scene,
        but: it.but.clone(),
        left: it.left,
    };
    let but = match near.clause(pixels) {
        but if but.is_empty() => but,
        but => format!(", but {but}"),
    };
    let chapter = it.scene.chapter.name();
    let place = |[columns, rows]: &Box| {
        let (right, below) = (columns.end - 1, rows.end - 1);
        format!(
            "columns {} to {right}, rows {} to {below}",
            columns.start, rows.start
        )
    };
    let places: Vec<String> = boxes.iter().map(place).collect();
    let places = places.join(", and in ");
    let what = match (is_missing, boxes.len()) {
        (true, _) => format!(
            "Of what {chapter} has, something is missing in {places}: the sky is seen there. Is a hit thrown away?"
        ),
        (_, 1) => format!(
            "Beside what {chapter} has, something more is drawn in {places}: is it another sphere?"
        ),
        _ => format!(
            "Beside what {chapter} has, something more is drawn in {places}: are they other spheres?"
        ),
    };
    format!("{what} Outside of that all is right{but}.")
}
