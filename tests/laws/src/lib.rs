//! The laws: what holds for a ray and a sphere, whoever computes it.
//!
//! A law is a plain function over a reader's function and a case. [`runner`] puts a
//! function under all of them, with cases that [`strategies`] makes and answers that
//! [`oracle`] knows exactly; what breaks a law is made simple by [`shrinker`] and
//! explained by [`causes`]. A reader's own crate depends on this one, so it is small.

pub mod causes;
pub mod intervals;
pub mod list;
pub mod nearer_root;
pub mod oracle;
pub mod ray_and_camera;
pub mod record;
pub mod runner;
pub mod shrinker;
pub mod strategies;
pub mod truth;
pub mod verdict;

pub use intervals::WithInterval;
pub use speed_vs_accuracy::Case;
