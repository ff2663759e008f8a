//! The texts of the prelude that a program of rays needs, and those of the file around a picture.

pub mod camera;
pub mod color;
pub mod dot;
#[allow(unused_variables, reason = "mistakes use them")]
pub mod file;
pub mod ray;
pub mod render;
pub mod vectors;
