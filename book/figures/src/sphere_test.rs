//! Equation (6) as a picture: a cut through the sphere.

use crate::vocabulary::*;

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
    name: "sphere_test",
    title: "Equation (6), asked at each pixel",
    description: "The picture in large pixels. In its middle there is a red disc inside of a circle. \
        Around it everything is gray, the darker the nearer to the disc, and nearly white in the \
        corners.",
    caption: "The left side of (6), with the place of each pixel on the viewport for **P**. Darker \
        means less; red is where it is at most *r*². The viewport cuts through the middle of \
        the sphere, so the red places fill a circle of radius r.",
    draw,
};

/// The width of the picture in pixels.
const WIDTH: u32 = 48;

/// Draws the picture, and the circle in which the viewport cuts the sphere.
fn draw() -> String {
    let radius = 0.5;
    let mut svg = FIGURE.sheet(232.0);
    let camera = Camera::new(WIDTH);
    let center = Point3::new(0.0, 0.0, -1.0);
    let left_side = move |i, j| (center - camera.ray(i, j).at(1.0)).length_squared();
    let most = left_side(0, 0);
    let picture = Picture::paint(WIDTH, camera.image_height, move |i, j| {
        if left_side(i, j) <= radius * radius {
            Color::new(1.0, 0.0, 0.0)
        } else {
            left_side(i, j) / most * Color::ONE
        }
    });
    let frame = Frame::new(8.0, 8.0, 384.0 / f64::from(WIDTH));
    frame.draw(&mut svg, &picture);
    let Plane { origin, scale } = frame.viewport(&camera);
    svg.circle("black line", origin, scale * radius);
    svg.finish()
}
