//! Single and double precision: the two kinds of numbers that methods take and return.

use glam::Vec3;

/// A floating-point format of IEEE 754: that of the numbers which a method takes and returns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// `f64`, with 53 binary digits and exponents of two to ±1022.
    Double,
    /// `f32`, with 24 binary digits and exponents of two to ±126.
    Single,
}

impl Precision {
    /// Both formats: `f64`, then `f32`.
    pub const ALL: [Self; 2] = [Self::Double, Self::Single];

    /// Returns the name of the format in Rust, `f64` or `f32`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Double => "f64",
            Self::Single => "f32",
        }
    }

    /// Returns the spacing of the numbers from 1 to 2: 2⁻⁵² for `f64`, 2⁻²³ for `f32`.
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
