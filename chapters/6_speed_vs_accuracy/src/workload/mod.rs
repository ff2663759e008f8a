//! Workload: what methods are asked, how the questions are made, and what becomes of the
//! answers in a picture.

mod case;
mod failure_map;
mod regimes;
mod scene;

pub use case::Case;
pub use failure_map::{FailureMap, beside, failure_map, tangent};
pub use regimes::{REGIMES, Random, Regime, find_regime};
pub use scene::{Eye, Hit, Lens, Scene, Sight, T_MIN_OF_SHADOWS, unit};
