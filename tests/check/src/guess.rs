//! Classification by the nearest program: which chapter a picture is meant to be, where
//! nobody says so.

use slips::{Chapter, Edition};

use crate::bits;
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

/// The scene whose picture comes nearest: right, with one slip, in colors of the reader's own,
/// or but for the colors of all that is hit. The first in the book of several that draw the
/// same, as chapters 3 and 4 do.
pub fn scene(reading: &Reading) -> Scene {
    let known = Known::default();
    let places = LOOKS.map(|count| Places::new(reading, None, count));
    let is_one = surfaces::is_one(reading);
    let mut least = f64::INFINITY;
    let mut nearest = None;
    for chapter in Chapter::OF_THE_BOOK {
        let own = Scene::new(chapter, None);
        let own = own.expect("every chapter has a scene of its own");
        let evidence = Evidence::new(&own, reading, &known);
        let rights: Vec<Hypothesis> = right(&evidence)
            .into_iter()
            .filter(|it| it.scene.chapter == chapter && is_likely(it))
            .collect();
        let own = rights.iter().filter(|it| it.scene.probe.is_none());
        let colored = own.filter_map(|it| in_colors(&evidence, it));
        let singles = single(&evidence);
        // What shows nothing but a sky may be that in colors of one's own, with a slip.
        let is_sky = chapter == Chapter::Gradient && is_one;
        let skies = singles.iter().filter(|_| is_sky);
        let skies = skies.filter_map(|it| in_colors(&evidence, it));
        let skies: Vec<Hypothesis> = skies.collect();
        let all = rights.iter().cloned().chain(colored);
        let all = all.chain(singles).chain(skies);
        let few = likeliest(&evidence, all, &places[0], f64::INFINITY, FEW);
        let few = few.iter().map(|(_, it)| {
            let length = it.estimated(reading, &places[1], f64::INFINITY);
            (length, it.scene.probe)
        });
        let outlines = rights.iter().filter(|it| it.scene.probe.is_none());
        let outlines = outlines.map(|it| (outlined(it, reading, &places[1]), it.scene.probe));
        let ramps = rights.first().and_then(|it| ramps(&evidence, it));
        let ramps = ramps.map(|it| (Some(it.bits()), None));
        for (length, probe) in few.chain(outlines).chain(ramps) {
            if let Some(length) = length
                && length < least
            {
                least = length;
                nearest = Scene::new(chapter, probe);
            }
        }
    }
    // What a reader chose explains nearly all, or it was something else.
    let alone = bits::alone(reading);
    if CHOSEN * least > alone {
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

/// Nobody who follows an earlier edition draws a probe.
fn is_likely(it: &Hypothesis) -> bool {
    it.scene.probe.is_none() || it.scene.edition == Edition::V4
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
    let colored = rights.map(|it| in_colors(&evidence, &it).unwrap_or(it));
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
