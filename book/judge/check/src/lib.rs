//! What judges a picture, ours or a reader's.
//!
//! In the order in which a file passes through it: [`reading`] makes a picture of bytes that
//! may be anything, the judge asks which program draws it, `search` tries what makes the
//! reader's own program right, and the [`verdict`] becomes an [`answer`] in the words of [`sentences`],
//! which [`text`] and [`html`] lay out. If the picture is right, [`blind_spots`] knows what it
//! hides. Of a picture without a chapter's name [`guess`] says which chapter it is. [`any_language`] puts a function under the laws that is
//! asked by lines of text.

pub mod answer;
pub mod any_language;
pub mod attempt;
pub mod blind_spots;
mod candidate;
mod candidates;
mod causes;
pub mod comparison;
pub mod context;
pub mod guess;
pub mod html;
mod judge;
mod pixels;
pub mod png;
pub mod reading;
pub mod report;
mod search;
mod seen;
pub mod sentences;
pub mod sources;
pub mod task;
mod telling;
pub mod text;
pub mod verdict;
pub mod workspace;

pub use candidate::{Conversion, Unexplained};
pub use course::names;
pub use judge::{judge, judge_file, judge_guessed};
pub use search::{FileEdit, edits_everywhere};
pub use sentences::mistake_name;
