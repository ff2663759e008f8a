//! The figures of the book: pure functions from numbers to SVG.
//!
//! What a figure shows is computed by the functions that it explains: the pixel
//! grid by the camera, the roots by `hit_sphere`, the turned normal by
//! `set_face_normal`. So a figure cannot drift from the code.

mod build_test;
mod camera_frame;
mod cancellation;
mod charts;
mod decimal;
mod digits;
mod discriminant;
mod edge;
mod face_normal;
mod figure;
mod live;
mod nearest;
mod normal;
mod normal_colors;
pub mod number;
mod passing;
mod pixels;
mod plane;
mod projection;
mod ray;
pub mod records;
mod red_sphere;
mod roots;
mod sphere_test;
mod style;
mod svg;
pub mod table;
mod traced;
mod unit_sky;
mod viewport_grid;

pub use charts::{CHARTS, Chart, Drawn, Point, find_chart, scene_chart};
pub use figure::{Figure, html};
pub use live::{Answer, Movable, Number};
pub use style::{CSS, standalone};
pub use svg::{Svg, escape};

/// All figures, in reading order: the nine of the notes, and eight more.
pub const FIGURES: &[Figure] = &[
    build_test::FIGURE,
    ray::FIGURE,
    camera_frame::FIGURE,
    viewport_grid::FIGURE,
    unit_sky::FIGURE,
    sphere_test::FIGURE,
    roots::FIGURE,
    passing::FIGURE,
    discriminant::FIGURE,
    projection::FIGURE,
    red_sphere::FIGURE,
    normal::FIGURE,
    normal_colors::FIGURE,
    face_normal::FIGURE,
    nearest::FIGURE,
    digits::FIGURE,
    edge::FIGURE,
];

/// The figure of that name.
pub fn find(name: &str) -> Option<&'static Figure> {
    FIGURES.iter().find(|figure| figure.name == name)
}

/// The figures of the lesson that a reader can move, in reading order. A page names them by
/// their place.
pub static LESSON: &[&dyn Movable] = &[
    &ray::LIVE,
    &camera_frame::LIVE,
    &viewport_grid::LIVE,
    &discriminant::LIVE,
    &normal::LIVE,
    &normal_colors::LIVE,
    &projection::LIVE,
    &nearest::LIVE,
    &face_normal::LIVE,
];

/// Those of chapter 6, which call all that it has, integers of any size among it.
pub static ACCURACY: &[&dyn Movable] = &[&digits::LIVE, &edge::LIVE];

/// All figures that a reader can move.
pub fn live_figures() -> impl Iterator<Item = &'static dyn Movable> {
    LESSON.iter().chain(ACCURACY).copied()
}

/// The live figure of that name.
pub fn find_live(name: &str) -> Option<&'static dyn Movable> {
    live_figures().find(|live| live.name() == name)
}
