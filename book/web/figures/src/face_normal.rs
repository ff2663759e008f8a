//! Figure 9 of the notes: two ways to direct a normal. The origin of the ray moves through
//! the surface.

use hittable_list::{HitRecord, Hittable, Sphere};

use crate::prelude::*;
use crate::traced::sphere_lines;

parameters! {
    origin: Point3 =
        Parameter::new("Origin, to the right", -1.4, 1.0, -0.55),
        Parameter::new("Origin, upwards", -1.3, 1.4, -0.65);
}

/// The live figure: a ray whose origin a reader moves, and both ways to direct the normal.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: figure!("face_normal"),
    handles: &[point!(PLANES[0], origin), point!(PLANES[1], origin)],
    actions: &[
        ("From inside", |it| it.origin = xy(-0.55, -0.65)),
        ("From outside", |it| it.origin = xy(-1.4, -0.65)),
        ("A graze", |it| it.origin = xy(-1.2, -1.0)),
    ],
    answer,
};

fn answer(&Parameters { origin }: &Parameters) -> DrawnFigure {
    let ray = Ray::new(origin, Vec3::X);
    let lines = sphere_lines(Point3::ZERO, 1.0, &ray);
    DrawnFigure::new(draw(&ray), sentence(&ray), lines)
}

fn sentence(ray: &Ray) -> String {
    let Some(record) = hit(ray) else {
        return "This ray does not meet the sphere: there is no normal to turn.".to_owned();
    };
    let (product, front_face) = (ray.direction.dot(record.point), record.front_face);
    if product.abs() < 1e-6 {
        return format!(
            "**d**·**n** is {}: the ray grazes. The code asks for < 0, so front_face is {front_face}.",
            printed(product)
        );
    }
    let (side, normal) = if front_face {
        ("outside", "stays")
    } else {
        ("inside", "is turned round")
    };
    format!(
        "**d**·**n** = {} with the outward normal: the ray comes from {side}, front_face is {front_face}, \
        and the normal {normal}.",
        spoken(product)
    )
}

/// The places of the left and of the right sphere on the sheet: beside each there is room for a
/// normal and its name.
const PLANES: [Plane; 2] = [
    Plane::new(102.0, 148.0, 50.0),
    Plane::new(298.0, 148.0, 50.0),
];

/// Finds where a ray meets the sphere, which has radius 1 around the origin: so a point of the
/// sphere is the outward normal there.
fn hit(ray: &Ray) -> Option<HitRecord> {
    Sphere::new(Point3::ZERO, 1.0).hit(ray, 0.0, f64::INFINITY)
}

/// Draws both ways to direct the normal, side by side.
fn draw(ray: &Ray) -> Svg {
    let mut svg = LIVE.figure.sheet(296.0);
    let titles = [("outward", false), ("against the ray", true)];
    for (plane, (title, against)) in PLANES.iter().zip(titles) {
        let at = |y| spot(plane.origin.x, y);
        svg.label("ink", at(22.0), Middle, title);
        svg.circle("sphere area", plane.origin, plane.scale);
        // No normal reaches so far up, nor so far down.
        let words = meet(&mut svg, plane, ray, against);
        svg.small_label("ink", at(286.0), Middle, &words);
    }
    svg.line("grid thin", spot(200.0, 12.0), spot(200.0, 284.0));
    svg
}

/// Draws a ray, and the normal where it meets the sphere: as set against the ray if `against`, else
/// outward. Returns the words below.
fn meet(svg: &mut Svg, plane: &Plane, ray: &Ray, against: bool) -> String {
    let origin = plane.point(ray.origin);
    svg.dot("ray", origin, UpperRight, "**d**");
    let Some(record) = hit(ray) else {
        svg.arrow("ray line", origin, plane.point(ray.at(0.5)));
        return "no hit".to_owned();
    };
    let outward = record.point;
    let normal = if against { record.normal } else { outward };
    let along = |length: f64| plane.point(record.point + length * normal);
    svg.arrow("ray line", origin, along(0.0));
    svg.arrow("normal bold", along(0.0), along(0.6));
    svg.circle("ink solid", along(0.0), 4.0);
    svg.label("normal", along(0.8).down(5.0), Middle, "**n**");
    if against {
        format!("front_face = {}", record.front_face)
    } else {
        let sign = sign(ray.direction.dot(normal), 0.0);
        format!("**d**·**n** {sign} 0")
    }
}
