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

use crate::reading::Reading;
use crate::sources::Sources;
use crate::task::Task;
pub use everywhere::{FileEdit, edits_everywhere};
use forwards::PictureSearch;
pub(crate) use forwards::{DrawingMutants, Mutant};
use functions::functions;
pub(crate) use repair::{Correction, LineChange, Repair};
pub(crate) use tree::squeezed;

/// The most pixels of a picture for which edits are searched, since each edit has to draw it.
const LARGEST: usize = 500_000;

/// Finds the single edits of a task's chapter that draw a picture and that the reader's files do
/// not rule out. None are looked for with a probe, or for a picture of more than 500,000 pixels.
pub(crate) fn drawn(task: &Task, reading: &Reading, sources: &Sources) -> DrawingMutants {
    if task.probe.is_some() || reading.pixels.len() > LARGEST {
        return DrawingMutants::default();
    }
    let right = task.program(&[]);
    let search = PictureSearch {
        reading,
        functions: &functions(right.code()),
        lines: &sources.beside(&right),
        places: forwards::places(&right, reading),
        right: &right,
    };
    search.mutants()
}
