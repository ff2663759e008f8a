//! The book's `vec3`: three numbers, and what can be done with them.

use std::ops::{Add, Mul, Neg, Sub};

/// A vector: `x` to the right, `y` up, `z` towards the viewer.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec3 {
    pub x: f64,
    pub y: f64,
    pub z: f64,
}

/// A place in space.
pub type Point3 = Vec3;

/// Red, green and blue, each from 0 to 1.
pub type Color = Vec3;

impl Vec3 {
    pub const ZERO: Self = Self::new(0.0, 0.0, 0.0);
    pub const ONE: Self = Self::new(1.0, 1.0, 1.0);

    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self { x, y, z }
    }

    /// The products of equal letters, added from left to right.
    pub fn dot(self, other: Self) -> f64 {
        todo!()
    }

    pub fn length_squared(self) -> f64 {
        todo!()
    }

    pub fn length(self) -> f64 {
        todo!()
    }

    /// The unit vector of this direction: times 1/length, as the book divides.
    pub fn normalize(self) -> Self {
        todo!()
    }
}

impl Add for Vec3 {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        todo!()
    }
}

impl Sub for Vec3 {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        todo!()
    }
}

impl Neg for Vec3 {
    type Output = Self;

    fn neg(self) -> Self {
        todo!()
    }
}

/// A number times a vector.
impl Mul<Vec3> for f64 {
    type Output = Vec3;

    fn mul(self, v: Vec3) -> Vec3 {
        todo!()
    }
}

/// A vector times a number.
impl Mul<f64> for Vec3 {
    type Output = Self;

    fn mul(self, number: f64) -> Self {
        number * self
    }
}
