//! The laws: properties of a ray-sphere intersection, to be tested on any function that
//! computes one.
//!
//! A law is a plain function over a reader's function and a question. [`runner`] and
//! [`trial`] put a function under all of them, with questions that [`strategies`] make
//! and answers that [`oracle`] knows exactly. What breaks a law is explained by
//! [`causes`], made simpler and put into words by [`report`]; [`answers`] are kept for
//! a judge to weigh. A reader's own crate depends on this one, so it brings few other
//! crates.

pub mod answers;
pub mod camera;
pub mod causes;
mod functions;
pub mod intervals;
pub mod list;
pub mod nearer_root;
pub mod neighbors;
mod numbers;
pub mod oracle;
pub mod prelude;
pub mod question;
pub mod ray_color;
pub mod record;
pub mod report;
pub mod runner;
pub mod sampling;
pub mod shadow;
pub mod strategies;
pub mod trial;
pub mod truth;
pub mod verdict;

pub use common::rtweekend::{Color, Point3, Ray};
pub use intervals::WithInterval;
pub use slips::Chapter;
pub use speed_vs_accuracy::Case;
pub use trial::Trial;
