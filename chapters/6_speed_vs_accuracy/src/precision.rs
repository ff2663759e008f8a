//! Single and double precision: the two kinds of numbers that methods compute with.

use glam::Vec3;

/// A kind of number, named as in IEEE 754.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// `f64`: 53 digits of base two, exponents to ±1000.
    Double,
    /// `f32`: 24 digits, exponents to ±126.
    Single,
}

impl Precision {
    /// Both, the finer one first.
    pub const ALL: [Self; 2] = [Self::Double, Self::Single];

    /// Returns its name in Rust, `f64` or `f32`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Double => "f64",
            Self::Single => "f32",
        }
    }

    /// Returns how far numbers from 1 to 2 are apart.
    pub fn epsilon(self) -> f64 {
        match self {
            Self::Double => f64::EPSILON,
            Self::Single => f32::EPSILON.into(),
        }
    }
}

/// A ray in `f32`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SingleRay {
    /// The point at t = 0.
    pub origin: Vec3,
    /// The way for each unit of t; it need not be a unit vector.
    pub direction: Vec3,
}

impl SingleRay {
    /// Makes the ray from `origin` along `direction`.
    #[inline]
    pub const fn new(origin: Vec3, direction: Vec3) -> Self {
        Self { origin, direction }
    }
}
