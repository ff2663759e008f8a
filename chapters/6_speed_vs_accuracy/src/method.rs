//! A method: the function, with its name.

use common::rtweekend::*;

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
    /// Returns the precision that it computes with, seen from outside.
    pub fn precision(&self) -> Precision {
        match self.solve {
            Solve::Double(_) => Precision::Double,
            Solve::Single(_) => Precision::Single,
        }
    }

    /// Makes a method in `f64` without a certificate.
    pub(crate) const fn double(
        name: &'static str,
        solve: fn(Point3, f64, &Ray, f64, f64) -> Option<f64>,
    ) -> Self {
        Self::plain(name, Solve::Double(solve))
    }

    /// Makes a method in `f32` without a certificate.
    pub(crate) const fn single(
        name: &'static str,
        solve: fn(glam::Vec3, f32, &SingleRay, f32, f32) -> Option<f32>,
    ) -> Self {
        Self::plain(name, Solve::Single(solve))
    }

    /// Returns the method with a certificate.
    pub(crate) const fn certified(self) -> Self {
        Self {
            is_certified: true,
            ..self
        }
    }

    const fn plain(name: &'static str, solve: Solve) -> Self {
        Self {
            name,
            solve,
            is_certified: false,
        }
    }
}
