//! The search for single edits: forwards from the chapter, for those that draw the reader's picture;
//! and of a text that is typed in a page, for the one that makes it right.
//!
//! Both try the likeliest edits first. An edit is found only if its program was run.

mod edit;
mod everywhere;
mod forwards;
mod functions;
mod mutation;
mod parsed;
mod roots;
mod tree;
mod typed;

use crate::reading::Reading;
use crate::sources::Sources;
use crate::task::Task;
pub use everywhere::{FileEdit, edits_everywhere};
use forwards::PictureSearch;
pub(crate) use forwards::{DrawingMutants, Mutant};
use functions::functions;
pub use typed::{Repair, TypedText};

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
        sources,
        places: forwards::places(&right, reading),
        right: &right,
    };
    search.mutants()
}
