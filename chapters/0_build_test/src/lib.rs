//! # Build test
//!
//! No ray yet: red grows to the right and green grows downwards. If this
//! picture appears, toolchain and viewer work, and the rest will too.

use common::rtweekend::*;

/// Returns a square of `width` × `width` pixels: red grows to the right, green
/// downwards, so the upper left is black and the lower right yellow.
pub fn picture(width: u32) -> Picture {
    // The last column and row are full red and full green, so there is one step
    // less than there are pixels. A picture of a single pixel stays black.
    let last = f64::from((width - 1).max(1));
    Picture::paint(width, width, move |i, j| {
        Color::new(f64::from(i) / last, f64::from(j) / last, 0.0)
    })
}
