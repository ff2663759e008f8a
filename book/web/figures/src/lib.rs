//! The figures and charts of the book: functions from numbers to SVG drawings.
//!
//! The content of a figure is computed by the very functions that it explains: the pixel grid by
//! the camera, the roots by `hit_sphere`, the turned normal by `set_face_normal`. So a figure
//! cannot drift from the code.

mod arrows;
mod axis;
mod backwards;
mod camera_frame;
mod cancellation;
mod charts;
mod decimal;
mod digits;
mod discriminant;
mod face_normal;
mod figure;
mod live;
mod nearest;
mod normal;
mod normal_colors;
pub mod number;
mod parameters;
mod pixels;
mod plane;
mod prelude;
mod ray;
pub mod records;
mod style;
mod svg;
pub mod table;
mod text;
mod traced;
mod viewport_grid;
mod walk;

pub use charts::{
    ADVICE, CHARTS, Chart, DrawnChart, MAPPED, Map, Spot, least, panel_with_key, scenes_table,
};
pub use figure::{Figure, Question};
pub use live::{DrawnFigure, Movable};
pub use parameters::Parameter;
pub use style::{CSS, standalone};
pub use svg::Svg;
pub use text::{escape, html};

/// The live figures of chapters 0 to 5, which a reader changes on the page, in reading order. The
/// scripts of the pages call a figure by its index here, from 0.
pub static LESSON: &[&dyn Movable] = &[
    &backwards::LIVE,
    &arrows::LIVE,
    &ray::LIVE,
    &camera_frame::LIVE,
    &viewport_grid::LIVE,
    &walk::LIVE,
    &discriminant::LIVE,
    &normal::LIVE,
    &normal_colors::LIVE,
    &nearest::LIVE,
    &face_normal::LIVE,
];

/// The live figure of chapter 6, in a list of its own because drawing it needs all methods and
/// integers of any size.
pub static ACCURACY: &[&dyn Movable] = &[&digits::LIVE];

/// Returns all live figures of the book in reading order: those of [`LESSON`] and then
/// [`ACCURACY`].
pub fn figures() -> impl Iterator<Item = &'static dyn Movable> {
    LESSON.iter().chain(ACCURACY).copied()
}
