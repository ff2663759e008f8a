use common::rtweekend::*;

/// Returns a square of `width` × `width` pixels: red grows to the right, green
/// downwards, so the upper left is black and the lower right yellow.
pub fn picture(width: u32) -> Picture {
    // The last column and row are full red and full green, so there is one step
    // less than there are pixels. A picture of a single pixel stays black.
    let last = f64::from((width - 1).max(1));
    Picture::paint(width, width, move |i, j| {
        todo!()
    })
}
