//! The judge of a picture, ours or a reader's.
//!
//! A file passes through these modules in turn: [`reading`] reads a picture from bytes that may
//! be anything. [`judge()`] asks which program draws the picture; `search` makes those with a single
//! edit. An [`attempt`] puts the [`verdict`] into an [`answer`], in the words of [`sentences`], and
//! [`text`] or [`html`] lays it out.
//!
//! Beside them, [`blind_spots`] finds the mistakes that a right picture hides, [`guess`] the
//! chapter of a picture without a name, and [`any_language`] puts a function in any language under
//! the laws.

pub mod answer;
pub mod any_language;
pub mod attempt;
pub mod blind_spots;
mod candidate;
mod candidates;
mod causes;
pub mod context;
pub mod guess;
pub mod html;
mod judge;
pub mod lawful;
mod pixels;
pub mod reading;
mod search;
pub mod seen;
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
pub use search::{FileEdit, Repair, TypedText, edits_everywhere};
pub use sentences::mistake_name;
