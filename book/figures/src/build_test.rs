//! Figure 1 of the notes: the build test.

use crate::vocabulary::*;

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
    name: "build_test",
    title: "The build test in large pixels",
    description: "A square picture of eight by eight pixels. It is black at the upper left, red at \
        the upper right, green at the lower left and yellow at the lower right. Red grows to the \
        right with the column *i*, green grows downwards with the row j.",
    caption: "The first picture, here with 8 × 8 pixels: red grows with the column *i*, green with \
        the row *j*. If you swap the two loops, red and green change places.",
    draw,
};

/// Pixels in a row and in a column.
const WIDTH: u32 = 8;

/// Draws the picture with its corners named.
fn draw() -> String {
    let mut svg = FIGURE.sheet(270.0);
    let picture = build_test::picture(WIDTH);
    let side = 192.0;
    let frame = Frame::new(112.0, 46.0, side / f64::from(WIDTH));
    frame.draw(&mut svg, &picture);

    let at = |x, y| frame.corner + spot(x, y);
    svg.arrow("ink line", at(0.0, -14.0), at(side, -14.0));
    svg.arrow("ink line", at(-14.0, 0.0), at(-14.0, side));
    svg.label("ink", at(96.0, -22.0), Middle, "column *i*, more red");
    svg.label("ink", at(-22.0, 92.0), End, "row *j*,");
    svg.label("ink", at(-22.0, 110.0), End, "more green");

    let (pixels, _) = picture.rgb().as_chunks();
    for (pixel, words, anchor) in [
        (56, at(0.0, side + 20.0), Start),
        (63, at(side, side + 20.0), End),
        (7, at(side + 10.0, 18.0), Start),
    ] {
        let [red, green, blue]: [u8; 3] = pixels[pixel];
        svg.small_label("ink", words, anchor, &format!("{red} {green} {blue}"));
    }
    svg.finish()
}
