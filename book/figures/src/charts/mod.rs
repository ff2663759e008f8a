//! The charts of the book, drawn from the files that hold what was measured.

mod chart;
mod labels;
mod methods;
mod panel;
mod pareto;
mod race;
mod speed_accuracy;
mod sweep;
mod wrong_pixels;

pub use chart::{Chart, Drawn};
pub use methods::Point;
pub use speed_accuracy::scene_chart;

/// All charts, in reading order.
pub const CHARTS: &[Chart] = &[
    speed_accuracy::BOOK,
    speed_accuracy::REGIMES,
    sweep::DISTANCE,
    wrong_pixels::CHART,
    race::PROGRAMS,
    race::TRACING,
];
