//! The legend: what the marks mean.

use glam::DVec2;
use speed_vs_accuracy::Precision::{Double, Single};

use super::chart::Layout;
use super::methods::{cross, mark};
use crate::svg::{Anchor, SMALL, Svg, width};

/// Explains the marks of methods at the top of a chart, and what a cross means there.
/// Returns where it ends.
pub(super) fn methods(svg: &mut Svg, layout: Layout, wrong: &str) -> f64 {
    let start = layout.choose(12.0, 4.0);
    let mut at = DVec2::new(start, 20.0);
    let marks: [(Mark, &str); 5] = [
        (&|svg, at| mark(svg, "ink", Double, at), "f64"),
        (&|svg, at| mark(svg, "ink", Single, at), "f32"),
        (
            &|svg, at| mark(svg, "reference", Double, at),
            "half_b, as in the chapters",
        ),
        (&|svg, at| mark(svg, "certain", Double, at), "certified"),
        (&|svg, at| cross(svg, at), wrong),
    ];
    for (draw, words) in marks {
        let size = 20.0 + width(words, SMALL);
        if at.x + size > layout.width() {
            at = DVec2::new(start, at.y + 20.0);
        }
        draw(svg, at + DVec2::new(8.0, -4.5));
        svg.small_label("ink", at + DVec2::new(20.0, 0.0), Anchor::Start, words);
        at.x += size + 12.0;
    }
    at.y
}

/// Draws a mark at a point.
type Mark<'a> = &'a dyn Fn(&mut Svg, DVec2);
