//! The prelude: what every chapter uses, all of it your own.

pub use crate::ray::Ray;
pub use crate::render::{Picture, render};
pub use crate::vec3::{Color, Point3, Vec3};
