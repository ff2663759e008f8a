//! The figures of the book: pure functions from numbers to SVG.
//!
//! What a figure shows is computed by the functions that it explains: the pixel
//! grid by the camera, the roots by `hit_sphere`, the turned normal by
//! `set_face_normal`. So a figure cannot drift from the code.

pub mod build_test;
pub mod camera_frame;
pub mod cancellation;
mod charts;
mod decimal;
pub mod digits;
pub mod discriminant;
pub mod edge;
pub mod face_normal;
mod figure;
pub mod nearest;
pub mod normal;
pub mod normal_colors;
pub mod number;
pub mod passing;
mod pixels;
mod plane;
pub mod projection;
pub mod ray;
pub mod records;
pub mod red_sphere;
pub mod roots;
pub mod sphere_test;
mod style;
mod svg;
pub mod table;
pub mod unit_sky;
pub mod viewport_grid;

pub use charts::{CHARTS, Chart, Drawn, Point, find_chart, scene_chart};
pub use figure::{Figure, html};
pub use plane::Plane;
pub use style::{CSS, standalone};
pub use svg::{escape, spoken};

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
