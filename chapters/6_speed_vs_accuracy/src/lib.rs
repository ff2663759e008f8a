//! # Chapter 6: speed against accuracy
//!
//! Every serious way to intersect a ray with a sphere, in one place and over
//! one signature.

mod case;
mod certified;
mod double_double;
mod error_free;
mod exact;
mod failure_map;
mod fixed_width;
mod interval;
mod leaving;
mod method;
mod methods;
mod nearest;
mod plain;
mod precision;
mod refined;
mod regimes;
mod rescaled;
mod scene_file;
mod scenes;
mod sharper;
mod single;

pub use case::Case;
pub use certified::{C_BAND, D_BAND, E_EXPONENT, R_BANDS, T_BAND};
pub use certified::{Stage, certified_hit, certified_t, stage_of_hit, stage_of_t};
pub use double_double::{Double, double_double};
pub use exact::{exact, exact_discriminant};
pub use failure_map::{FailureMap, beside, failure_map, tangent};
pub use fixed_width::{W_BAND, pairs};
pub use interval::interval_q;
pub use leaving::{
    Departure, LEAVINGS, Leaving, after_t_min, at_once, integer_offset, pbrt_offset, proven_offset,
};
pub use method::{Discriminant, Method, Solve};
pub use methods::{METHODS, find};
pub use nearest::certified_nearest;
pub use plain::{
    adaptive_q, cross_q, full_b, haines, haines_q, half_b, half_b_q, herbie, kahan_q, scaled_q,
};
pub use precision::Precision;
pub use refined::refined;
pub use regimes::{REGIMES, Random, Regime, find_regime};
pub use scene_file::{Mistake, WIDEST};
pub use scenes::{Eye, Hit, Lens, SCENES, Scene, Sight, T_MIN_OF_SHADOWS, find_scene};
pub use sharper::{S_C_BAND, S_D_BAND, Sharper};
pub use single::{
    SingleRay, certified_f32, cross_q_f32, half_b_f32, half_b_q_f32, widened_half_b_q_f32,
};

use common::rtweekend::Picture;

/// The picture at `width` pixels wide: a star in a telescope, on the left as
/// chapter 5 sees it, on the right as it is.
pub fn picture(width: u32) -> Picture {
    let scene = find_scene("telescope").expect("it is one of the seven");
    scene.halves(Method::HALF_B, Method::CERTIFIED_T, width)
}
