//! The judge of a picture, ours or a reader's.
//!
//! A file passes through these modules in turn: [`reading`] reads a picture from bytes that may
//! be anything. [`judge()`] makes a case of it and asks the [`rules`] which one holds; these ask for
//! the [`explanation`]s of the picture, programs that draw it, within a budget of work. An
//! [`attempt`] puts the [`verdict`] into an [`answer`], in the words of [`sentences`], and
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
mod case;
mod causes;
pub mod context;
pub mod explanation;
mod generated;
pub mod guess;
pub mod html;
mod judge;
pub mod lawful;
mod pixels;
mod programs;
pub mod reading;
mod repair;
pub mod rules;
pub mod seen;
pub mod sentences;
pub mod sources;
pub mod task;
mod telling;
pub mod text;
pub mod verdict;
mod work;
pub mod workspace;

pub use candidate::{Candidate, Conversion, Unexplained};
pub use course::names;
pub use generated::Generated;
pub use judge::{judge, judge_file, judge_guessed, rules_that_hold};
pub use repair::{Repair, TypedText};
pub use sentences::mistake_name;
