//! One search for edits, both ways: forwards from the chapter, for those that draw the reader's
//! picture; backwards from the reader's text, for those that make it right.
//!
//! Both try the likeliest first: edits that bring one text nearer to the other, and those that
//! people make when they type. Nothing is said here that did not draw the picture.

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

/// Of a larger picture not every pixel is drawn for each edit.
const LARGEST: usize = 500_000;

/// Finds the single edits of the chapter that draw the picture, as far as the reader's files can
/// have them.
pub(crate) fn drawn(task: &Task, reading: &Reading, sources: &Sources) -> DrawingMutants {
    if task.probe.is_some() || reading.pixels.len() > LARGEST {
        return DrawingMutants::default();
    }
    searched(task, reading, sources, |it| Some(it.mutants())).unwrap_or_default()
}

/// Searches forwards, from the edition to which the lines keep, or else from that of the scene.
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
    search(&PictureSearch::new(right, functions, reading, &lines))
}
