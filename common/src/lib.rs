//! The code that two or more chapters share, and nothing else.
//!
//! A chapter starts with `use common::rtweekend::*;`, as each file of the book starts with
//! `#include "rtweekend.h"`. The book's header also defines infinity, pi and a degree-to-radian
//! conversion; Rust's `f64` has all three, so they are not defined again.
//!
//! The files beside this one are the lesson's own words. The folder `engine` paints and prints
//! pictures: it is no lesson, and no chapter needs to know it. Neither of them knows a sphere.

mod camera;
mod color;
pub mod engine;
mod ray;
mod vec3;

/// The prelude of every chapter: the names that `use common::rtweekend::*;` brings.
pub mod rtweekend {
    pub use crate::camera::Camera;
    pub use crate::color::{Color, sky, write_color};
    pub use crate::engine::{Picture, render};
    pub use crate::ray::Ray;
    pub use crate::vec3::{Point3, Vec3};
}
