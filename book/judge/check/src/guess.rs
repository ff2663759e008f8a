//! Classification of a picture by the nearest program, where the reader names no chapter.

use slips::{Chapter, PROBES};

use crate::candidate::{Candidate, Conversion};
use crate::context::Context;
use crate::pixels::spread;
use crate::reading::Reading;
use crate::task::Task;
use crate::work::Work;

/// How many pixels of the picture are compared.
const LOOK: u32 = 400;
/// The largest difference of a component, in levels, at which two pixels count as alike: many files
/// mix edges and levels a little.
const NEAR: u16 = 2;

/// Guesses the task of a picture: the one whose right program, or program with one slip (known
/// mistake), draws most of its pixels alike. Of tasks that draw the same, as chapters 3 and 4 do,
/// the first in the book; chapter 1 if no program draws a picture of this size, or the work that may
/// be spent is spent.
pub fn guess_task(reading: &Reading) -> Task {
    let mut nearest = (usize::MAX, Task::of(Chapter::Gradient));
    let places: Vec<u32> = spread(LOOK, reading.pixels.len() as u32).collect();
    let work = Work::new();
    for candidates in [right_ones, wrong_ones] {
        for chapter in Chapter::OF_THE_BOOK {
            for (task, it) in candidates(chapter, reading) {
                let off = off(&it, reading, &places, &work, nearest.0);
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
fn right_ones(chapter: Chapter, reading: &Reading) -> Vec<(Task, Candidate)> {
    let own = Task::of(chapter);
    let versions = Context::default().versions(&own, reading.width, reading.height);
    let probes = PROBES.iter().filter(|probe| probe.spheres.is_some());
    let probes = probes.filter_map(|&probe| Task::new(chapter, Some(probe)));
    let probes = probes.map(|task| (task, task.fitting(reading.width, reading.height)));
    let all = versions.into_iter().map(|task| (own, task)).chain(probes);
    all.map(|(guessed, task)| (guessed, Candidate::right(task, Conversion::Clamped)))
        .collect()
}

/// Returns the programs of the chapter with one slip, each with the chapter's task.
fn wrong_ones(chapter: Chapter, reading: &Reading) -> Vec<(Task, Candidate)> {
    let own = Task::of(chapter);
    let right = own.fitting(reading.width, reading.height);
    let right = Candidate::right(right, Conversion::Clamped);
    own.slips()
        .map(|slip| (own, right.with(vec![slip])))
        .collect()
}

/// Counts the pixels of a sample that are not alike in the program's picture, up to `most`; `most`
/// if the sizes differ or no work is left.
fn off(it: &Candidate, reading: &Reading, places: &[u32], work: &Work, most: usize) -> usize {
    let drawn = it.drawn(reading, work);
    drawn.map_or(most, |it| it.count(places, NEAR, most))
}
