//! The prelude of the texts: the interpreter's own text of it, compiled, and what the interpreter has
//! built in.

use std::ops::{Add, Div, Mul, Neg, Rem, Sub};

use crate::file;

#[path = "../../../interpreter/src/texts/prelude.rs"]
mod prelude;

pub use prelude::{Camera, Color, Point3, Ray, Vec3, render, sky};

/// A vector of three numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DVec3 {
    pub x: f64,
    pub y: f64,
    pub z: f64,
}

impl DVec3 {
    pub const ZERO: Self = Self::new(0.0, 0.0, 0.0);
    pub const ONE: Self = Self::new(1.0, 1.0, 1.0);

    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self { x, y, z }
    }
}

impl Mul<f64> for DVec3 {
    type Output = Self;

    fn mul(self, t: f64) -> Self {
        t * self
    }
}

/// A picture of `width` × `height` pixels, and how to paint each.
pub struct Picture {
    pub width: u32,
    pub height: u32,
    levels_at: Box<dyn Fn(u32, u32) -> [i32; 3] + Send + Sync>,
}

impl Picture {
    pub fn paint(
        width: u32,
        height: u32,
        color_at: impl Fn(u32, u32) -> Color + Send + Sync + 'static,
    ) -> Self {
        let levels_at = Box::new(move |i, j| file::print(color_at(i, j)));
        Self {
            width,
            height,
            levels_at,
        }
    }

    /// Returns the levels of red, green and blue, 0 to 255, that are printed for the pixel in column
    /// `i` and row `j`, from 0 at the top left.
    pub fn levels(&self, i: u32, j: u32) -> [i32; 3] {
        (self.levels_at)(i, j)
    }
}
