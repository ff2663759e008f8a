//! The right texts of the chapters, of which mistakes and probes are edits. One source serves twice:
//! the interpreter reads these files, and the compiler makes the right picture of them.
//!
//! Each does what the chapter's own package does, but is a copy: a reader may change chapters and
//! `common`, and is judged by these. That is why this package depends on no other. The prelude
//! is the interpreter's text of it, and `file` is the loop around a picture.

// The texts import `common::rtweekend`, as chapters do.
extern crate self as common;

pub mod build_test;
#[allow(unused_variables, reason = "mistakes use them")]
pub mod file;
pub mod gradient;
pub mod half_b_sphere;
pub mod hittable_list;
pub mod normals;
pub mod red_sphere;
pub mod rtweekend;

/// The module of chapter 5 that is in the root of its own package.
mod hittable {
    pub(crate) use crate::hittable_list::{HitRecord, Hittable};
}
