//! Classification by the nearest program: which chapter a picture is meant to be, where
//! no chapter is named.

use slips::{Chapter, Edition, PROBES};

use crate::candidate::Candidate;
use crate::candidates::{rights, singles};
use crate::context::{Context, Evidence};
use crate::pixels::{distance, spread};
use crate::reading::Reading;
use crate::task::Task;

/// How many pixels are looked at.
const LOOK: u32 = 400;
/// A pixel that is off by no more levels may be the same: edges and levels are mixed in many
/// a file.
const NEAR: u16 = 2;

/// The scene whose picture comes nearest: right, or with one slip. The first in the book of several that draw the same, as chapters 3 and 4 do.
pub fn task(reading: &Reading) -> Task {
    let mut nearest = (usize::MAX, own(Chapter::Gradient));
    for candidates in [right_ones, wrong_ones] {
        for task in Chapter::OF_THE_BOOK.map(own) {
            let context = Context::default();
            let evidence = Evidence::new(&task, reading, &context);
            for (task, it) in candidates(&evidence) {
                let off = off(&it, reading, nearest.0);
                if off < nearest.0 {
                    nearest = (off, task);
                }
            }
        }
    }
    nearest.1
}

fn own(chapter: Chapter) -> Task {
    Task::new(chapter, None).expect("every chapter can be drawn without a probe")
}

/// The chapter and its probes, by each edition. A reader who
/// follows an earlier edition draws no probe.
fn right_ones(evidence: &Evidence) -> Vec<(Task, Candidate)> {
    let (task, reading) = (evidence.task, evidence.reading);
    let probes = PROBES.iter().filter(|probe| probe.spheres.is_some());
    let probes = probes.filter_map(|&probe| Task::new(task.chapter, Some(probe)));
    let probes = probes.map(|task| {
        task.only_by(Edition::V4)
            .fitting(reading.width, reading.height)
    });
    let own = rights(evidence);
    let plain = own[0].clone();
    let probed = probes.map(|probed| {
        let it = Candidate {
            task: probed,
            ..plain.clone()
        };
        (Task::new(task.chapter, probed.probe).unwrap_or(task), it)
    });
    let all = own.into_iter().map(|it| (task, it));
    all.chain(probed).collect()
}

fn wrong_ones(evidence: &Evidence) -> Vec<(Task, Candidate)> {
    let all = singles(evidence).flatten();
    all.map(|it| (evidence.task, it)).collect()
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
