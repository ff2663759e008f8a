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
            from_inside: Ray::new(Point3::new(-0.55, -0.65, 0.0), Vec3::X),
        }
    }
}

/// Where the left of the two spheres is on the sheet, and where the right one.
pub const PLANES: [Plane; 2] = [
    Plane::new(98.0, 180.0, 64.0),
    Plane::new(302.0, 180.0, 64.0),
];

/// Where a ray meets the sphere.
pub fn hit(ray: &Ray) -> Option<HitRecord> {
    Sphere::new(Point3::ZERO, 1.0).hit(ray, 0.0, f64::INFINITY)
}

/// The sphere has radius 1 around the origin: a point of it is the normal there that points
/// out.
pub fn outward(record: &HitRecord) -> Vec3 {
    record.point
}

/// Draws both ways side by side.
pub fn draw(parameters: &Parameters) -> String {
    let mut svg = FIGURE.sheet(400.0, 328.0);
    let titles = [("outward", false), ("against the ray", true)];
    for (plane, (title, against)) in PLANES.iter().zip(titles) {
        let above = DVec2::new(plane.origin.x, 22.0);
        svg.label("ink", above, Anchor::Middle, title);
        svg.circle("sphere area", plane.origin, plane.scale);
        // No normal reaches so far up, nor so far down.
        for (ray, y) in [
            (parameters.from_outside, 46.0),
            (parameters.from_inside, 318.0),
        ] {
            let words = meet(&mut svg, plane, &ray, against);
            let place = DVec2::new(plane.origin.x, y);
            svg.small_label("ink", place, Anchor::Middle, &words);
        }
    }
    svg.line(
        "grid thin",
        DVec2::new(200.0, 12.0),
        DVec2::new(200.0, 316.0),
    );
    svg.finish()
}

/// Draws a ray, and the normal where it meets the sphere; returns what there is to say.
fn meet(svg: &mut Svg, plane: &Plane, ray: &Ray, against: bool) -> String {
    let origin = plane.point(ray.origin);
    svg.circle("ray solid", origin, 3.5);
    svg.label(
        "ray",
        origin + DVec2::new(12.0, -8.0),
        Anchor::Middle,
        "**d**",
    );
    let Some(record) = hit(ray) else {
        svg.arrow("ray line", origin, plane.point(ray.at(0.5)));
        return "no hit".to_owned();
    };
    let normal = match against {
        true => record.normal,
        false => outward(&record),
    };
    let point = plane.point(record.point);
    let tip = plane.point(record.point + 0.6 * normal);
    svg.arrow("ray line", origin, point);
    svg.arrow("normal bold", point, tip);
    svg.circle("ink solid", point, 4.0);
    let beyond = plane.point(record.point + 0.8 * normal) + DVec2::new(0.0, 5.0);
    svg.label("normal", beyond, Anchor::Middle, "**n**");
    match against {
        true => format!("front_face = {}", record.front_face),
        false => format!("**d**·**n** {} 0", sign(ray.direction.dot(normal))),
    }
}

/// How a number stands to 0.
fn sign(value: f64) -> char {
    match value {
        ..0.0 => '<',
        0.0 => '=',
        _ => '>',
    }
}
