//! h as the projection of C − Q on d, and the discriminant as the way from there to the
//! roots. The sphere moves, and the direction becomes longer.

use common::rtweekend::*;
use glam::DVec2;
use half_b_sphere::hit_sphere;

use crate::figure::Figure;
use crate::live::{Action, Answer, Handle, Live, Number, parameters};
use crate::number::spoken;
use crate::plane::Plane;
use crate::roots::roots;
use crate::svg::{Anchor, Svg};
use crate::traced::half_b_lines;

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
    name: "projection",
    title: "What h and the discriminant measure",
    description: "A ray starts at Q and passes through a sphere with center C. The vector oc leads \
        from Q to C. A dashed line from C meets the ray at a right angle, h along the ray from Q. \
        From there it is the root of the discriminant back to the nearer root, and as far on to \
        the farther one.",
    caption: "With **d** of length 1, *h* = **d**·(**C** − **Q**) is how far along the ray it comes nearest to **C**. The \
        square root of *h*² − *ac* is half of the way through the sphere: one root is as far before that \
        point as the other is behind it.",
    draw: || LIVE.on_page(),
};

parameters! {
    c_x: Number::new("C, to the right", -0.2, 3.4, 2.6),
    c_y: Number::new("C, upwards", -0.6, 1.4, 0.6),
    length: Number::new("|d|", 0.5, 3.0, 1.0),
}

/// The figure, as a reader moves it.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: FIGURE,
    question: "Which values of the listing below change if **d** becomes longer, and which stay? Drag its \
        tip.",
    solution: "*a* grows with the square of the length, *h* with the length, and *c* stays. The result \
        *t* is divided by the length, so that the place stays the same.",
    handles: &[
        Handle::new(&["c_x", "c_y"], |it, to| {
            [it.c_x, it.c_y, _] = PLANE.place(to).to_array();
        }),
        Handle::new(&["length"], |it, to| it.length = PLANE.place(to).x),
    ],
    actions: &[
        Action::new("Twice as long", |it| it.length = 2.0),
        Action::new("Touch", |it| [it.c_y, it.length] = [1.0, 1.0]),
        Action::new("Around Q", |it| [it.c_x, it.c_y] = [0.3, 0.4]),
    ],
    answer,
};

/// The sphere has this radius, and the ray starts at the origin.
const RADIUS: f64 = 1.0;

/// Where the scene is on the sheet.
const PLANE: Plane = Plane::new(62.0, 170.0, 78.0);

fn answer(parameters: &Parameters) -> Answer {
    let center = Point3::new(parameters.c_x, parameters.c_y, 0.0);
    let ray = Ray::new(Point3::ZERO, parameters.length * Vec3::X);
    let roots = roots(&ray, |ray| hit_sphere(center, RADIUS, ray));
    let h = ray.direction.dot(center);
    let sentence = match roots[..] {
        [nearer, farther] => format!(
            "*h*/*a* = {} is half way between the roots {} and {}.",
            spoken(h / ray.direction.length_squared()),
            spoken(nearer),
            spoken(farther)
        ),
        [only] => format!("The ray only touches, at *t* = {} = *h*/*a*.", spoken(only)),
        _ => "The ray misses: *h*² is less than *ac*.".to_owned(),
    };
    Answer {
        drawing: draw(center, &ray, &roots),
        sentence,
        handles: [center, ray.at(1.0)].map(|it| PLANE.point(it)).into(),
        says: half_b_lines(center, RADIUS, &ray),
    }
}

/// Draws the triangle of Q, C and the point of the ray that is nearest to C.
fn draw(center: Point3, ray: &Ray, roots: &[f64]) -> Svg {
    let mut svg = FIGURE.sheet(400.0, 286.0);
    let nearest = ray.direction.dot(center) / ray.direction.length_squared();
    let [q, c, foot] = [ray.origin, center, ray.at(nearest)].map(|it| PLANE.point(it));

    svg.circle("sphere area", c, PLANE.scale * RADIUS);
    svg.arrow("ray line", q, PLANE.point(Point3::new(4.1, 0.0, 0.0)));
    svg.arrow("ray bold", q, PLANE.point(ray.at(1.0)));
    svg.arrow("sphere line", q, c);
    svg.line("faint dashed", c, foot);
    svg.circle("sphere solid", c, 4.5);
    svg.circle("ray solid", q, 4.5);
    svg.label("ink", q + DVec2::new(-14.0, -6.0), Anchor::Middle, "**Q**");
    svg.label("sphere", c + DVec2::new(8.0, -8.0), Anchor::Start, "**C**");
    let below = PLANE.point(ray.at(1.0)) + DVec2::new(0.0, 22.0);
    svg.label("ray", below, Anchor::Middle, "**d**");
    let above = 0.5 * (c + q) + DVec2::new(-4.0, -10.0);
    svg.label("sphere", above, Anchor::End, "**C** − **Q**");
    for &t in roots {
        svg.circle("ray hollow", PLANE.point(ray.at(t)), 5.0);
    }
    // Along the ray, in lengths of the scene: with a direction of length 1, h and the root.
    if let &[nearer, _] = roots {
        span(
            &mut svg,
            ray,
            [nearer, nearest],
            50.0,
            "√(*h*² − *ac*) / *a*",
        );
    }
    span(&mut svg, ray, [0.0, nearest], 88.0, "*h* / *a*");
    svg
}

/// A measured stretch of the ray, so far below it.
fn span(svg: &mut Svg, ray: &Ray, ends: [f64; 2], below: f64, words: &str) {
    let [from, to] = ends.map(|t| PLANE.point(ray.at(t)) + DVec2::new(0.0, below));
    let mark = DVec2::new(0.0, 5.0);
    svg.line("ink line", from, to);
    for end in [from, to] {
        svg.line("ink line", end - mark, end + mark);
    }
    let middle = 0.5 * (from + to) + DVec2::new(0.0, 18.0);
    svg.label("ink", middle, Anchor::Middle, words);
}
