//! Classification by the nearest program: which chapter a picture is meant to be, where
//! nobody says so.

use slips::{Chapter, Edition};

use crate::bits::{self, distance};
use crate::evidence::{Evidence, Known};
use crate::explanations::{
    Hypothesis, Places, chosen_otherwise, in_colors, outlined, ramps, right, single, two,
};
use crate::judge::likeliest;
use crate::reading::Reading;
use crate::scene::Scene;
use crate::surfaces;

/// How many pixels are looked at to find those that may be the nearest, and these.
const LOOKS: [u32; 2] = [100, 1500];
/// How many these are.
const FEW: usize = 20;
/// Of a picture's bits a scene that is near leaves one in so many.
const CHOSEN: f64 = 4.0;
/// By levels that were lost a slip's or a probe's picture may be so much nearer than the right one.
const CHANCE: f64 = 1.1;
/// A pixel that is off by more levels is far off, unless one of the program's own, so many columns
/// or rows away, is: edges are mixed in many a file.
const FAR: u16 = 16;
const BESIDE: u32 = 4;
/// A program is near if no more than one pixel in so many is far off.
const SOME: usize = 100;

/// The scene whose picture comes nearest: right, with one slip, in colors of the reader's own,
/// or but for the colors of all that is hit. The first in the book of several that draw the
/// same, as chapters 3 and 4 do.
pub fn scene(reading: &Reading) -> Scene {
    let (mut least, mut nearest, is_near) = nearest(reading);
    // What a reader chose explains nearly all, or it was something else; and it is not near a
    // picture in which nothing is the reader's.
    let alone = bits::alone(reading);
    if CHOSEN * least > alone && !is_near {
        let known = Known::default();
        let places = LOOKS.map(|count| Places::new(reading, None, count));
        // Chapter 4 draws what chapter 3 does.
        let others = Chapter::OF_THE_BOOK.into_iter();
        for chapter in others.filter(|it| *it != Chapter::HalfBSphere) {
            if let Some(length) = chosen_otherwise_in(chapter, reading, &known, &places)
                && CHOSEN * length < alone.min(2.0 * least)
            {
                least = length;
                nearest = Scene::new(chapter, None);
            }
        }
    }
    nearest.unwrap_or_else(|| Scene::new(Chapter::Gradient, None).expect("it has no probe"))
}

/// Whether a picture is nearly one of a chapter, right or with a slip.
pub(crate) fn is_near_a_chapter(reading: &Reading) -> bool {
    let (.., is_near) = nearest(reading);
    is_near
}

/// About how long the nearest scene is, which one, and whether it is near.
fn nearest(reading: &Reading) -> (f64, Option<Scene>, bool) {
    let known = Known::default();
    let places = LOOKS.map(|count| Places::new(reading, None, count));
    let is_one = surfaces::is_one(reading);
    let mut least = f64::INFINITY;
    let mut nearest = None;
    let mut program = None;
    for chapter in Chapter::OF_THE_BOOK {
        let own = Scene::new(chapter, None);
        let own = own.expect("every chapter has a scene of its own");
        let evidence = Evidence::new(&own, reading, &known);
        let rights: Vec<Hypothesis> = right(&evidence)
            .into_iter()
            .filter(|it| it.scene.chapter == chapter && is_likely(it))
            .collect();
        let own = rights.iter().filter(|it| it.scene.probe.is_none());
        let colored = own.filter_map(|it| in_colors(&evidence, it, LOOKS[1]));
        let singles = single(&evidence);
        // What shows nothing but a sky may be that in colors of one's own, with a slip.
        let is_sky = chapter == Chapter::Gradient && is_one;
        let skies = singles.iter().filter(|_| is_sky);
        let skies = skies.filter_map(|it| in_colors(&evidence, it, LOOKS[0]));
        let skies: Vec<Hypothesis> = skies.collect();
        let all = rights.iter().cloned().chain(colored);
        let all = all.chain(singles).chain(skies);
        let few = likeliest(&evidence, all, &places[0], f64::INFINITY, FEW);
        let few = few.iter().map(|(_, it)| {
            let length = it.estimated(reading, &places[1], f64::INFINITY);
            let is_plain = it.slips.is_empty() && it.scene.probe.is_none();
            let times = if is_plain { 1.0 } else { CHANCE };
            (length.map(|it| times * it), it.scene.probe, Some(it))
        });
        let outlines = rights.iter().filter(|it| it.scene.probe.is_none());
        let outlines = outlines.map(|it| (outlined(it, reading, &places[1]), None, None));
        let ramps = rights.first().and_then(|it| ramps(&evidence, it));
        let ramps = ramps.map(|it| (Some(it.bits()), None, None));
        for (length, probe, by) in few.chain(outlines).chain(ramps) {
            if let Some(length) = length
                && length < least
            {
                least = length;
                nearest = Scene::new(chapter, probe);
                program = by.cloned();
            }
        }
    }
    let is_near = program.is_some_and(|it| is_near(&it, reading, &places[1]));
    (least, nearest, is_near)
}

/// Nobody who follows an earlier edition draws a probe.
fn is_likely(it: &Hypothesis) -> bool {
    it.scene.probe.is_none() || it.scene.edition == Edition::V4
}

/// Whether a program draws the picture but for what may happen to a file, levels and edges.
fn is_near(program: &Hypothesis, reading: &Reading, places: &Places) -> bool {
    let Some(output) = program.output(reading) else {
        return false;
    };
    let drawn = |n: u32| program.pixel(&output, n);
    let last = reading.pixels.len() as u32 - 1;
    let is_at_an_edge = |n: u32| {
        let steps = [BESIDE, BESIDE * reading.width];
        let beside = steps.map(|by| [n.saturating_sub(by), (n + by).min(last)]);
        let mut beside = beside.into_iter().flatten();
        beside.any(|beside| distance(drawn(n), drawn(beside)) > FAR)
    };
    let is_far = |n: u32| distance(drawn(n), reading.pixels[n as usize]) > FAR;
    let far = places
        .iter()
        .filter(|(n, _)| is_far(*n) && !is_at_an_edge(*n));
    SOME * far.count() <= places.iter().count()
}

/// About how long a chapter is with all that a reader may have chosen, or with two slips.
fn chosen_otherwise_in(
    chapter: Chapter,
    reading: &Reading,
    known: &Known,
    [few, many]: &[Places; 2],
) -> Option<f64> {
    let scene = Scene::new(chapter, None)?;
    let evidence = Evidence::new(&scene, reading, known);
    let of_chapter = |it: &Hypothesis| it.scene.chapter == chapter && it.scene.probe.is_none();
    let rights = right(&evidence).into_iter().filter(of_chapter);
    let colored = rights.map(|it| in_colors(&evidence, &it, LOOKS[1]).unwrap_or(it));
    let nearest = likeliest(&evidence, colored, many, f64::INFINITY, 1);
    let (_, nearest) = nearest.into_iter().next()?;
    let paths = chosen_otherwise(&evidence, &nearest.in_the_books_colors());
    let ends = paths.iter().filter_map(|path| path.last().cloned());
    // Only what explains nearly all is worth another look.
    let most = bits::alone(reading) / CHOSEN;
    let pairs = likeliest(&evidence, two(&evidence), few, most, FEW);
    let all = ends.chain(pairs.into_iter().map(|(_, it)| it));
    let lengths = all.filter_map(|it| it.estimated(reading, many, f64::INFINITY));
    lengths.reduce(f64::min)
}
