//! Figure 9 of the notes: two ways to direct a normal.

use common::rtweekend::*;
use glam::DVec2;
use hittable_list::{HitRecord, Hittable, Sphere};

use crate::figure::Figure;
use crate::plane::Plane;
use crate::svg::{Anchor, Svg};

/// The words of this figure.
pub const FIGURE: Figure = Figure {
    name: "face_normal",
    title: "Normals that point outward, and normals against the ray",
    description: "Two spheres, each met by one ray from outside and by one from inside. At the \
        left both normals point out of the sphere: the ray from inside runs along with its normal. \
        At the right each normal points against its ray: the one from inside points into the \
        sphere, and front_face is false there.",
    caption: "Left: the normal always points outward, and the sign of **d**·**n** says from where the ray \
        came. Right, and in our code: it always points against the ray, and front_face remembers.",
    draw: || draw(&Parameters::default()),
};

/// What can be changed.
#[derive(Clone, Copy, Debug)]
pub struct Parameters {
    /// A ray from outside to the sphere of radius 1 at the origin, in the plane
    /// of x and y.
    pub from_outside: Ray,
    /// A ray from inside, in the same plane.
    pub from_inside: Ray,
}

impl Default for Parameters {
    fn default() -> Self {
        Self {
            from_outside: Ray::new(Point3::new(-1.45, 0.9, 0.0), Vec3::new(1.0, -0.13, 0.0)),
            from_inside: Ray::new(Point3::new(-0.55, -0.66, 0.0), Vec3::X),
        }
    }
}

/// Draws both ways side by side.
pub fn draw(parameters: &Parameters) -> String {
    let mut svg = FIGURE.sheet(400.0, 300.0);
    for (x, title, against) in [(98.0, "outward", false), (302.0, "against the ray", true)] {
        let plane = Plane::new(x, 158.0, 64.0);
        svg.label("ink", DVec2::new(x, 22.0), Anchor::Middle, title);
        svg.circle("sphere area", plane.origin, plane.scale);
        meet(&mut svg, &plane, &parameters.from_outside, against);
        meet(&mut svg, &plane, &parameters.from_inside, against);
    }
    svg.line(
        "grid thin",
        DVec2::new(200.0, 12.0),
        DVec2::new(200.0, 288.0),
    );
    svg.finish()
}

/// Draws a ray, and the normal where it meets the sphere.
fn meet(svg: &mut Svg, plane: &Plane, ray: &Ray, against: bool) {
    let sphere = Sphere::new(Point3::ZERO, 1.0);
    let Some(record) = sphere.hit(ray, 0.0, f64::INFINITY) else {
        return;
    };
    // The sphere has radius 1 around the origin: a point of it is the normal there.
    let outward = record.point;
    let normal = if against { record.normal } else { outward };
    let point = plane.point(record.point);
    svg.circle("ray solid", plane.point(ray.origin), 3.5);
    svg.arrow("ray line", plane.point(ray.origin), point);
    svg.arrow(
        "normal bold",
        point,
        plane.point(record.point + 0.6 * normal),
    );
    svg.circle("ink solid", point, 4.0);
    let start = plane.point(ray.origin) + DVec2::new(12.0, -8.0);
    svg.label("ray", start, Anchor::Middle, "**d**");
    let beyond = plane.point(record.point + 0.8 * normal) + DVec2::new(0.0, 5.0);
    svg.label("normal", beyond, Anchor::Middle, "**n**");
    let words = if against {
        format!("front_face = {}", record.front_face)
    } else {
        let sign = if ray.direction.dot(normal) < 0.0 {
            '<'
        } else {
            '>'
        };
        format!("**d**·**n** {sign} 0")
    };
    svg.small_label("ink", place(plane, &record), Anchor::Middle, &words);
}

/// Where the words of a hit stand: above the sphere for one from outside, below
/// it for one from inside.
fn place(plane: &Plane, record: &HitRecord) -> DVec2 {
    let side = if record.front_face { -1.0 } else { 1.0 };
    plane.origin + DVec2::new(0.0, 4.0 + side * (plane.scale + 42.0))
}
