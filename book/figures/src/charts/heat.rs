//! A cell of a heat map: the darker, the more is wrong.

use glam::DVec2;

use crate::svg::{Anchor, Svg};

/// Draws a cell of which this share is wrong, in one of four depths: a tick where none is,
/// and otherwise these `words`.
pub(super) fn cell(svg: &mut Svg, corner: DVec2, size: DVec2, wrong: f64, words: &str) {
    let depth = match wrong {
        0.0 => 0,
        ..1e-2 => 1,
        ..1e-1 => 4,
        _ => 5,
    };
    svg.rect(&format!("heat depth-{depth}"), corner, size);
    let words = if depth == 0 { "✓" } else { words };
    let idea = if depth > 3 { "on-heat" } else { "ink" };
    let at = corner + DVec2::new(0.5 * size.x, 0.5 * size.y + 4.5);
    // No halo on a colored ground.
    svg.group("bare", |svg| {
        svg.small_label(idea, at, Anchor::Middle, words);
    });
}
