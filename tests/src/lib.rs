//! What a right answer is.
//!
//! The checks live in a library, so that the ones that judge our chapters also
//! judge a reader's own. The `*.rs` files beside this folder apply them.

pub mod comparison;
pub mod diff_page;
pub mod png;
pub mod stages;
