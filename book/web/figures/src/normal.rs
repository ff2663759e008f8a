//! Figure 7 of the notes: the normal of a sphere. The ray moves, and with it the place that
//! is hit.

use normals::hit_sphere;

use crate::prelude::*;
use crate::traced::normals_lines;

parameters! {
    q: Point3 =
        Parameter::new("Q, to the right", -3.2, 2.2, -3.1),
        Parameter::new("Q, upwards", -1.6, 2.4, 1.75);
    d: Vec3 =
        Parameter::new("d, to the right", -3.0, 3.0, 1.0),
        Parameter::new("d, upwards", -2.0, 2.0, -0.25);
}

/// The live figure: a ray to be moved, and the normal where it hits a sphere.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: figure!("normal"),
    handles: &[point!(PLANE, d from q), point!(PLANE, q)],
    actions: &[
        ("At the center", |chosen| {
            (chosen.q, chosen.d) = (xy(-3.1, 0.0), Vec3::X);
        }),
        ("Past it", |it| (it.q, it.d) = (xy(-3.1, 1.75), Vec3::X)),
        ("From inside", |chosen| {
            (chosen.q, chosen.d) = (xy(-0.6, 0.5), xy(1.0, 0.25));
        }),
    ],
    answer,
};

/// The sphere in the plane of x and y, and the place of that plane on the sheet.
const CENTER: Point3 = Point3::ZERO;
const RADIUS: f64 = 1.6;
const PLANE: Plane = Plane::new(235.0, 180.0, 68.0);
const SIZE: DVec2 = spot(400.0, 300.0);

fn answer(parameters: &Parameters) -> DrawnFigure {
    let ray = ray(parameters.q, parameters.d);
    let root = hit_sphere(CENTER, RADIUS, &ray);
    let sentence = match root {
        None => "The line of the ray misses the sphere, and there is no normal.".to_owned(),
        Some(t) if t > 0.0 => {
            let (t, normal) = (spoken(t), triple(normal(ray.at(t))));
            format!("The nearer root is *t* = {t}, and there **n** = {normal}.")
        }
        Some(t) => {
            let t = spoken(t);
            format!("The nearer root is *t* = {t}: behind **Q**, so this chapter paints the sky.")
        }
    };
    let lines = normals_lines(CENTER, RADIUS, &ray);
    DrawnFigure::new(draw(&ray, root), sentence, lines)
}

/// Returns the outward normal at a point of the sphere.
fn normal(point: Point3) -> Vec3 {
    (point - CENTER).normalize()
}

/// Draws the sphere, the ray and, if there is a root, the normal at the hit.
fn draw(ray: &Ray, root: Option<f64>) -> Svg {
    let mut svg = LIVE.figure.sheet(SIZE.y);
    let middle = PLANE.point(CENTER);
    svg.circle("sphere area", middle, PLANE.scale * RADIUS);
    svg.dot("sphere", middle, LowerRight, "**C**");
    let hit = root.filter(|&t| t > 0.0);
    PLANE.draw_line(&mut svg, ray, SIZE, hit.unwrap_or(f64::INFINITY));
    PLANE.draw_ray(&mut svg, ray);
    if let Some(t) = hit {
        draw_normal(&mut svg, ray.at(t));
    }
    svg
}

/// Draws the radius to a point of the sphere, the tangent and the normal there.
fn draw_normal(svg: &mut Svg, point: Point3) {
    let unit = normal(point);
    let [middle, hit, tip] = [CENTER, point, point + unit].map(|it| PLANE.point(it));
    let out = PLANE.vector(unit).normalize();
    let along = out.perp();
    svg.line("faint dashed", hit - 60.0 * along, hit + 60.0 * along);
    svg.right_angle(hit, out, along);
    svg.line("sphere dashed", middle, hit);
    svg.arrow("normal bold", hit, tip);
    svg.circle("ink solid", hit, 4.5);
    let half = 0.5 * (middle + hit);
    svg.label("sphere", half, UpperRight, "**P** − **C**");
    svg.label("normal", (tip + 12.0 * out).down(5.0), Middle, "**n**");
    svg.label("ink", (hit - 20.0 * along).down(5.0), Middle, "**P**");
}
