//! Workload: what methods are asked, how the questions are made, and what becomes of the
//! answers in a picture.

mod case;
mod regimes;
mod scene;

pub use case::Case;
pub use regimes::{REGIMES, Random, Regime, SPHERES, above, aimed};
pub use scene::{Arithmetic, Hit, Lens, Scene, Sight, USUAL_T_MIN, unit};
