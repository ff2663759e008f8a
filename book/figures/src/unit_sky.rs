//! Where the blend of the sky begins and ends.

use common::rtweekend::*;
use glam::DVec2;

use crate::figure::Figure;
use crate::plane::Plane;
use crate::svg::{Anchor, Svg};

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
    name: "unit_sky",
    title: "From the direction of a ray to the blue of the sky",
    description: "Seen from the side: three rays leave the eye through the top, the middle and the \
        bottom of the viewport. Cut to length 1 they end on a circle. The height of each end leads \
        across to a scale from white, a = 0, to blue, a = 1. The topmost and the lowest ray reach \
        neither end of the scale.",
    caption: "The height *y* of the unit direction, from −1 to 1, becomes *a* = ½(*y* + 1), the share of \
        blue. No ray of this picture is steep enough for *a* = 0 or *a* = 1: they would point straight \
        down and up.",
    draw,
};

/// Draws the rays from the side, and the scale of the sky.
fn draw() -> String {
    let camera = Camera::new(400);
    let mut svg = FIGURE.sheet(400.0, 300.0);
    let plane = Plane::new(56.0, 150.0, 118.0);
    let x = 288.0;
    arc(&mut svg, &plane);
    scale(&mut svg, &plane, x);
    svg.line(
        "viewport bold",
        plane.point(Vec3::new(1.0, 1.0, 0.0)),
        plane.point(Vec3::new(1.0, -1.0, 0.0)),
    );
    svg.label(
        "viewport",
        plane.point(Vec3::new(1.0, 1.0, 0.0)) + DVec2::new(0.0, -10.0),
        Anchor::Middle,
        "viewport",
    );

    let bottom = camera.image_height - 1;
    for row in [0, bottom / 2, bottom] {
        let ray = camera.ray(camera.image_width / 2, row);
        let unit = ray.direction.normalize();
        let tip = plane.point(from_the_side(unit));
        svg.line("ray dashed", tip, plane.point(from_the_side(ray.direction)));
        svg.arrow("ray bold", plane.origin, tip);
        svg.line("ink dashed", tip, DVec2::new(x, tip.y));
        let words = format!("*a* = {:.3}", share_of_blue(&ray));
        svg.label(
            "ink",
            DVec2::new(x + 36.0, tip.y + 5.0),
            Anchor::Start,
            &words,
        );
    }
    svg.circle("ink solid", plane.origin, 5.0);
    svg.label(
        "ink",
        plane.origin + DVec2::new(-10.0, 5.0),
        Anchor::End,
        "eye",
    );
    svg.finish()
}

/// The share of blue that `ray` gets: how far `sky` went from white to blue, in
/// red, where the way is ½ long.
fn share_of_blue(ray: &Ray) -> f64 {
    (1.0 - sky(ray).x) / 0.5
}

/// The front half of the circle on which unit directions end.
fn arc(svg: &mut Svg, plane: &Plane) {
    let points: Vec<DVec2> = (-90..=90)
        .step_by(3)
        .map(|degrees| {
            let (y, x) = f64::from(degrees).to_radians().sin_cos();
            plane.point(Vec3::new(x, y, 0.0))
        })
        .collect();
    svg.path("faint dashed", &points);
    svg.small_label(
        "faint",
        points[points.len() / 8] + DVec2::new(-6.0, 18.0),
        Anchor::Start,
        "length 1",
    );
}

/// The sky from straight down to straight up.
fn scale(svg: &mut Svg, plane: &Plane, x: f64) {
    const STEPS: i32 = 40;
    let step = 2.0 / f64::from(STEPS);
    svg.group("pixels", |svg| {
        for n in 0..STEPS {
            let y = -1.0 + step * (f64::from(n) + 0.5);
            let direction = Vec3::new(0.0, y, -(1.0 - y * y).sqrt());
            let mut rgb = [0; 3];
            write_color(&mut rgb, sky(&Ray::new(Point3::ZERO, direction)));
            let corner = DVec2::new(x, plane.point(Vec3::new(0.0, y + 0.5 * step, 0.0)).y);
            svg.pixel(corner, DVec2::new(26.0, plane.scale * step), rgb);
        }
    });
    let top = DVec2::new(x, plane.origin.y - plane.scale);
    svg.rect("faint thin", top, DVec2::new(26.0, 2.0 * plane.scale));
    for (y, words) in [(1.0, "1, straight up"), (-1.0, "0, straight down")] {
        let at = DVec2::new(x + 13.0, plane.origin.y - y * (plane.scale + 12.0) + 4.0);
        svg.small_label("faint", at, Anchor::Middle, words);
    }
}

/// Takes −z, where the camera looks, to the right.
fn from_the_side(vector: Vec3) -> Vec3 {
    Vec3::new(-vector.z, vector.y, 0.0)
}
