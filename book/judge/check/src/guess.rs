//! Classification by the nearest program: which chapter a picture is meant to be, where
//! no chapter is named.

use slips::{Chapter, Edition, PROBES};

use crate::candidate::Candidate;
use crate::candidates::{rights, singles};
use crate::known::{Evidence, Known};
use crate::pixels::{distance, spread};
use crate::reading::Reading;
use crate::scene::Scene;

/// How many pixels are looked at.
const LOOK: u32 = 400;
/// A pixel that is off by no more levels may be the same: edges and levels are mixed in many
/// a file.
const NEAR: u16 = 2;

/// The scene whose picture comes nearest: right, or with one slip. The first in the book of several that draw the same, as chapters 3 and 4 do.
pub fn scene(reading: &Reading) -> Scene {
    let mut nearest = (usize::MAX, own(Chapter::Gradient));
    for candidates in [right_ones, wrong_ones] {
        for scene in Chapter::OF_THE_BOOK.map(own) {
            let known = Known::default();
            let evidence = Evidence::new(&scene, reading, &known);
            for (scene, it) in candidates(&evidence) {
                let off = off(&it, reading, nearest.0);
                if off < nearest.0 {
                    nearest = (off, scene);
                }
            }
        }
    }
    nearest.1
}

fn own(chapter: Chapter) -> Scene {
    Scene::new(chapter, None).expect("every chapter has a scene of its own")
}

/// The chapter and its probes, by each edition. A reader who
/// follows an earlier edition draws no probe.
fn right_ones(evidence: &Evidence) -> Vec<(Scene, Candidate)> {
    let (scene, reading) = (evidence.scene, evidence.reading);
    let probes = PROBES.iter().filter(|probe| probe.spheres.is_some());
    let probes = probes.filter_map(|&probe| Scene::new(scene.chapter, Some(probe)));
    let probes = probes.map(|scene| {
        scene
            .only_by(Edition::V4)
            .fitting(reading.width, reading.height)
    });
    let own = rights(evidence);
    let plain = own[0].clone();
    let probed = probes.map(|probed| {
        let it = Candidate {
            scene: probed,
            ..plain.clone()
        };
        (Scene::new(scene.chapter, probed.probe).unwrap_or(scene), it)
    });
    let all = own.into_iter().map(|it| (scene, it));
    all.chain(probed).collect()
}

fn wrong_ones(evidence: &Evidence) -> Vec<(Scene, Candidate)> {
    let all = singles(evidence).flatten();
    all.map(|it| (evidence.scene, it)).collect()
}

/// How many of some pixels are not the program's, or `most`.
fn off(it: &Candidate, reading: &Reading, most: usize) -> usize {
    let Some(output) = it.output(reading) else {
        return most;
    };
    let places = spread(LOOK, reading.pixels.len() as u32);
    let far = |n: &u32| distance(it.pixel(&output, *n), reading.pixels[*n as usize]) > NEAR;
    places.filter(far).take(most).count()
}
