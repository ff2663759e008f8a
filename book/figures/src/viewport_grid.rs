//! Figure 4 of the notes: the viewport and its grid of pixels.

use common::rtweekend::*;
use glam::DVec2;

use crate::figure::Figure;
use crate::plane::Plane;
use crate::svg::{Anchor, Svg, spoken};

/// The words of this figure.
pub const FIGURE: Figure = Figure {
    name: "viewport_grid",
    title: "The viewport and its grid of pixels",
    description: "A rectangle of seven by five squares, each with a point in its center. Q is the \
        upper left corner of the rectangle. The vector V u runs from Q along the whole upper edge, \
        V v along the whole left edge, downwards. The point in the first square is P 0 0. From \
        there Δu leads to the point on its right, Δv to the point below.",
    caption: "A picture of 7 × 5 pixels on its viewport. **Q** is a corner of the viewport, **P**₀₀ the \
        center of a pixel: half a step right and half a step down from **Q**. Rows run downwards, \
        where *y* runs up, so Δ**v** points along −*y*.",
    draw: || draw(&Parameters::default()),
};

/// What can be changed.
#[derive(Clone, Copy, Debug)]
pub struct Parameters {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

impl Default for Parameters {
    fn default() -> Self {
        Self {
            width: 7,
            height: 5,
        }
    }
}

/// Draws the grid with its points and vectors.
pub fn draw(&Parameters { width, height }: &Parameters) -> String {
    let camera = Camera::with_size(width, height);
    let (delta_u, delta_v) = (camera.pixel_delta_u, camera.pixel_delta_v);
    let q = camera.pixel00 - 0.5 * (delta_u + delta_v);
    let (viewport_u, viewport_v) = (f64::from(width) * delta_u, f64::from(height) * delta_v);
    let scale = 288.0 / viewport_u.x;
    let plane = Plane::new(84.0 - scale * q.x, 40.0 + scale * q.y, scale);
    let at = |point| plane.point(point);

    let mut svg = FIGURE.sheet(400.0, 340.0);
    grid(&mut svg, &camera, &plane);

    svg.arrow("viewport bold", at(q), at(q + viewport_u));
    svg.arrow("viewport bold", at(q), at(q + viewport_v));
    svg.circle("viewport solid", at(q), 5.0);
    let label = |svg: &mut Svg, idea, point: Point3, (x, y), anchor, text: &str| {
        svg.label(idea, at(point) + DVec2::new(x, y), anchor, text);
    };
    label(&mut svg, "viewport", q, (-8.0, -8.0), Anchor::End, "**Q**");
    let middle = q + 0.5 * viewport_u;
    label(
        &mut svg,
        "viewport",
        middle,
        (0.0, -10.0),
        Anchor::Middle,
        "**V**_{u}",
    );
    let middle = q + 0.5 * viewport_v;
    label(
        &mut svg,
        "viewport",
        middle,
        (-12.0, 4.0),
        Anchor::End,
        "**V**_{v}",
    );

    let first = camera.pixel00;
    svg.arrow("ray bold", at(first), at(first + delta_u));
    svg.arrow("ray bold", at(first), at(first + delta_v));
    svg.circle("ink solid", at(first), 5.0);
    let (u, v) = (first + 0.5 * delta_u, first + delta_v);
    label(&mut svg, "ray", u, (0.0, -6.0), Anchor::Middle, "Δ**u**");
    label(&mut svg, "ray", v, (8.0, -6.0), Anchor::Start, "Δ**v**");
    let beside = DVec2::new(at(q).x - 10.0, at(first).y);
    svg.line("faint dashed", beside, at(first) - DVec2::new(5.0, 0.0));
    svg.label(
        "ink",
        beside + DVec2::new(-4.0, 5.0),
        Anchor::End,
        "**P**_{00}",
    );

    numbers(
        &mut svg,
        &[
            ("viewport", "**V**_{u}", viewport_u),
            ("viewport", "**V**_{v}", viewport_v),
            ("viewport", "**Q**", q),
            ("ray", "Δ**u**", delta_u),
            ("ray", "Δ**v**", delta_v),
            ("ink", "**P**_{00}", first),
        ],
    );
    svg.finish()
}

/// The edges of all pixels, and the centers.
fn grid(svg: &mut Svg, camera: &Camera, plane: &Plane) {
    let corner = camera.pixel00 - 0.5 * (camera.pixel_delta_u + camera.pixel_delta_v);
    let at = |i: u32, j: u32| {
        plane.point(
            corner + f64::from(i) * camera.pixel_delta_u + f64::from(j) * camera.pixel_delta_v,
        )
    };
    let (width, height) = (camera.image_width, camera.image_height);
    svg.rect("viewport wash", at(0, 0), at(width, height) - at(0, 0));
    for i in 0..=width {
        svg.line("faint thin", at(i, 0), at(i, height));
    }
    for j in 0..=height {
        svg.line("faint thin", at(0, j), at(width, j));
    }
    for j in 0..height {
        for i in 0..width {
            svg.circle("faint solid", plane.point(camera.ray(i, j).at(1.0)), 2.5);
        }
    }
}

/// The vectors in numbers, below the grid in two columns.
fn numbers(svg: &mut Svg, vectors: &[(&str, &str, Vec3)]) {
    for ((idea, name, vector), place) in vectors.iter().zip(0..) {
        let at = DVec2::new(
            84.0 + 152.0 * f64::from(place / 3),
            278.0 + 24.0 * f64::from(place % 3),
        );
        svg.label(
            idea,
            at,
            Anchor::Start,
            &format!("{name} = {}", triple(*vector)),
        );
    }
}

fn triple(vector: Vec3) -> String {
    let [x, y, z] = vector.to_array().map(spoken);
    format!("({x}, {y}, {z})")
}
