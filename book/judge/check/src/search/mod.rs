//! One search for edits, both ways: forwards from the chapter, for those that draw the reader's
//! picture; backwards from the reader's text, for those that make it right.
//!
//! Both try the likeliest edits first: those that bring one text nearer to the other, and those
//! that people make when they type. An edit is found only if its program was run and drew the
//! picture.

mod backwards;
mod edit;
mod everywhere;
mod forwards;
mod functions;
mod goal;
mod mutation;
mod nearer;
mod parsed;
mod renaming;
mod repair;
mod roots;
mod tree;

use std::cmp::Reverse;

use slips::Edition;

use crate::reading::Reading;
use crate::sources::{LineComparison, Sources};
use crate::task::Task;
pub use everywhere::{FileEdit, edits_everywhere};
use forwards::PictureSearch;
pub(crate) use forwards::{DrawingMutants, Mutant};
use functions::functions;
pub(crate) use repair::{Correction, LineChange, Repair};

/// The most pixels of a picture for which edits are searched, since each edit has to draw it.
const LARGEST: usize = 500_000;

/// Finds the single edits of a task's chapter that draw a picture and that the reader's files do
/// not rule out. None are looked for with a probe, or for a picture of more than 500,000 pixels.
pub(crate) fn drawn(task: &Task, reading: &Reading, sources: &Sources) -> DrawingMutants {
    if task.probe.is_some() || reading.pixels.len() > LARGEST {
        return DrawingMutants::default();
    }
    searched(task, reading, sources, |it| Some(it.mutants())).unwrap_or_default()
}

/// Runs a search on the program of the edition whose statements the reader's files have most of;
/// without files on the task's own program.
fn searched<T>(
    task: &Task,
    reading: &Reading,
    sources: &Sources,
    search: impl Fn(&PictureSearch) -> Option<T>,
) -> Option<T> {
    let programs = match sources.typed().is_empty() {
        true => vec![task.program(&[])],
        false => [Edition::V4, Edition::V3]
            .map(|it| it.program(task.chapter))
            .to_vec(),
    };
    let functions: Vec<_> = programs.iter().map(|it| functions(it.code())).collect();
    let lines = programs
        .iter()
        .map(|it| LineComparison::new(it.functions(), sources.typed()));
    let all = programs.iter().zip(&functions).zip(lines);
    let ((right, functions), lines) = all.min_by_key(|(_, lines)| Reverse(lines.count()))?;
    search(&PictureSearch {
        right,
        reading,
        functions,
        lines: &lines,
        places: forwards::places(right, reading),
    })
}
