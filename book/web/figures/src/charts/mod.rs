//! The charts of the book, drawn from the files that hold what was measured.

mod chart;
mod labels;
mod methods;
mod panel;
mod pareto;
mod speed_accuracy;
mod sweep;
mod wrong_pixels;

pub use chart::{Chart, Drawn};

/// All charts, in reading order.
pub const CHARTS: &[Chart] = &[speed_accuracy::BOOK, sweep::DISTANCE, wrong_pixels::CHART];
