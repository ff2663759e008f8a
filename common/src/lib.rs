//! What two or more chapters share, and nothing else.
//!
//! A chapter starts with `use common::rtweekend::*;`, as each file of the book
//! starts with `#include "rtweekend.h"`. The book's header also defines
//! infinity, pi and a degree-to-radian conversion; Rust's `f64` has all three,
//! so they are not defined again.
//!
//! Nothing here knows what a sphere is.

mod camera;
pub mod chapter;
mod color;
mod in_order;
mod many;
pub mod output;
mod picture;
mod ray;
mod text;
mod vec3;

/// The prelude of every chapter.
pub mod rtweekend {
    pub use crate::camera::{Camera, Rays, render, render_many};
    pub use crate::color::{Color, sky, write_color};
    pub use crate::many::{Many, Pixels};
    pub use crate::picture::Picture;
    pub use crate::ray::Ray;
    pub use crate::vec3::{Point3, Vec3};
}
