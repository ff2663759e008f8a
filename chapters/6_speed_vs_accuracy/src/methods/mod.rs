//! Floating point: each method rounds as it goes and hopes for the best.
//!
//! In what is said about errors, u = 2⁻⁵³ is the largest relative error of one
//! operation, and M = oc·oc + r². What a method costs is counted in √ and ÷,
//! which take several times as long as + and ×.

mod cross_q;
mod double_double;
mod error_free;
mod haines;
mod half_b;
mod half_b_q;
mod herbie;
mod interval;
mod kahan_q;
mod scaled_q;
mod single;

pub use cross_q::{adaptive_q, cross_q};
pub use double_double::double_double;
pub use haines::{haines, haines_q};
pub use half_b::{full_b, half_b};
pub use half_b_q::half_b_q;
pub use herbie::herbie;
pub use interval::interval_q;
pub use kahan_q::kahan_q;
pub use scaled_q::scaled_q;
pub use single::{cross_q_f32, half_b_f32, half_b_q_f32, widened_half_b_q_f32};

pub(crate) use double_double::{Double, Quadratic};
pub(crate) use half_b_q::roots_by_q;
pub(crate) use scaled_q::{exponent, two_to};
pub(crate) use single::widened;
