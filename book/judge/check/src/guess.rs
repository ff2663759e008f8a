//! Classification of a picture by the nearest program, where the reader names no chapter.

use slips::{Chapter, PROBES};

use crate::candidate::Candidate;
use crate::candidates::{programs_with_one_slip, right_programs};
use crate::context::{Context, Evidence};
use crate::pixels::{distance, spread};
use crate::reading::Reading;
use crate::task::Task;

/// How many pixels of the picture are compared.
const LOOK: u32 = 400;
/// The largest difference of a component, in levels, at which two pixels count as alike: many files
/// mix edges and levels a little.
const NEAR: u16 = 2;

/// Guesses the task of a picture: the one whose right program, or program with one slip (known
/// mistake), draws most of its pixels alike. Of tasks that draw the same, as chapters 3 and 4 do,
/// the first in the book; chapter 1 if no program draws a picture of this size.
pub fn guess_task(reading: &Reading) -> Task {
    let mut nearest = (usize::MAX, Task::of(Chapter::Gradient));
    for candidates in [right_ones, wrong_ones] {
        for task in Chapter::OF_THE_BOOK.map(Task::of) {
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

/// Returns the right programs of the chapter by each version, and of its probes by version 4, each
/// with the task that is guessed if it is the nearest.
fn right_ones(evidence: &Evidence) -> Vec<(Task, Candidate)> {
    let (task, reading) = (evidence.task, evidence.reading);
    let probes = PROBES.iter().filter(|probe| probe.spheres.is_some());
    let probes = probes.filter_map(|&probe| Task::new(task.chapter, Some(probe)));
    let probes = probes.map(|task| task.fitting(reading.width, reading.height));
    let own = right_programs(evidence);
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

/// Returns the programs of the chapter with one slip, each with the chapter's task.
fn wrong_ones(evidence: &Evidence) -> Vec<(Task, Candidate)> {
    let all = programs_with_one_slip(evidence).flatten();
    all.map(|it| (evidence.task, it)).collect()
}

/// Counts the pixels of a sample that are not alike in the program's picture, up to `most`; `most`
/// if the sizes differ.
fn off(it: &Candidate, reading: &Reading, most: usize) -> usize {
    let Some(output) = it.output(reading) else {
        return most;
    };
    let places = spread(LOOK, reading.pixels.len() as u32);
    let far = |n: &u32| distance(it.pixel(&output, *n), reading.pixels[*n as usize]) > NEAR;
    places.filter(far).take(most).count()
}
