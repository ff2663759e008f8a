//! The charts of the book, drawn from the files that hold what was measured.

mod chart;
mod marks;
mod speed_accuracy;
mod sweep;
mod wrong_pixels;

pub use chart::{Chart, DrawnChart};

/// All charts of the book, in reading order.
pub const CHARTS: &[Chart] = &[sweep::CHART, speed_accuracy::CHART, wrong_pixels::CHART];
