//! A method: the function, and what decides where it is exact and where it fails.

use common::rtweekend::*;

use crate::precision::{Precision, SingleRay};

/// A way to find where a ray meets a sphere.
#[derive(Clone, Copy, Debug)]
pub struct Method {
    /// The name of the function.
    pub name: &'static str,
    /// The function.
    pub solve: Solve,
    /// What its decision between hit and miss hangs on.
    pub discriminant: Discriminant,
    /// Whether c = oc·oc − r² is the plain difference of two rounded squares,
    /// which cancels near the surface.
    pub c_cancels: bool,
    /// Whether the nearer root is (h − √D)/a, which cancels in front of a large
    /// sphere, and not c/(h + √D).
    pub root_cancels: bool,
    /// Whether no exponent of its input is too large or too small: it scales
    /// first, or has wider numbers, or later stages.
    pub any_exponent: bool,
    /// How many decimal digits it computes with: more than its input has where
    /// it widens that.
    pub digits: f64,
    /// Whether a filter with a proven error bound stands behind each answer, and
    /// asks for more digits where it cannot be sure.
    pub is_certified: bool,
}

/// A function from center, radius, ray, `t_min` and `t_max` to the nearest root
/// with `t_min` < `t` < `t_max`, if there is one, in one of two precisions.
#[derive(Clone, Copy, Debug)]
pub enum Solve {
    /// In `f64`.
    Double(fn(Point3, f64, &Ray, f64, f64) -> Option<f64>),
    /// In `f32`.
    Single(fn(glam::Vec3, f32, &SingleRay, f32, f32) -> Option<f32>),
}

/// How a method finds D = h² − a·c.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Discriminant {
    /// As the difference h² − a·c, which cancels where the sphere is far.
    Difference,
    /// As a·(r² − l²), with l the distance of the line from the center: that
    /// cancels near a tangent only.
    Distance,
    /// With as many digits as it takes for a sign that is certain.
    Certain,
}

impl Method {
    /// The precision that it computes with, seen from outside.
    pub fn precision(&self) -> Precision {
        match self.solve {
            Solve::Double(_) => Precision::Double,
            Solve::Single(_) => Precision::Single,
        }
    }

    /// A method in `f64` that is like `half_b_q`, but for what is said beside it.
    pub(crate) const fn double(
        name: &'static str,
        solve: fn(Point3, f64, &Ray, f64, f64) -> Option<f64>,
    ) -> Self {
        Self::plain(name, Solve::Double(solve), Precision::Double)
    }

    /// A method in `f32` that is like `half_b_q`, but for what is said beside it.
    pub(crate) const fn single(
        name: &'static str,
        solve: fn(glam::Vec3, f32, &SingleRay, f32, f32) -> Option<f32>,
    ) -> Self {
        Self::plain(name, Solve::Single(solve), Precision::Single)
    }

    const fn plain(name: &'static str, solve: Solve, precision: Precision) -> Self {
        Self {
            name,
            solve,
            discriminant: Discriminant::Difference,
            c_cancels: true,
            root_cancels: false,
            any_exponent: false,
            digits: precision.digits(),
            is_certified: false,
        }
    }
}
