//! What the discriminant measures: how near a line passes.

use normals::hit_sphere;

use crate::vocabulary::*;

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
    let (center, radius) = (xy(2.75, 0.5), 1.15);
    let ray = Ray::new(Point3::ZERO, 2.0 * Vec3::X);
    let mut svg = FIGURE.sheet(250.0);
    let plane = Plane::new(30.0, 150.0, 82.0);
    let foot = ray.at(nearest(&ray, center));
    let [q, c, foot] = [ray.origin, center, foot].map(|it| plane.point(it));
    svg.circle("sphere area", c, plane.scale * radius);
    svg.arrow("ray line", q, plane.point(xy(4.3, 0.0)));
    svg.line("sphere line", q, c);
    svg.line("faint dashed", c, foot);
    svg.right_angle(foot, DVec2::NEG_X, DVec2::NEG_Y);
    if let Some(t) = hit_sphere(center, radius, &ray) {
        let entry = plane.point(ray.at(t));
        svg.line("sphere line", c, entry);
        svg.circle("ray hollow", entry, 5.0);
        svg.label("sphere", 0.5 * (c + entry), LowerRight, "*r*");
        svg.label("ink", foot + spot(2.0, 20.0), End, "√(*r*² − *l*²)");
    }
    svg.dot("sphere", c, UpperRight, "**C**");
    svg.dot("ray", q, Below, "**Q**");
    svg.label("ink", 0.5 * (c + foot), Right, "*l*");
    svg.label("sphere", 0.5 * (q + c), UpperLeft, "**C** − **Q**");
    svg.finish()
}
