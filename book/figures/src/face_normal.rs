//! Figure 9 of the notes: two ways to direct a normal. The origin of the lower ray moves
//! through the surface.

use common::rtweekend::*;
use glam::DVec2;
use hittable_list::{HitRecord, Hittable, Sphere};
use slips::Ball;

use crate::figure::Figure;
use crate::live::{Action, Answer, Handle, Live, Number, parameters};
use crate::number::{printed, spoken};
use crate::plane::Plane;
use crate::svg::{Anchor, Svg};
use crate::traced::sphere_lines;

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
    name: "face_normal",
    title: "Normals that point outward, and normals against the ray",
    description: "Two spheres, each met by one ray from outside and by one from inside. At the \
        left both normals point out of the sphere: the ray from inside runs along with its normal. \
        At the right each normal points against its ray: the one from inside points into the \
        sphere, and front_face is false there.",
    caption: "Left: the normal always points outward, and the sign of **d**·**n** says from which side the \
        ray came. Right, and in our code: it always points against the ray, and front_face keeps the side.",
    draw: || LIVE.on_page(),
};

parameters! {
    x: Number::new("Origin, to the right", -1.4, 1.0, -0.55),
    y: Number::new("Origin, upwards", -1.3, 1.4, -0.65),
}

/// The figure, as a reader moves it.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: FIGURE,
    question: "When does the normal at the right turn round? Drag the origin of the lower ray out of \
        the sphere, and then to where the ray only grazes it.",
    solution: "When the ray comes from inside: then the outward normal and the ray point the same way. A graze \
        counts as inside, since its product is 0, not less than 0.",
    handles: &[
        Handle::new(&["x", "y"], |it, to| {
            [it.x, it.y, _] = PLANES[0].place(to).to_array();
        }),
        Handle::new(&["x", "y"], |it, to| {
            [it.x, it.y, _] = PLANES[1].place(to).to_array();
        }),
    ],
    actions: &[
        Action::new("From inside", |it| *it = Parameters { x: -0.55, y: -0.65 }),
        Action::new("From outside", |it| *it = Parameters { x: -1.4, y: -0.65 }),
        Action::new("A graze", |it| *it = Parameters { x: -1.2, y: -1.0 }),
    ],
    answer,
};

fn answer(&Parameters { x, y }: &Parameters) -> Answer {
    let ray = Ray::new(Point3::new(x, y, 0.0), Vec3::X);
    let found = hit(&ray).map(|record| (ray.direction.dot(outward(&record)), record.front_face));
    let sentence = match found {
        None if (ray.origin.length() - 1.0).abs() < 1e-9 => {
            "This ray starts on the sphere and leaves it. There *t* is 0, and only more than that counts: \
            a surface does not meet what comes from it."
                .to_owned()
        }
        None if x < 0.0 && y.abs() == 1.0 => {
            "This ray only touches the sphere, and rounding makes a miss of it.".to_owned()
        }
        None => "This ray does not meet the sphere: there is no normal to turn.".to_owned(),
        Some((0.0, _)) => {
            "**d**·**n** is exactly 0: the ray grazes. The code asks for < 0, so front_face is \
            false."
                .to_owned()
        }
        Some((product, front_face)) if product.abs() < 1e-6 => format!(
            "**d**·**n** should be 0, as the ray grazes. Rounding makes {} of it, so front_face is \
            {front_face}.",
            printed(product)
        ),
        Some((product, true)) => format!(
            "**d**·**n** = {} with the outward normal: the ray comes from outside, front_face is true, and \
            the normal stays.",
            spoken(product)
        ),
        Some((product, false)) => format!(
            "**d**·**n** = {} with the outward normal: the ray comes from inside, front_face is false, and \
            the normal is turned round.",
            spoken(product)
        ),
    };
    Answer {
        drawing: draw(&ray),
        sentence,
        handles: PLANES.map(|plane| plane.point(ray.origin)).into(),
        says: sphere_lines(&Ball::new(0.0, 0.0, 0.0, 1.0), &ray),
    }
}

/// Where the left of the two spheres is on the sheet, and where the right one.
const PLANES: [Plane; 2] = [
    Plane::new(98.0, 180.0, 64.0),
    Plane::new(302.0, 180.0, 64.0),
];

/// Where a ray meets the sphere.
fn hit(ray: &Ray) -> Option<HitRecord> {
    Sphere::new(Point3::ZERO, 1.0).hit(ray, 0.0, f64::INFINITY)
}

/// The sphere has radius 1 around the origin: a point of it is the normal there that points
/// out.
fn outward(record: &HitRecord) -> Vec3 {
    record.point
}

/// A ray that comes from outside.
fn from_outside() -> Ray {
    Ray::new(Point3::new(-1.45, 0.9, 0.0), Vec3::new(1.0, -0.13, 0.0))
}

/// Draws both ways side by side.
fn draw(lower: &Ray) -> Svg {
    let mut svg = FIGURE.sheet(400.0, 328.0);
    let titles = [("outward", false), ("against the ray", true)];
    for (plane, (title, against)) in PLANES.iter().zip(titles) {
        let above = DVec2::new(plane.origin.x, 22.0);
        svg.label("ink", above, Anchor::Middle, title);
        svg.circle("sphere area", plane.origin, plane.scale);
        // No normal reaches so far up, nor so far down.
        for (ray, y) in [(&from_outside(), 46.0), (lower, 318.0)] {
            let words = meet(&mut svg, plane, ray, against);
            let place = DVec2::new(plane.origin.x, y);
            svg.small_label("ink", place, Anchor::Middle, &words);
        }
    }
    svg.line(
        "grid thin",
        DVec2::new(200.0, 12.0),
        DVec2::new(200.0, 316.0),
    );
    svg
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
