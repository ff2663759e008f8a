//! The list of methods: each function with its name.

use common::rtweekend::*;

use self::Solve::{Double, Single};

use crate::certified::{certified_f32, certified_hit, certified_t, exact};
use crate::methods::{
    compensated, cross_q, double_double, half_b, half_b_f32, half_b_q, widened_half_b_q_f32,
};
use crate::precision::{Precision, SingleRay};

/// A way to find where a ray meets a sphere.
#[derive(Clone, Copy, Debug)]
pub struct Method {
    /// The name of the function.
    pub name: &'static str,
    /// The function.
    pub solve: Solve,
    /// True if a filter with a proven error bound stands behind each answer, and
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

impl Method {
    /// Half of b, as in chapter 5.
    pub const HALF_B: Self = Self::plain("half_b", Double(half_b));

    /// The discriminant of `half_b`, and roots that do not cancel.
    pub const HALF_B_Q: Self = Self::plain("half_b_q", Double(half_b_q));

    /// The distance of the line by a cross product.
    pub const CROSS_Q: Self = Self::plain("cross_q", Double(cross_q));

    /// The digits that oc, the cross product and c lose are added again.
    pub const COMPENSATED: Self = Self::plain("compensated", Double(compensated));

    /// The decision is certain, the digits of t are those of `half_b_q`.
    pub const CERTIFIED_HIT: Self = Self::plain("certified_hit", Double(certified_hit)).certified();

    /// The decision is certain, and so are the digits of t.
    pub const CERTIFIED_T: Self = Self::plain("certified_t", Double(certified_t)).certified();

    /// Twice the digits.
    pub const DOUBLE_DOUBLE: Self = Self::plain("double_double", Double(double_double));

    /// Integers of any length.
    pub const EXACT: Self = Self::plain("exact", Double(exact));

    /// Half of b in `f32`.
    pub const HALF_B_F32: Self = Self::plain("half_b_f32", Single(half_b_f32));

    /// Input in `f32`, and all between in `f64`.
    pub const WIDENED_HALF_B_Q_F32: Self =
        Self::plain("widened_half_b_q_f32", Single(widened_half_b_q_f32));

    /// Input in `f32`; the decision is certain, and so is the last digit of t.
    pub const CERTIFIED_F32: Self = Self::plain("certified_f32", Single(certified_f32)).certified();

    /// The method by which the others are measured: that of the chapters.
    pub const REFERENCE: Self = Self::HALF_B;

    /// Returns the precision that it computes with, seen from outside.
    pub fn precision(&self) -> Precision {
        match self.solve {
            Double(_) => Precision::Double,
            Single(_) => Precision::Single,
        }
    }

    /// Makes a method without a certificate.
    const fn plain(name: &'static str, solve: Solve) -> Self {
        Self {
            name,
            solve,
            is_certified: false,
        }
    }

    /// Returns the method with a certificate.
    const fn certified(self) -> Self {
        Self {
            is_certified: true,
            ..self
        }
    }
}
