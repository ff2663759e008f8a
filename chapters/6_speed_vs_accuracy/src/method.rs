//! The list of methods: each function with its name.

use common::rtweekend::*;

use self::Solve::{Double, Single};

use crate::certified::{certified_hit, certified_t, exact};
use crate::methods::{
    compensated, cross_q, double_double, half_b, half_b_f32, half_b_q, widened_half_b_q_f32,
};
use crate::precision::{Precision, SingleRay};

/// A function that finds where a ray meets a sphere, with its name for tables and charts.
#[derive(Clone, Copy, Debug)]
pub struct Method {
    /// The name of the function in Rust, such as `half_b_q`.
    pub name: &'static str,
    /// The function itself, with the precision of its numbers.
    pub solve: Solve,
    /// True if the function has a proven error bound, and computes with more digits wherever that
    /// leaves a doubt.
    pub is_certified: bool,
}

/// A function that finds the nearest root with `t_min` < `t` < `t_max`, or `None`, from the center,
/// the radius, the ray, `t_min` and `t_max`, in one of two precisions.
#[derive(Clone, Copy, Debug)]
pub enum Solve {
    /// A function in `f64`, of center, radius, ray, `t_min` and `t_max`.
    Double(fn(Point3, f64, &Ray, f64, f64) -> Option<f64>),
    /// A function in `f32`, of center, radius, ray, `t_min` and `t_max`.
    Single(fn(glam::Vec3, f32, &SingleRay, f32, f32) -> Option<f32>),
}

impl Method {
    /// [`half_b`]: solves the quadratic equation with h = b/−2 in place of b, as chapter 5 does.
    pub const HALF_B: Self = Self::plain("half_b", Double(half_b));
    /// [`half_b_q`]: takes the discriminant of `half_b`, and roots without cancellation.
    pub const HALF_B_Q: Self = Self::plain("half_b_q", Double(half_b_q));
    /// [`cross_q`]: takes the discriminant from a cross product.
    pub const CROSS_Q: Self = Self::plain("cross_q", Double(cross_q));
    /// [`compensated`]: adds back the digits that rounding takes.
    pub const COMPENSATED: Self = Self::plain("compensated", Double(compensated));
    /// [`certified_hit`]: always decides correctly; its t is as accurate as that of `half_b_q`.
    pub const CERTIFIED_HIT: Self = Self::certified("certified_hit", Double(certified_hit));
    /// [`certified_t`]: always decides correctly, with a t less than 0.8 ulp off.
    pub const CERTIFIED_T: Self = Self::certified("certified_t", Double(certified_t));
    /// [`double_double`]: computes with some 106 binary digits.
    pub const DOUBLE_DOUBLE: Self = Self::plain("double_double", Double(double_double));
    /// [`exact`]: computes with integers of any length, and rounds t once.
    pub const EXACT: Self = Self::plain("exact", Double(exact));
    /// [`half_b_f32`]: computes as `half_b` in `f32`.
    pub const HALF_B_F32: Self = Self::plain("half_b_f32", Single(half_b_f32));
    /// [`widened_half_b_q_f32`]: takes and returns `f32`, and computes as `half_b_q` in `f64`.
    pub const WIDENED_HALF_B_Q_F32: Self =
        Self::plain("widened_half_b_q_f32", Single(widened_half_b_q_f32));
    /// The method with which the others are compared in tables.
    pub const REFERENCE: Self = Self::HALF_B;

    /// Returns the precision of the method's input and of its t.
    pub fn precision(&self) -> Precision {
        match self.solve {
            Double(_) => Precision::Double,
            Single(_) => Precision::Single,
        }
    }

    const fn plain(name: &'static str, solve: Solve) -> Self {
        Self {
            name,
            solve,
            is_certified: false,
        }
    }

    const fn certified(name: &'static str, solve: Solve) -> Self {
        Self {
            is_certified: true,
            ..Self::plain(name, solve)
        }
    }
}
