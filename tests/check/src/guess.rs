//! Classification by the nearest program: which chapter a picture is meant to be, where
//! nobody says so.

use slips::{Chapter, Edition, Room};

use crate::bits::{self, distance};
use crate::evidence::{Evidence, Known};
use crate::explanations::{
    Hypothesis, Places, chosen_otherwise, in_colors, outlined, ramps, right, single, two,
};
use crate::judge::{is_same, likeliest};
use crate::reading::Reading;
use crate::scene::Scene;
use crate::surfaces;

/// How many pixels are looked at to find those that may be the nearest, and these.
const LOOKS: [u32; 2] = [100, 1500];
/// How many these are.
const FEW: usize = 20;
/// Of a picture's bits a scene that is near leaves one in so many.
const CHOSEN: f64 = 4.0;
/// What leaves one in so many is the scene.
const ALL: f64 = 64.0;
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
    let (least, nearest, is_near) = nearest(reading);
    // What a reader chose explains nearly all, or it was something else; and it is not near a
    // picture in which nothing is the reader's.
    let alone = bits::alone(reading);
    let is_unknown = CHOSEN * least > alone && !is_near;
    let most = alone.min(2.0 * least) / CHOSEN;
    let chosen = is_unknown.then(|| explained(reading, most, alone));
    let first = || Scene::new(Chapter::Gradient, None).expect("it has no probe");
    chosen.flatten().or(nearest).unwrap_or_else(first)
}

/// The chapter that explains nearly all with what a reader may have chosen, or with two slips.
fn explained(reading: &Reading, mut most: f64, alone: f64) -> Option<Scene> {
    let known = Known::default();
    let places = LOOKS.map(|count| Places::new(reading, None, count));
    // Chapter 4 draws what chapter 3 does, and no sphere is seen where all is one surface.
    let surfaces = surfaces::count(reading);
    let may_be = |it: &Chapter| match it {
        Chapter::HalfBSphere => false,
        it => (it.room() == Room::None) == (surfaces == 1),
    };
    let mut chapters: Vec<Chapter> = Chapter::OF_THE_BOOK.into_iter().filter(may_be).collect();
    // Where two lie before the sky, the list is the likeliest.
    if surfaces > 2 {
        chapters.reverse();
    }
    for length_of in [with_choices, with_pairs] {
        let mut found = None;
        for &chapter in &chapters {
            let scene = Scene::new(chapter, None)?;
            let evidence = Evidence::new(&scene, reading, &known);
            if let Some(length) = length_of(&evidence, &places, alone)
                && length < most
            {
                found = Some(scene);
                most = 2.0 * length / CHOSEN;
                if ALL * length < alone {
                    return found;
                }
            }
        }
        if found.is_some() {
            return found;
        }
    }
    None
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

/// About how long a chapter is with all that a reader may have chosen.
fn with_choices(evidence: &Evidence, [_, many]: &[Places; 2], _: f64) -> Option<f64> {
    let own = |it: &Hypothesis| is_same(&it.scene, &evidence.scene);
    let rights = right(evidence).into_iter().filter(own);
    let colored = rights.map(|it| in_colors(evidence, &it, LOOKS[1]).unwrap_or(it));
    let nearest = likeliest(evidence, colored, many, f64::INFINITY, 1);
    let (_, nearest) = nearest.into_iter().next()?;
    let paths = chosen_otherwise(evidence, &nearest.in_the_books_colors());
    let ends = paths.iter().filter_map(|path| path.last());
    let lengths = ends.filter_map(|it| it.estimated(evidence.reading, many, f64::INFINITY));
    lengths.reduce(f64::min)
}

/// The same with two slips. Only what explains nearly all is worth another look.
fn with_pairs(evidence: &Evidence, [few, many]: &[Places; 2], alone: f64) -> Option<f64> {
    let pairs = two(evidence).filter(|it| !it.scene.has_another_shape());
    let pairs = likeliest(evidence, pairs, few, alone / CHOSEN, FEW);
    let lengths = pairs
        .iter()
        .filter_map(|(_, it)| it.estimated(evidence.reading, many, f64::INFINITY));
    lengths.reduce(f64::min)
}
