//! # Chapter 6: speed against accuracy
//!
//! Every serious way to intersect a ray with a sphere, in one place and over
//! one signature.

pub mod bounds;
mod certified;
mod method;
mod methods;
mod nearest;
mod precision;
mod workload;

pub use certified::{Stage, certified_hit, certified_t, exact, exact_discriminant, stage_of_hit};
pub use method::{Method, Solve};
pub use methods::{
    compensated, cross_q, double_double, half_b, half_b_f32, half_b_q, widened_half_b_q_f32,
};
pub use nearest::certified_nearest;
pub use precision::{Precision, SingleRay};
pub use workload::{
    Arithmetic, Case, Hit, Lens, REGIMES, Random, Regime, SPHERES, Scene, Sight, USUAL_T_MIN,
    above, aimed, unit,
};

use common::rtweekend::Picture;

/// Returns the picture of a star in a telescope, `width` pixels wide: its left half with the
/// rounding errors of chapter 5, its right half without them.
pub fn picture(width: u32) -> Picture {
    let halves = [Method::HALF_B, Method::CERTIFIED_T].map(Arithmetic::Method);
    Scene::telescope().seen_by(halves, width)
}

/// All methods: first those that take and return `f64`, from `half_b` to `exact`, then those for
/// `f32`.
pub const METHODS: &[Method] = &[
    Method::HALF_B,
    Method::HALF_B_Q,
    Method::CROSS_Q,
    Method::COMPENSATED,
    Method::CERTIFIED_HIT,
    Method::CERTIFIED_T,
    Method::DOUBLE_DOUBLE,
    Method::EXACT,
    Method::HALF_B_F32,
    Method::WIDENED_HALF_B_Q_F32,
];

/// Returns the method of that name, such as `half_b`, or `None` if there is none.
pub fn find(name: &str) -> Option<Method> {
    METHODS.iter().copied().find(|method| method.name == name)
}
