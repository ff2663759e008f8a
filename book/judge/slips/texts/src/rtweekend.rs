//! What the interpreter has built in: vectors with their operators, rays, and pictures.

use std::ops::{Add, Mul, Neg, Sub};

use crate::prelude::{dot, file, ray, vectors};

pub use crate::prelude::camera::Camera;
pub use crate::prelude::color::sky;
pub use crate::prelude::render::render;

/// A vector of three numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec3 {
    pub x: f64,
    pub y: f64,
    pub z: f64,
}

/// A place in space.
pub type Point3 = Vec3;

/// A color: red, green and blue as `x`, `y` and `z`, each from 0 to 1.
pub type Color = Vec3;

impl Vec3 {
    pub const ZERO: Self = Self::new(0.0, 0.0, 0.0);
    pub const ONE: Self = Self::new(1.0, 1.0, 1.0);

    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self { x, y, z }
    }

    pub fn dot(self, other: Self) -> f64 {
        dot::dot(self, other)
    }

    pub fn length_squared(self) -> f64 {
        vectors::length_squared(self)
    }

    pub fn length(self) -> f64 {
        vectors::length(self)
    }

    pub fn normalize(self) -> Self {
        vectors::normalize(self)
    }
}

impl Add for Vec3 {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl Sub for Vec3 {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl Neg for Vec3 {
    type Output = Self;

    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl Mul<f64> for Vec3 {
    type Output = Self;

    fn mul(self, t: f64) -> Self {
        Self::new(self.x * t, self.y * t, self.z * t)
    }
}

impl Mul<Vec3> for f64 {
    type Output = Vec3;

    fn mul(self, v: Vec3) -> Vec3 {
        v * self
    }
}

/// The half-line from `origin` along `direction`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    pub origin: Point3,
    pub direction: Vec3,
}

impl Ray {
    pub const fn new(origin: Point3, direction: Vec3) -> Self {
        Self { origin, direction }
    }

    pub fn at(&self, t: f64) -> Point3 {
        ray::at(self, t)
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
