//! What the discriminant measures: how near a line passes.

use common::rtweekend::*;
use glam::DVec2;
use normals::hit_sphere;

use crate::figure::Figure;
use crate::plane::Plane;
use crate::svg::Anchor;

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
    name: "passing",
    title: "The distance l at which a line passes the center",
    description: "A line starts at Q and goes through a sphere with center C. A dashed line of \
        length l leads from C to the nearest point of the line, at a right angle. From C to the \
        point where the line enters the sphere it is r, and from there to the nearest point the \
        square root of r² − l².",
    caption: "Two triangles with a right angle at *t* = *h*/*a*. The large one, with **Q**, gives *l*. \
        The small one, with the point where the line goes in, gives √(*r*² − *l*²), half of the \
        line's way through the sphere. The discriminant is the square of that, times 4*a*.",
    draw,
};

/// Draws the line, and the two triangles.
fn draw() -> String {
    let (center, radius) = (Point3::new(2.75, 0.5, 0.0), 1.15);
    let ray = Ray::new(Point3::ZERO, 2.0 * Vec3::X);
    let mut svg = FIGURE.sheet(400.0, 250.0);
    let plane = Plane::new(30.0, 150.0, 82.0);
    let nearest = ray.direction.dot(center - ray.origin) / ray.direction.length_squared();
    let (q, c, foot) = (
        plane.origin,
        plane.point(center),
        plane.point(ray.at(nearest)),
    );

    svg.circle("sphere area", c, plane.scale * radius);
    svg.arrow("ray line", q, plane.point(Point3::new(4.3, 0.0, 0.0)));
    svg.line("sphere line", q, c);
    svg.line("faint dashed", c, foot);
    svg.path(
        "faint thin",
        &[(-9.0, 0.0), (-9.0, -9.0), (0.0, -9.0)].map(|(x, y)| foot + DVec2::new(x, y)),
    );
    let middle = |from: DVec2, to: DVec2| 0.5 * (from + to);
    if let Some(t) = hit_sphere(center, radius, &ray) {
        let entry = plane.point(ray.at(t));
        svg.line("sphere line", c, entry);
        svg.circle("ray hollow", entry, 5.0);
        let beside = DVec2::new(12.0, 12.0);
        svg.label("sphere", middle(c, entry) + beside, Anchor::Start, "*r*");
        let below = foot + DVec2::new(2.0, 20.0);
        svg.label("ink", below, Anchor::End, "√(*r*² − *l*²)");
    }
    svg.circle("sphere solid", c, 4.5);
    svg.circle("ray solid", q, 4.5);
    svg.label("ink", q + DVec2::new(0.0, 24.0), Anchor::Middle, "**Q**");
    svg.label("sphere", c + DVec2::new(8.0, -8.0), Anchor::Start, "**C**");
    let beside = middle(c, foot) + DVec2::new(8.0, 5.0);
    svg.label("ink", beside, Anchor::Start, "*l*");
    let above = middle(q, c) + DVec2::new(-8.0, -8.0);
    svg.label("sphere", above, Anchor::End, "**C** − **Q**");
    svg.finish()
}
