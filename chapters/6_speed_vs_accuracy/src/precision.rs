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

    /// As it is called in Rust.
    pub fn name(self) -> &'static str {
        match self {
            Self::Double => "f64",
            Self::Single => "f32",
        }
    }

    /// How far numbers from 1 to 2 are apart.
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
    /// Where it starts.
    pub origin: Vec3,
    /// Where it points; one `t` long.
    pub direction: Vec3,
}

impl SingleRay {
    /// The ray from `origin` along `direction`.
    #[inline]
    pub const fn new(origin: Vec3, direction: Vec3) -> Self {
        Self { origin, direction }
    }
}
