//! Changes of pictures, as a reader's program or viewer may make them.

use common::rtweekend::Picture;

/// Returns the picture as it is.
pub(super) fn same(picture: &Picture) -> Picture {
    changed(picture, |_, _, color| color)
}

/// Changes so many pixels, spread over the picture.
pub(super) fn odd<const COUNT: u32>(picture: &Picture) -> Picture {
    let total = picture.width() * picture.height();
    let is_odd = |n: u32| (0..COUNT).any(|k| n == (k * 2_654_435 + 77) % total);
    let width = picture.width();
    changed(picture, |i, j, [r, g, b]| {
        if is_odd(j * width + i) {
            [r ^ 0x5a, g ^ 0x33, b ^ 0x11]
        } else {
            [r, g, b]
        }
    })
}

/// Blackens the eighth row.
pub(super) fn row(picture: &Picture) -> Picture {
    changed(picture, |_, j, color| if j == 7 { [0; 3] } else { color })
}

/// Paints a green box of 8 × 8 pixels.
pub(super) fn green_box(picture: &Picture) -> Picture {
    let is_in = |n: u32, from: u32| (from..from + 8).contains(&n);
    changed(picture, |i, j, color| {
        if is_in(i, 30) && is_in(j, 20) {
            [0, 255, 0]
        } else {
            color
        }
    })
}

/// Blackens all pixels.
pub(super) fn black(picture: &Picture) -> Picture {
    changed(picture, |_, _, _| [0; 3])
}

/// Takes the colors away.
pub(super) fn gray(picture: &Picture) -> Picture {
    changed(picture, |_, _, color| {
        let sum: u16 = color.into_iter().map(u16::from).sum();
        [(sum / 3) as u8; 3]
    })
}

/// Swaps left and right.
pub(super) fn mirrored(picture: &Picture) -> Picture {
    let width = picture.width();
    changed(picture, |i, j, _| pixel(picture, width - 1 - i, j))
}

/// Paints a red ellipse near the middle.
pub(super) fn ellipse(picture: &Picture) -> Picture {
    changed(picture, |i, j, color| {
        let (x, y) = (f64::from(i) - 44.5, f64::from(j) - 24.5);
        if (x / 15.0).hypot(y / 7.0) < 1.0 {
            [255, 0, 0]
        } else {
            color
        }
    })
}

/// Shifts the picture up by a row.
pub(super) fn raised(picture: &Picture) -> Picture {
    let last = picture.height() - 1;
    changed(picture, |i, j, _| pixel(picture, i, last.min(j + 1)))
}

/// Mixes the two colors at each edge, as several rays through a pixel do.
pub(super) fn smoothed(picture: &Picture) -> Picture {
    let last = picture.width() - 1;
    changed(picture, |i, j, color| {
        let next = pixel(picture, last.min(i + 1), j);
        let is_edge = (0..3).any(|c| color[c].abs_diff(next[c]) > 40);
        let mean = |c: usize| color[c].midpoint(next[c]);
        if is_edge { [0, 1, 2].map(mean) } else { color }
    })
}

/// Makes a picture of the same size, pixel by pixel from column, row and color.
fn changed(picture: &Picture, change: impl Fn(u32, u32, [u8; 3]) -> [u8; 3]) -> Picture {
    let (width, height) = (picture.width(), picture.height());
    let places = (0..height).flat_map(|j| (0..width).map(move |i| (i, j)));
    let rgb = places.flat_map(|(i, j)| change(i, j, pixel(picture, i, j)));
    Picture::from_rgb(width, height, rgb.collect()).expect("its size")
}

/// Returns the color at a column and a row.
fn pixel(picture: &Picture, i: u32, j: u32) -> [u8; 3] {
    picture.rgb().as_chunks().0[(j * picture.width() + i) as usize]
}
