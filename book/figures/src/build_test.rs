//! Figure 1 of the notes: the build test.

use glam::DVec2;

use crate::figure::Figure;
use crate::pixels::Frame;
use crate::svg::Anchor;

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
    let mut svg = FIGURE.sheet(400.0, 270.0);
    let side = 192.0;
    let frame = Frame {
        corner: DVec2::new(112.0, 46.0),
        side: side / f64::from(WIDTH),
    };
    let picture = build_test::picture(WIDTH);
    frame.draw(&mut svg, &picture);

    let corner = frame.corner;
    let over = corner - DVec2::new(0.0, 14.0);
    svg.arrow("ink line", over, over + DVec2::new(side, 0.0));
    svg.label(
        "ink",
        over + DVec2::new(0.5 * side, -8.0),
        Anchor::Middle,
        "column *i*, more red",
    );
    let beside = corner - DVec2::new(14.0, 0.0);
    svg.arrow("ink line", beside, beside + DVec2::new(0.0, side));
    svg.label(
        "ink",
        beside + DVec2::new(-8.0, 0.5 * side - 4.0),
        Anchor::End,
        "row *j*,",
    );
    svg.label(
        "ink",
        beside + DVec2::new(-8.0, 0.5 * side + 14.0),
        Anchor::End,
        "more green",
    );

    let last = (WIDTH - 1) as usize;
    for (i, j, x, y, anchor) in [
        (0, last, 0.0, side + 20.0, Anchor::Start),
        (last, last, side, side + 20.0, Anchor::End),
        (last, 0, side + 10.0, 18.0, Anchor::Start),
    ] {
        let at = 3 * (j * WIDTH as usize + i);
        let [red, green, blue] = [0, 1, 2].map(|k| picture.rgb()[at + k]);
        let words = format!("{red} {green} {blue}");
        svg.small_label("ink", corner + DVec2::new(x, y), anchor, &words);
    }
    svg.finish()
}
