//! Right, by an edition: the scene itself, another of the same chapter, or of another.

use ::slips::{Chapter, Edition, PROBES};

use super::slips::ONE;
use super::{Conversion, Evidence, Hypothesis};
use crate::scene::Scene;

/// Most pictures are right, by the edition that the reader was led to by these pages.
const ITSELF: f64 = 1.0;
/// A step on the way, in a crate that leads from step to step; one that has been done
/// before. One of a program that may be written in any order is as likely as a slip.
const STEP: f64 = 2.0;
const STEP_AGAIN: f64 = 6.0;
const STEP_ELSEWHERE: f64 = ONE;
/// The chapter's own scene where a probe was asked for: the change was forgotten.
const FORGOTTEN: f64 = 4.0;
/// The scene of a probe: the change is still there. More than a slip, which is told with
/// the probes that draw the same.
const STILL_THERE: f64 = 9.0;
/// The picture of another chapter: the wrong file.
const ANOTHER_CHAPTER: f64 = 10.0;

/// The viewport as the book prints it, in another shape.
const AS_PRINTED: f64 = 2.0;

/// What an edition costs beside version 4.
pub(super) fn edition(edition: Edition) -> f64 {
    match edition {
        Edition::V4 => 0.0,
        Edition::V3 => 3.0,
        Edition::V3_0 | Edition::V1 | Edition::V1InDouble => 4.0,
        // It lasted for two weeks.
        Edition::V3_1_0 => 7.0,
    }
}

/// A shape that the reader chose: with the bit that says it is right a little less than the slip
/// that gives one.
pub(super) fn shape(scene: &Scene) -> f64 {
    match scene.has_another_shape() {
        true => 6.0,
        false => 0.0,
    }
}

/// Right pictures.
pub(crate) fn right(evidence: &Evidence) -> Vec<Hypothesis> {
    let own = evidence.scene;
    let probes = PROBES.iter().filter(|probe| probe.spheres.is_some());
    let scenes = [(None, FORGOTTEN)]
        .into_iter()
        .chain(probes.map(|&probe| (Some(probe), STILL_THERE + evidence.unfound())))
        .filter(|(probe, _)| *probe != own.probe)
        .filter_map(|(probe, name)| Some((Scene::new(own.chapter, probe)?, name)));
    let chapters = Chapter::OF_THE_BOOK
        .into_iter()
        .filter(|&chapter| chapter != own.chapter)
        .map(|chapter| {
            let name = match own.is_guessed() {
                true => ITSELF,
                false => ANOTHER_CHAPTER + evidence.unfound(),
            };
            (own.of_chapter(chapter), name)
        });
    // A reader who types the chapter has no other picture at hand.
    let is_typing = evidence.known.sources.are_of_the_chapter();
    // One color everywhere is the picture of many things.
    let sources = &evidence.known.sources;
    let is_another = !is_typing && (sources.is_empty() || !evidence.reading.is_plain());
    let others = scenes.chain(chapters).filter(|_| is_another);
    let others = others.flat_map(|(scene, name)| {
        let by_editions = by_editions(evidence, scene, name);
        by_editions
            .into_iter()
            .filter(|it| !it.scene.has_another_shape())
    });
    by_editions(evidence, own, ITSELF)
        .into_iter()
        .chain(steps(evidence))
        .chain(others)
        .map(|it| evidence.weighed(it))
        .collect()
}

/// The steps before the last, as the edition has them that was asked for.
pub(super) fn steps(evidence: &Evidence) -> Vec<Hypothesis> {
    let own = evidence.scene;
    let (_, before) = evidence.known.steps.split_last().unwrap_or((&true, &[]));
    let step = |(n, &is_done): (usize, &bool)| {
        let is_led = evidence.known.sources.are_of_the_chapter();
        let name = match is_done {
            _ if !is_led => STEP_ELSEWHERE + evidence.unfound(),
            true => STEP_AGAIN,
            false => STEP,
        };
        by_editions(evidence, own.at_step(n), name)
            .into_iter()
            .next()
    };
    before.iter().enumerate().filter_map(step).collect()
}

/// The scene by each edition that will do.
pub(super) fn by_editions(evidence: &Evidence, scene: Scene, name: f64) -> Vec<Hypothesis> {
    let (width, height) = evidence.size();
    let (degradation, degraded) = evidence.degradation.unzip();
    let conversion = match evidence.has_no_levels {
        true => Conversion::Printed,
        false => Conversion::Clamped,
    };
    let by = |(scene, other): (Scene, f64)| Hypothesis {
        scene,
        slips: Vec::new(),
        conversion,
        degradation,
        name: degraded.unwrap_or_default() + name + edition(scene.edition) + shape(&scene) + other,
    };
    let as_printed = |scene: Scene| {
        [
            Some((scene, 0.0)),
            scene.with_printed_viewport().map(|it| (it, AS_PRINTED)),
        ]
    };
    let scenes = scene.by_editions(width, height).flat_map(as_printed);
    scenes.flatten().map(by).collect()
}
