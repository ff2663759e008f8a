//! # Chapter 6: speed against accuracy
//!
//! Every serious way to intersect a ray with a sphere, in one place and over
//! one signature.

mod method;
mod plain;
mod single;

pub use method::{METHODS, Method, Solve, find};
pub use plain::{full_b, half_b, half_b_q};
pub use single::{SingleRay, half_b_f32};
