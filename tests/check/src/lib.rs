//! What judges a picture, ours or a reader's.
//!
//! In the order in which a file passes through it: [`reading`] makes a picture of
//! bytes that may be anything, [`explanations`] are measured in [`bits`] and the shortest
//! is the [`verdict`], which [`answer`] puts into words and [`report`] shows on a page. If the
//! picture is right, [`blind_spots`] says what it can't show. Of a picture that nobody has named
//! [`guess`] says which chapter it is, and [`frame`] looks into a screenshot.

pub mod answer;
pub mod bits;
pub mod blind_spots;
mod causes;
pub mod comparison;
pub mod evidence;
pub mod explanations;
pub mod frame;
pub mod guess;
pub mod html;
mod judge;
mod map;
pub mod mutants;
pub mod names;
pub mod png;
pub mod reading;
pub mod report;
pub mod scene;
mod seen;
pub mod sources;
mod surfaces;
pub mod telling;
pub mod told;
pub mod verdict;
pub mod whole;
mod words;
pub mod workspace;

pub use words::names_of;
