//! Marks: the color and the shape of each method in the charts, and its number of right digits.

use speed_vs_accuracy::Precision::{self, Double, Single};
use speed_vs_accuracy::{Method, find};

use crate::prelude::*;

/// Returns the class of a method's color and mark in all charts.
pub(super) fn idea(method: &str) -> &'static str {
    match find(method) {
        Some(method) if method.name == Method::REFERENCE.name => "reference",
        Some(method) if method.is_certified => "certain",
        _ => "ink",
    }
}

/// Converts an error in ulps to the number of right decimal digits in this precision, at least 0. A
/// method that never hit, with the error `None`, has 0.
pub(super) fn digits(ulps: Option<f64>, precision: Precision) -> f64 {
    let left = |ulps: f64| -(precision.epsilon() * ulps.max(0.5)).log10();
    ulps.map_or(0.0, left).max(0.0)
}

/// Draws a method's mark at a place: a square for the reference, a diamond for a certified method,
/// a disc for any other. For `f32` the mark is hollow.
pub(super) fn mark(svg: &mut Svg, idea: &str, precision: Precision, at: DVec2) {
    let (filling, radius) = match precision {
        Double => ("solid", 4.5),
        Single => ("hollow", 4.0),
    };
    let class = format!("{idea} {filling}");
    match idea {
        "reference" => svg.rect(&class, at - 4.5, DVec2::splat(9.0)),
        "certain" => {
            // The top twice: a hollow one has four sides as well.
            let corners = [DVec2::NEG_Y, DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y];
            svg.path(&class, &corners.map(|corner| at + 6.0 * corner));
        }
        _ => svg.circle(&class, at, radius),
    }
}

/// Draws the mark of a wrong decision: a cross.
pub(super) fn cross(svg: &mut Svg, at: DVec2) {
    for way in [spot(7.0, 7.0), spot(7.0, -7.0)] {
        svg.line("wrong line", at - way, at + way);
    }
}

/// Draws a ring around the mark of the method to take.
pub(super) fn ring(svg: &mut Svg, at: DVec2, radius: f64) {
    svg.circle("certain line", at, radius);
}
