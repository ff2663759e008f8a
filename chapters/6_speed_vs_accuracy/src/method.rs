//! All methods by name.

use common::rtweekend::*;

use crate::single::SingleRay;
use crate::{certified, double_double, exact, plain, single};

/// A way to find where a ray meets a sphere.
#[derive(Clone, Copy, Debug)]
pub struct Method {
    /// The name of the function.
    pub name: &'static str,
    /// The function.
    pub solve: Solve,
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

/// All methods; `half_b`, by which the others are measured, is the second.
pub const METHODS: &[Method] = &[
    double("full_b", plain::full_b),
    double("half_b", plain::half_b),
    double("half_b_q", plain::half_b_q),
    double("haines", plain::haines),
    double("haines_q", plain::haines_q),
    double("kahan_q", plain::kahan_q),
    double("cross_q", plain::cross_q),
    double("adaptive_q", plain::adaptive_q),
    double("scaled_q", plain::scaled_q),
    double("certified_hit", certified::certified_hit),
    double("certified_t", certified::certified_t),
    double("double_double", double_double::double_double),
    double("exact", exact::exact),
    single("half_b_f32", single::half_b_f32),
    single("half_b_q_f32", single::half_b_q_f32),
    single("cross_q_f32", single::cross_q_f32),
    single("widened_half_b_q_f32", single::widened_half_b_q_f32),
];

/// The method of that name.
pub fn find(name: &str) -> Option<Method> {
    METHODS.iter().copied().find(|method| method.name == name)
}

const fn double(
    name: &'static str,
    solve: fn(Point3, f64, &Ray, f64, f64) -> Option<f64>,
) -> Method {
    Method {
        name,
        solve: Solve::Double(solve),
    }
}

const fn single(
    name: &'static str,
    solve: fn(glam::Vec3, f32, &SingleRay, f32, f32) -> Option<f32>,
) -> Method {
    Method {
        name,
        solve: Solve::Single(solve),
    }
}
