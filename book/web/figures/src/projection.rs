//! h as the projection of C − Q on d, and the discriminant as the way from there to the
//! roots. The sphere moves, and the direction becomes longer.

use half_b_sphere::hit_sphere;

use crate::traced::half_b_lines;
use crate::vocabulary::*;

parameters! {
    c: Point3 =
        Number::new("C, to the right", -0.2, 3.4, 2.6),
        Number::new("C, upwards", -0.6, 1.4, 0.6);
    length: f64 = Number::new("|d|", 0.5, 3.0, 1.0);
}

/// The figure, as a reader moves it.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: Figure {
        name: "projection",
        title: "What h and the discriminant measure",
        description: "A ray starts at Q and passes through a sphere with center C. The vector oc leads \
            from Q to C. A dashed line from C meets the ray at a right angle, h along the ray from Q. \
            From there it is the root of the discriminant back to the nearer root, and as far on to \
            the farther one.",
        caption: "With **d** of length 1, *h* = **d**·(**C** − **Q**) is how far along the ray it comes nearest to **C**. The \
            square root of *h*² − *ac* is half of the way through the sphere: one root is as far before that \
            point as the other is behind it.",
        question: "Which values of the listing below change if **d** becomes longer, and which stay? Drag its \
        tip.",
        solution: "*a* grows with the square of the length, *h* with the length, and *c* stays. The result \
        *t* is divided by the length, so that the place stays the same.",
    },
    handles: &[
        point!(PLANE, c),
        Handle {
            field: "length",
            at: |it| PLANE.point(xy(it.length, 0.0)),
            drag: |it, to| it.length = PLANE.place(to).x,
        },
    ],
    actions: &[
        ("Twice as long", |it| it.length = 2.0),
        ("Touch", |it| (it.c.y, it.length) = (1.0, 1.0)),
        ("Around Q", |it| it.c = xy(0.3, 0.4)),
    ],
    answer,
};

/// The sphere has this radius, and the ray starts at the origin.
const RADIUS: f64 = 1.0;

/// Where the scene is on the sheet.
const PLANE: Plane = Plane::new(62.0, 170.0, 78.0);

fn answer(&Parameters { c, length }: &Parameters) -> Answer {
    let ray = Ray::new(Point3::ZERO, length * Vec3::X);
    let roots = roots(&ray, |ray| hit_sphere(c, RADIUS, ray));
    let said: Vec<String> = roots.iter().copied().map(spoken).collect();
    let sentence = match &said[..] {
        [nearer, farther] => format!(
            "*h*/*a* = {} is half way between the roots {nearer} and {farther}.",
            spoken(nearest(&ray, c))
        ),
        [only] => format!("The ray only touches, at *t* = {only} = *h*/*a*."),
        _ => "The ray misses: *h*² is less than *ac*.".to_owned(),
    };
    let lines = half_b_lines(c, RADIUS, &ray);
    Answer::new(draw(c, &ray, &roots), sentence, lines)
}

/// Draws the triangle of Q, C and the point of the ray that is nearest to C.
fn draw(center: Point3, ray: &Ray, roots: &[f64]) -> Svg {
    let mut svg = LIVE.figure.sheet(286.0);
    let nearest = nearest(ray, center);
    let [q, c, foot] = [ray.origin, center, ray.at(nearest)].map(|it| PLANE.point(it));
    svg.circle("sphere area", c, PLANE.scale * RADIUS);
    svg.arrow("ray line", q, PLANE.point(xy(4.1, 0.0)));
    svg.arrow("ray bold", q, PLANE.point(ray.direction));
    svg.arrow("sphere line", q, c);
    svg.line("faint dashed", c, foot);
    svg.dot("sphere", c, UpperRight, "**C**");
    svg.dot("ray", q, UpperLeft, "**Q**");
    svg.label("ray", PLANE.point(ray.direction), Below, "**d**");
    svg.label("sphere", 0.5 * (c + q), UpperLeft, "**C** − **Q**");
    for &t in roots {
        svg.circle("ray hollow", PLANE.point(ray.at(t)), 5.0);
    }
    // Along the ray, in lengths of the scene: with a direction of length 1, h and the root.
    if let &[nearer, _] = roots {
        let words = "√(*h*² − *ac*) / *a*";
        span(&mut svg, ray, [nearer, nearest], 50.0, words);
    }
    span(&mut svg, ray, [0.0, nearest], 88.0, "*h* / *a*");
    svg
}

/// A measured stretch of the ray, so far below it.
fn span(svg: &mut Svg, ray: &Ray, ends: [f64; 2], below: f64, words: &str) {
    let [from, to] = ends.map(|t| PLANE.point(ray.at(t)).down(below));
    svg.line("ink line", from, to);
    for end in [from, to] {
        svg.line("ink line", end.down(-5.0), end.down(5.0));
    }
    svg.label("ink", (0.5 * (from + to)).down(18.0), Middle, words);
}
