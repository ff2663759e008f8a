//! Classification by the nearest program: which chapter a picture is meant to be, where
//! nobody says so.

use slips::Chapter;

use crate::bits;
use crate::evidence::{Evidence, Known};
use crate::explanations::{
    Hypothesis, Places, chosen_otherwise, in_colors, outlined, right, single,
};
use crate::judge::likeliest;
use crate::reading::Reading;
use crate::scene::Scene;

/// How many pixels are looked at to find those that may be the nearest, and these.
const LOOKS: [u32; 2] = [100, 1500];
/// How many these are.
const FEW: usize = 20;
/// Of a picture's bits a scene that is near leaves one in so many.
const MOST: f64 = 8.0;

/// The scene whose picture comes nearest: right, with one slip, in colors of the reader's own,
/// or but for the colors of all that is hit. The first in the book of several that draw the
/// same, as chapters 3 and 4 do.
pub fn scene(reading: &Reading) -> Scene {
    let known = Known::default();
    let places = LOOKS.map(|count| Places::new(reading, None, count));
    let mut least = f64::INFINITY;
    let mut nearest = None;
    for chapter in Chapter::OF_THE_BOOK {
        let own = Scene::new(chapter, None);
        let own = own.expect("every chapter has a scene of its own");
        let evidence = Evidence::new(&own, reading, &known);
        let rights: Vec<Hypothesis> = right(&evidence)
            .into_iter()
            .filter(|it| it.scene.chapter == chapter)
            .collect();
        let own = rights.iter().filter(|it| it.scene.probe.is_none());
        let colored = own.filter_map(|it| in_colors(&evidence, it));
        let all = rights.iter().cloned().chain(colored);
        let all = all.chain(single(&evidence));
        let few = likeliest(&evidence, all, &places[0], f64::INFINITY, FEW);
        let few = few.iter().map(|(_, it)| {
            let length = it.estimated(reading, &places[1], f64::INFINITY);
            (length, it.scene.probe)
        });
        let outlines = rights.iter().filter(|it| it.scene.probe.is_none());
        let outlines = outlines.map(|it| (outlined(it, reading, &places[1]), it.scene.probe));
        for (length, probe) in few.chain(outlines) {
            if let Some(length) = length
                && length < least
            {
                least = length;
                nearest = Scene::new(chapter, probe);
            }
        }
    }
    // A sky that the reader chose otherwise is the same in all chapters.
    if MOST * least > bits::alone(reading) {
        for (length, chapter) in under_own_sky(reading, &known, &places[1]) {
            if length < least {
                least = length;
                nearest = Scene::new(chapter, None);
            }
        }
    }
    nearest.unwrap_or_else(|| Scene::new(Chapter::Gradient, None).expect("it has no probe"))
}

/// Each chapter with its length, under skies that are fitted to the picture.
fn under_own_sky(reading: &Reading, known: &Known, places: &Places) -> Vec<(f64, Chapter)> {
    let scene = |chapter| Scene::new(chapter, None).expect("every chapter has a scene of its own");
    let gradient = scene(Chapter::Gradient);
    let evidence = Evidence::new(&gradient, reading, known);
    let rights = right(&evidence);
    let paths = rights
        .iter()
        .take(1)
        .flat_map(|it| chosen_otherwise(&evidence, it));
    let skies: Vec<Hypothesis> = paths.filter_map(|mut path| path.pop()).collect();
    let under = |(sky, chapter): (&Hypothesis, Chapter)| {
        let scene = scene(chapter).fitting(reading.width, reading.height);
        let under = Hypothesis {
            scene: scene.with(sky.scene.chosen),
            ..sky.clone()
        };
        Some((under.estimated(reading, places, f64::INFINITY)?, chapter))
    };
    let chapters = [Chapter::RedSphere, Chapter::Normals, Chapter::HittableList];
    let all = skies
        .iter()
        .flat_map(|sky| chapters.map(|chapter| (sky, chapter)));
    all.filter_map(under).collect()
}
