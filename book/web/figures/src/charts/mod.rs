//! The charts of the book, drawn from the files that hold what was measured.

mod chart;
mod labels;
mod map;
mod marks;
mod speed_accuracy;
mod spot;
mod wrong_pixels;

pub use chart::{Chart, DrawnChart};
pub use map::Map;
pub use speed_accuracy::{ADVICE, panel_with_key};
pub use spot::{MAPPED, Spot};
pub use wrong_pixels::{least, scenes_table};

/// All charts of the book, in reading order.
pub const CHARTS: &[Chart] = &[speed_accuracy::CHART, map::CHART];
