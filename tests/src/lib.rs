//! What a right answer is.
//!
//! The checks live in a library, so that the ones that judge our chapters also
//! judge a reader's own. The `*.rs` files beside this folder apply them.

pub mod accuracy;
pub mod case;
pub mod causes;
pub mod check;
pub mod comparison;
pub mod diagnosis;
pub mod diff_page;
pub mod hits;
pub mod intervals;
pub mod laws;
pub mod machine;
pub mod mappings;
pub mod oracle;
pub mod png;
pub mod reading;
pub mod rival;
pub mod scenes;
pub mod simplify;
pub mod slips;
pub mod speed;
pub mod stages;
pub mod strain;
pub mod strategies;
pub mod timings;
pub mod trial;
pub mod worlds;
