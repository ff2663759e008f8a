//! Figure 6 of the notes: the red sphere.

use common::rtweekend::*;
use glam::DVec2;
use red_sphere::hit_sphere;

use crate::figure::Figure;
use crate::pixels::Frame;
use crate::svg::Anchor;

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
    let mut svg = FIGURE.sheet(400.0, 250.0);
    let camera = Camera::new(WIDTH);
    let frame = Frame {
        corner: DVec2::new(8.0, 8.0),
        side: 384.0 / f64::from(WIDTH),
    };
    let picture = red_sphere::picture(WIDTH);
    frame.draw(&mut svg, &picture);

    let middle = frame.seen(&camera, CENTER);
    let radius = outline() * frame.side / camera.pixel_delta_u.x;
    for j in 0..camera.image_height {
        for i in 0..WIDTH {
            let ray = camera.ray(i, j);
            let dot = frame.seen(&camera, ray.at(1.0));
            if (dot.distance(middle) - radius).abs() < 1.6 * frame.side {
                let class = if hit_sphere(CENTER, RADIUS, &ray) {
                    "solid"
                } else {
                    "dot"
                };
                svg.circle(&format!("black {class}"), dot, 2.4);
            }
        }
    }
    svg.circle("black line", middle, radius);

    let y = 8.0 + frame.side * f64::from(camera.image_height) + 8.0;
    // On the colors of the picture, as there.
    let rgb = |i, j| picture.rgb().as_chunks::<3>().0[j * WIDTH as usize + i];
    let center = (WIDTH as usize / 2, camera.image_height as usize / 2);
    for (x, rgb, class, words) in [
        (8.0, rgb(center.0, center.1), "solid", "the ray hits"),
        (140.0, rgb(0, 0), "dot", "it misses"),
    ] {
        svg.pixel(DVec2::new(x, y), DVec2::splat(18.0), rgb);
        svg.group("black", |svg| {
            svg.circle(class, DVec2::new(x, y) + 9.0, 3.0);
        });
        svg.label("ink", DVec2::new(x + 26.0, y + 14.0), Anchor::Start, words);
    }
    svg.finish()
}

/// The sphere of chapter 2.
const CENTER: Point3 = Point3::new(0.0, 0.0, -1.0);
const RADIUS: f64 = 0.5;

/// How far from the middle of the viewport a ray just still hits, by halving.
fn outline() -> f64 {
    let (mut hits, mut misses) = (0.0, 1.0);
    for _ in 0..50 {
        let between = 0.5 * (hits + misses);
        let ray = Ray::new(Point3::ZERO, Vec3::new(between, 0.0, -1.0));
        if hit_sphere(CENTER, RADIUS, &ray) {
            hits = between;
        } else {
            misses = between;
        }
    }
    hits
}
