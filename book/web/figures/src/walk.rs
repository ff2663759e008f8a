//! The geometric solution: the way h to the point nearest to the center, its distance l, and half
//! of the chord, by Pythagoras. The sphere moves, grows, and the direction becomes longer.

use half_b_sphere::hit_sphere;

use crate::prelude::*;
use crate::traced::half_b_lines;

parameters! {
    c: Point3 =
        Parameter::new("h: C, along the ray", 0.0, 1.7, 1.6),
        Parameter::new("l: C, beside the ray", 0.0, 0.6, 0.3);
    radius: f64 = Parameter::new("r", 0.1, 0.7, 0.5);
    length: f64 = Parameter::new("|d|", 0.5, 2.0, 1.0);
}

/// The live figure: a reader moves and resizes the sphere, and stretches the ray's direction.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: figure!("walk"),
    handles: &[
        point!(PLANE, c),
        Handle {
            field: "radius",
            at: |it| PLANE.point(it.c + it.radius * Vec3::Y),
            drag: |it, to| it.radius = (PLANE.place(to) - it.c).length(),
        },
        Handle {
            field: "radius",
            at: |it| PLANE.point(it.ray().at(it.roots().last().copied().unwrap_or(it.foot()))),
            drag: |it, to| it.radius = (xy(PLANE.place(to).x, 0.0) - it.c).length(),
        },
        Handle {
            field: "length",
            at: |it| PLANE.point(xy(it.length, 0.0)),
            drag: |it, to| it.length = PLANE.place(to).x,
        },
    ],
    actions: &[
        ("Straight ahead", |it| it.put(xy(1.0, 0.0), 1.0)),
        ("Touch", |it| it.put(xy(1.0, 0.5), 1.0)),
        ("Miss", |it| it.put(xy(1.0, 0.6), 1.0)),
        ("From inside", |it| it.put(xy(0.2, 0.3), 1.0)),
        ("d twice as long", |it| it.put(it.c, 2.0)),
    ],
    answer,
};

impl Parameters {
    /// Puts a ball with the radius of chapter 2's there, and gives the direction this length.
    fn put(&mut self, c: Point3, length: f64) {
        let radius = 0.5;
        *self = Self { c, radius, length };
    }

    fn ray(&self) -> Ray {
        Ray::new(Point3::ZERO, self.length * Vec3::X)
    }

    /// Finds all t at which the line of the ray meets the sphere.
    fn roots(&self) -> Vec<f64> {
        roots(&self.ray(), |ray| hit_sphere(self.c, self.radius, ray))
    }

    /// Returns the t of the line's point that is nearest to the center.
    fn foot(&self) -> f64 {
        nearest(&self.ray(), self.c)
    }
}

fn answer(chosen: &Parameters) -> DrawnFigure {
    let roots = chosen.roots();
    let way = |t: f64| chosen.length * t;
    let l = (chosen.c - chosen.ray().at(chosen.foot())).length();
    let half = roots.last().map_or(0.0, |t| way(t - chosen.foot()));
    let [h, l_said, r, half] = [way(chosen.foot()), l, chosen.radius, half].map(spoken);
    let walk = format!("After a walk of {h} the center is *l* = {l_said} away");
    let at = listed(&roots);
    let sentence = match roots.len() {
        0 => format!("{walk}, more than *r* = {r}: the line misses."),
        1 => format!("{walk}, as far as *r*: the line touches, at *t* = {at}."),
        _ if chosen.length == 1.0 => {
            format!("{walk}, and half of the chord is {half}: *t* = {at}.")
        }
        _ => format!(
            "{walk}, and half of the chord is {half}. **d** is {} long, so *t* = {at}.",
            spoken(chosen.length)
        ),
    };
    let lines = half_b_lines(chosen.c, chosen.radius, &chosen.ray());
    DrawnFigure::new(draw(chosen, &roots), sentence, lines)
}

/// The place of the scene on the sheet.
const PLANE: Plane = Plane::new(34.0, 176.0, 140.0);

fn draw(chosen: &Parameters, roots: &[f64]) -> Svg {
    let mut svg = LIVE.figure.sheet(290.0);
    let ray = chosen.ray();
    let [q, c, foot] = [ray.origin, chosen.c, ray.at(chosen.foot())].map(|it| PLANE.point(it));
    svg.circle("sphere area", c, PLANE.scale * chosen.radius);
    svg.arrow("ray line", q, PLANE.point(xy(2.55, 0.0)));
    svg.arrow("ray bold", q, PLANE.point(ray.direction));
    svg.line("sphere thin", q, c);
    if chosen.c.y > 0.0 {
        svg.right_angle(foot, DVec2::X, DVec2::NEG_Y);
        svg.line("sphere dashed", c, foot);
        svg.label("sphere", 0.5 * (c + foot), Right, "*l*");
    }
    if let Some(&nearer) = roots.first() {
        let hit = PLANE.point(ray.at(nearer));
        svg.line("sphere line", c, hit);
        svg.label("sphere", 0.5 * (c + hit), UpperLeft, "*r*");
    }
    for &t in roots {
        svg.circle("ray hollow", PLANE.point(ray.at(t)), 5.0);
    }
    svg.dot("sphere", c, UpperRight, "**C**");
    svg.dot("ray", q, UpperLeft, "**Q**");
    svg.label("ray", PLANE.point(ray.direction), Below, "**d**");
    if let &[nearer, farther] = roots {
        let words = "√(*r*² − *l*²) to each side";
        measure(
            &mut svg,
            &ray,
            &[nearer, chosen.foot(), farther],
            50.0,
            words,
        );
    }
    measure(&mut svg, &ray, &[0.0, chosen.foot()], 86.0, "*h*");
    svg
}

/// Draws a dimension line `below` units below the ray, with a short line at each mark (a t), and
/// words.
fn measure(svg: &mut Svg, ray: &Ray, marks: &[f64], below: f64, words: &str) {
    let at = |t: f64| PLANE.point(ray.at(t)).down(below);
    let (from, to) = (at(marks[0]), at(marks[marks.len() - 1]));
    svg.line("ink line", from, to);
    for end in marks.iter().map(|&t| at(t)) {
        svg.line("ink line", end.down(-5.0), end.down(5.0));
    }
    svg.label("ink", (0.5 * (from + to)).down(18.0), Middle, words);
}
