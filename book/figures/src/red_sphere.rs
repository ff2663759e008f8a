//! Figure 6 of the notes: the red sphere.

use red_sphere::hit_sphere;

use crate::vocabulary::*;

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
    name: "red_sphere",
    title: "The red sphere in large pixels",
    description: "The red sphere in front of the sky, in a picture only 24 pixels wide. A circle \
        is drawn where the sphere ends for the eye, and a dot in each pixel near it. The pixels \
        whose dot lies inside the circle are red, all others show the sky.",
    caption: "One ray for each pixel, through its center, decides for the whole pixel: red if it \
        hits. The circle is the exact outline. A pixel is red where its dot lies inside.",
    draw,
};

/// The width of the picture in pixels.
const WIDTH: u32 = 24;

/// Draws the picture, the outline of the sphere, and the rays near the outline.
fn draw() -> String {
    let mut svg = FIGURE.sheet(250.0);
    let camera = Camera::new(WIDTH);
    let frame = Frame::new(8.0, 8.0, 384.0 / f64::from(WIDTH));
    let picture = red_sphere::picture(WIDTH);
    frame.draw(&mut svg, &picture);

    let viewport = frame.viewport(&camera);
    let (middle, radius) = (viewport.origin, viewport.scale * outline());
    for j in 0..camera.image_height {
        for i in 0..WIDTH {
            let ray = camera.ray(i, j);
            let dot = viewport.point(ray.at(1.0));
            if (dot.distance(middle) - radius).abs() < 1.6 * frame.side {
                let hits = hit_sphere(CENTER, RADIUS, &ray);
                svg.circle(mark(hits), dot, 2.4);
            }
        }
    }
    svg.circle("black line", middle, radius);

    // On the colors of the picture, as there.
    let (pixels, _) = picture.rgb().as_chunks();
    let half = pixels.len() / 2;
    for (corner, n, hits, words) in [
        (spot(8.0, 224.0), half, true, "the ray hits"),
        (spot(140.0, 224.0), 0, false, "it misses"),
    ] {
        svg.pixel(corner, DVec2::splat(18.0), pixels[n]);
        svg.circle(mark(hits), corner + 9.0, 3.0);
        svg.label("ink", corner + spot(26.0, 14.0), Start, words);
    }
    svg.finish()
}

/// How the middle of a pixel is marked whose ray hits, or misses.
fn mark(hits: bool) -> &'static str {
    if hits { "black solid" } else { "black dot" }
}

/// The sphere of chapter 2.
const CENTER: Point3 = Point3::new(0.0, 0.0, -1.0);
const RADIUS: f64 = 0.5;

/// How far from the middle of the viewport a ray just still hits: the tangent of the angle
/// whose sine is the radius, since the center is at distance 1.
fn outline() -> f64 {
    RADIUS / (1.0 - RADIUS * RADIUS).sqrt()
}
