//! What the marks mean.

use glam::DVec2;
use speed_vs_accuracy::Precision::{Double, Single};

use super::methods::{cross, mark};
use crate::svg::{Anchor, SMALL, Svg, width};

/// Explains the marks of methods in one line from `at` on.
pub(super) fn methods(svg: &mut Svg, at: DVec2) {
    let mut x = at.x;
    let marks: [(Mark, &str); 5] = [
        (&|svg, at| mark(svg, "ink", Double, at), "f64"),
        (&|svg, at| mark(svg, "ink", Single, at), "f32"),
        (
            &|svg, at| mark(svg, "reference", Double, at),
            "half_b, as in the chapters",
        ),
        (&|svg, at| mark(svg, "certain", Double, at), "certified"),
        (&|svg, at| cross(svg, at), "confuses some hits and misses"),
    ];
    for (draw, words) in marks {
        draw(svg, DVec2::new(x + 8.0, at.y - 4.5));
        svg.small_label("ink", DVec2::new(x + 20.0, at.y), Anchor::Start, words);
        x += 20.0 + width(words, SMALL) + 12.0;
    }
}

/// Draws a mark at a point.
type Mark<'a> = &'a dyn Fn(&mut Svg, DVec2);
