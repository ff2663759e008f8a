//! Figure 7 of the notes: the normal of a sphere.

use common::rtweekend::*;
use glam::DVec2;
use normals::hit_sphere;

use crate::figure::Figure;
use crate::plane::Plane;
use crate::svg::Anchor;

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
    name: "normal",
    title: "The normal of a sphere",
    description: "A ray comes from the left and hits a sphere with center C in a point P. A dashed \
        radius leads from C to P. The normal n goes on in the same direction, out of the sphere, \
        and is one unit long. It stands upright on a short line that touches the sphere in P.",
    caption: "The outward normal is the way from the center to the point that was hit: **P** − **C**. \
        That way is *r* long, so **n** = (**P** − **C**)/*r* has length 1.",
    draw,
};

/// The sphere, and a ray that hits it, in the plane of x and y.
const CENTER: Point3 = Point3::ZERO;
const RADIUS: f64 = 1.6;

/// Draws the sphere, and if the ray hits it, the normal.
fn draw() -> String {
    let ray = Ray::new(Point3::new(-3.1, 1.75, 0.0), Vec3::new(1.9, -0.45, 0.0));
    let mut svg = FIGURE.sheet(400.0, 300.0);
    let plane = Plane::new(235.0, 180.0, 68.0);
    let middle = plane.point(CENTER);
    svg.circle("sphere area", middle, plane.scale * RADIUS);
    svg.circle("sphere solid", middle, 4.5);
    svg.label(
        "sphere",
        middle + DVec2::new(8.0, 16.0),
        Anchor::Start,
        "**C**",
    );

    if let Some(t) = hit_sphere(CENTER, RADIUS, &ray) {
        let point = ray.at(t);
        let unit = (point - CENTER).normalize();
        let hit = plane.point(point);
        let out = plane.vector(unit).normalize();
        svg.arrow("ray line", plane.point(ray.origin), hit);
        svg.line(
            "faint dashed",
            hit - 60.0 * out.perp(),
            hit + 60.0 * out.perp(),
        );
        svg.path(
            "faint thin",
            &[9.0 * out, 9.0 * (out + out.perp()), 9.0 * out.perp()].map(|corner| hit + corner),
        );
        svg.line("sphere dashed", middle, hit);
        svg.arrow("normal bold", hit, plane.point(point + unit));
        svg.circle("ink solid", hit, 4.5);
        let half = 0.5 * (middle + hit);
        svg.label(
            "sphere",
            half + DVec2::new(8.0, -4.0),
            Anchor::Start,
            "**P** − **C**, *r* long",
        );
        let tip = plane.point(point + unit);
        svg.label(
            "normal",
            tip + DVec2::new(12.0, 4.0),
            Anchor::Start,
            "**n** = (**P** − **C**)/*r*",
        );
        svg.label("ink", hit + DVec2::new(2.0, 26.0), Anchor::Middle, "**P**");
    }
    let start = plane.point(ray.origin);
    svg.label("ray", start + DVec2::new(4.0, 24.0), Anchor::Start, "ray");
    svg.finish()
}
