//! A bar chart: bars with words at their ends.

use glam::DVec2;

use super::chart::Layout;
use crate::svg::{Anchor, Svg};

/// A bar from `corner` on, and what it says: behind its end, or where that leaves no
/// room for the bar, above it. Returns the corner of the bar itself.
pub(super) fn bar(
    svg: &mut Svg,
    layout: Layout,
    idea: &str,
    corner: DVec2,
    length: f64,
    words: &str,
) -> DVec2 {
    let bar = corner + layout.choose(DVec2::ZERO, DVec2::new(0.0, 18.0));
    let at = corner + layout.choose(DVec2::new(length + 9.0, 12.5), DVec2::new(0.0, 13.0));
    svg.rect(&format!("{idea} solid"), bar, DVec2::new(length, HEIGHT));
    svg.small_label("ink", at, Anchor::Start, words);
    bar
}

/// The height of a bar without its words.
const HEIGHT: f64 = 16.0;
