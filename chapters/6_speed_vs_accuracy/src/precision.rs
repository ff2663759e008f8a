//! Single and double precision: the two kinds of numbers that methods compute with.

use glam::Vec3;

/// A floating-point format, named as in IEEE 754.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// `f64`: 53 digits of base two, exponents to ±1000.
    Double,
    /// `f32`: 24 digits, exponents to ±126.
    Single,
}

impl Precision {
    /// Both formats, the finer one first.
    pub const ALL: [Self; 2] = [Self::Double, Self::Single];

    /// Returns the name of the format in Rust, `f64` or `f32`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Double => "f64",
            Self::Single => "f32",
        }
    }

    /// Returns the distance between neighboring numbers from 1 to 2.
    pub fn epsilon(self) -> f64 {
        match self {
            Self::Double => f64::EPSILON,
            Self::Single => f32::EPSILON.into(),
        }
    }
}

/// A ray whose numbers are stored in `f32`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SingleRay {
    /// The point at t = 0, where the ray starts.
    pub origin: Vec3,
    /// The vector from `origin` to the point at t = 1; it need not have unit length.
    pub direction: Vec3,
}

impl SingleRay {
    /// Makes the ray from `origin` along `direction`.
    #[inline]
    pub const fn new(origin: Vec3, direction: Vec3) -> Self {
        Self { origin, direction }
    }
}
