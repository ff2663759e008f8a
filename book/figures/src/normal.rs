//! Figure 7 of the notes: the normal of a sphere. The ray moves, and with it the place that
//! is hit.

use common::rtweekend::*;
use glam::DVec2;
use normals::hit_sphere;

use crate::figure::Figure;
use crate::live::{Action, Answer, Handle, Live, Number, parameters};
use crate::number::spoken;
use crate::plane::Plane;
use crate::svg::{Anchor, Svg};
use crate::traced::normals_lines;

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
    name: "normal",
    title: "The normal of a sphere",
    description: "A ray comes from the left and hits a sphere with center C in a point P. A dashed \
        radius leads from C to P. The normal n goes on in the same direction, out of the sphere, \
        and is one unit long. It stands upright on a short line that touches the sphere in P.",
    caption: "The outward normal is the way from the center to the point that was hit: **P** − **C**. \
        That way is *r* long, so **n** = (**P** − **C**)/*r* has length 1.",
    draw: || LIVE.on_page(),
};

parameters! {
    q_x: Number::new("Q, to the right", -3.2, 2.2, -3.1),
    q_y: Number::new("Q, upwards", -1.6, 2.4, 1.75),
    d_x: Number::new("d, to the right", -3.0, 3.0, 1.0),
    d_y: Number::new("d, upwards", -2.0, 2.0, -0.25),
}

/// The figure, as a reader moves it.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: FIGURE,
    question: "Where must the ray hit so that **n** points straight back along it? And what does this \
        chapter find if **Q** is inside the sphere?",
    solution: "Where a ray hits that is aimed at the center: only such a ray lies on a radius. From inside, the \
        nearer root is behind **Q**, so *t* is negative, and this chapter paints the sky.",
    handles: &[
        Handle::new(&["d_x", "d_y"], |it, to| {
            [it.d_x, it.d_y, _] = (PLANE.place(to) - it.ray().origin).to_array();
        }),
        Handle::new(&["q_x", "q_y"], |it, to| {
            [it.q_x, it.q_y, _] = PLANE.place(to).to_array();
        }),
    ],
    actions: &[
        Action::new("At the center", |it| it.put([-3.1, 0.0], [1.0, 0.0])),
        Action::new("Past it", |it| it.put([-3.1, 1.75], [1.0, 0.0])),
        Action::new("From inside", |it| it.put([-0.6, 0.5], [1.0, 0.25])),
    ],
    answer,
};

impl Parameters {
    fn ray(&self) -> Ray {
        // Without a length it would be no direction: the shortest is one step.
        let direction = match (self.d_x, self.d_y) {
            (0.0, 0.0) => Vec3::new(0.05, 0.0, 0.0),
            (x, y) => Vec3::new(x, y, 0.0),
        };
        Ray::new(Point3::new(self.q_x, self.q_y, 0.0), direction)
    }

    fn put(&mut self, q: [f64; 2], d: [f64; 2]) {
        [self.q_x, self.q_y] = q;
        [self.d_x, self.d_y] = d;
    }
}

/// The sphere, in the plane of x and y, and where that is on the sheet.
const CENTER: Point3 = Point3::ZERO;
const RADIUS: f64 = 1.6;
const PLANE: Plane = Plane::new(235.0, 180.0, 68.0);
const SIZE: DVec2 = DVec2::new(400.0, 300.0);

fn answer(parameters: &Parameters) -> Answer {
    let ray = parameters.ray();
    let root = hit_sphere(CENTER, RADIUS, &ray);
    Answer {
        drawing: draw(&ray, root),
        sentence: match root {
            None => "The line of the ray misses the sphere, and there is no normal.".to_owned(),
            Some(t) if t > 0.0 => {
                let [x, y, _] = normal(ray.at(t)).to_array().map(spoken);
                format!(
                    "The nearer root is *t* = {}, and there **n** = ({x}, {y}, 0).",
                    spoken(t)
                )
            }
            Some(t) => format!(
                "The nearer root is *t* = {}: behind **Q**, so this chapter paints the sky.",
                spoken(t)
            ),
        },
        handles: [ray.at(1.0), ray.origin].map(|it| PLANE.point(it)).into(),
        says: normals_lines(CENTER, RADIUS, &ray),
    }
}

/// The outward normal there.
fn normal(point: Point3) -> Vec3 {
    (point - CENTER).normalize()
}

/// Draws the sphere and the ray, and if it hits, the normal.
fn draw(ray: &Ray, root: Option<f64>) -> Svg {
    let mut svg = FIGURE.sheet(SIZE.x, SIZE.y);
    let middle = PLANE.point(CENTER);
    svg.circle("sphere area", middle, PLANE.scale * RADIUS);
    svg.circle("sphere solid", middle, 4.5);
    let beside = middle + DVec2::new(8.0, 16.0);
    svg.label("sphere", beside, Anchor::Start, "**C**");
    let hit = root.filter(|&t| t > 0.0);
    if let Some((_, last)) = PLANE.on_sheet(ray, SIZE) {
        let end = hit.unwrap_or(last).max(0.0);
        svg.arrow(
            "ray line",
            PLANE.point(ray.origin),
            PLANE.point(ray.at(end)),
        );
    }
    svg.arrow(
        "ray bold",
        PLANE.point(ray.origin),
        PLANE.point(ray.at(1.0)),
    );
    svg.circle("ray solid", PLANE.point(ray.origin), 4.5);
    let below = PLANE.point(ray.origin) + DVec2::new(0.0, 24.0);
    svg.label("ink", below, Anchor::Middle, "**Q**");
    let above = PLANE.point(ray.at(0.5)) - DVec2::new(0.0, 12.0);
    svg.label("ray", above, Anchor::Middle, "**d**");
    if let Some(t) = hit {
        draw_normal(&mut svg, ray.at(t));
    }
    svg
}

/// Draws the radius to a point of the sphere, what touches there, and the normal.
fn draw_normal(svg: &mut Svg, point: Point3) {
    let unit = normal(point);
    let [middle, hit, tip] = [CENTER, point, point + unit].map(|it| PLANE.point(it));
    let out = PLANE.vector(unit).normalize();
    let along = 60.0 * out.perp();
    svg.line("faint dashed", hit - along, hit + along);
    svg.path(
        "faint thin",
        &[9.0 * out, 9.0 * (out + out.perp()), 9.0 * out.perp()].map(|corner| hit + corner),
    );
    svg.line("sphere dashed", middle, hit);
    svg.arrow("normal bold", hit, tip);
    svg.circle("ink solid", hit, 4.5);
    let half = 0.5 * (middle + hit) + DVec2::new(8.0, -4.0);
    svg.label("sphere", half, Anchor::Start, "**P** − **C**");
    let beyond = tip + 12.0 * out + DVec2::new(0.0, 5.0);
    svg.label("normal", beyond, Anchor::Middle, "**n**");
    svg.label(
        "ink",
        hit - 20.0 * out.perp() + DVec2::new(0.0, 5.0),
        Anchor::Middle,
        "**P**",
    );
}
