//! h as the projection of C − Q on d, and the discriminant as the way from there to the roots.

use common::rtweekend::*;
use glam::DVec2;
use normals::hit_sphere;

use crate::figure::Figure;
use crate::plane::Plane;
use crate::roots::roots;
use crate::svg::{Anchor, Svg};

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
    name: "projection",
    title: "What h and the discriminant measure",
    description: "A ray starts at Q and passes through a sphere with center C. The vector oc leads \
        from Q to C. A dashed line from C meets the ray at a right angle, h along the ray from Q. \
        From there it is the root of the discriminant back to the nearer root, and as far on to \
        the farther one.",
    caption: "With **d** of length 1, *h* = **d**·(**C** − **Q**) is how far along the ray **C** is passed, and the root \
        of *h*² − *ac* is half of the way inside the sphere: the roots are as far before that point as \
        behind it.",
    draw,
};

/// Draws the triangle of Q, C and the point of the ray that is nearest to C.
fn draw() -> String {
    let (center, radius) = (Point3::new(2.6, 0.6, 0.0), 1.0);
    // With a direction of length 1, h is a length.
    let ray = Ray::new(Point3::ZERO, Vec3::X);
    let mut svg = FIGURE.sheet(400.0, 270.0);
    let plane = Plane::new(32.0, 150.0, 86.0);
    let oc = center - ray.origin;
    let h = ray.direction.dot(oc);
    let (q, c, foot) = (plane.origin, plane.point(center), plane.point(ray.at(h)));

    svg.circle("sphere area", c, plane.scale * radius);
    svg.arrow("ray line", q, plane.point(ray.at(4.1)));
    svg.arrow("sphere line", q, c);
    svg.line("faint dashed", c, foot);
    svg.path(
        "faint thin",
        &[(-9.0, 0.0), (-9.0, -9.0), (0.0, -9.0)].map(|(x, y)| foot + DVec2::new(x, y)),
    );
    svg.circle("sphere solid", c, 4.5);
    svg.circle("ray solid", q, 4.5);
    svg.label("ink", q + DVec2::new(-10.0, -8.0), Anchor::Middle, "**Q**");
    svg.label("sphere", c + DVec2::new(8.0, -8.0), Anchor::Start, "**C**");
    svg.label(
        "sphere",
        0.4 * c + 0.6 * q + DVec2::new(-4.0, -8.0),
        Anchor::End,
        "**C** − **Q**",
    );

    if let Some(nearer) = hit_sphere(center, radius, &ray) {
        for t in roots(center, radius, &ray) {
            svg.circle("ray hollow", plane.point(ray.at(t)), 5.0);
        }
        let span = |svg: &mut Svg, from: f64, to: f64, y: f64, words: &str| {
            let down = DVec2::new(0.0, y);
            let ends = [from, to].map(|t| plane.point(ray.at(t)) + down);
            svg.line("ink line", ends[0], ends[1]);
            for end in ends {
                svg.line(
                    "ink line",
                    end - DVec2::new(0.0, 5.0),
                    end + DVec2::new(0.0, 5.0),
                );
            }
            svg.label(
                "ink",
                0.5 * (ends[0] + ends[1]) + DVec2::new(0.0, 18.0),
                Anchor::Middle,
                words,
            );
        };
        span(&mut svg, 0.0, h, 94.0, "*h*");
        span(&mut svg, nearer, h, 50.0, "√(*h*² − *ac*)");
    }
    svg.finish()
}
