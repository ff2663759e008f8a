//! A ray, a sphere, and the roots on the axis of t. Ray and sphere move, and slips break the
//! formula.

use common::rtweekend::*;
use glam::DVec2;
use normals::hit_sphere;
use slips::{Chapter, Program};

use crate::figure::Figure;
use crate::live::{Action, Answer, Handle, Live, Number, parameters};
use crate::number::spoken;
use crate::plane::Plane;
use crate::roots::roots;
use crate::svg::{Anchor, Svg};
use crate::traced::red_sphere_lines;

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
    name: "discriminant",
    title: "The roots on the axis of t",
    description: "A ray starts at Q and goes through a sphere with center C. Where it goes in and \
        where it comes out a circle is drawn, t1 and t2. Below is an axis of t with the same two \
        circles on it, both to the right of 0. To the left of 0 the axis is shaded: that is behind \
        the eye. Below the axis are a, b, c and the discriminant as numbers, and that the line passes the \
        center at a distance l that is less than r.",
    caption: "Each root is a place on the line and a number on the axis. A place behind the eye has \
        a negative *t*. The line passes the center at the distance *l*.",
    draw: || LIVE.on_page(),
};

parameters! {
    q_x: Number::new("Q, to the right", -0.7, 5.3, 0.0),
    q_y: Number::new("Q, upwards", -1.5, 1.7, 0.0),
    d_x: Number::new("d, to the right", -3.0, 3.0, 1.0),
    d_y: Number::new("d, upwards", -2.0, 2.0, 0.0),
    c_x: Number::new("C, to the right", 0.5, 4.8, 3.0),
    c_y: Number::new("C, upwards", -0.6, 0.8, 0.6),
    radius: Number::new("radius", 0.2, 1.3, 1.2),
    formula: Number::choice("The formula", CHOICES),
}

/// The figure, as a reader moves it.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: FIGURE,
    question: "Where does the first root go when the eye enters the sphere? Drag **Q** into it, and \
        out at the other side.",
    solution: "It gets smaller, is 0 on the surface, and negative inside: then it is behind the eye. On the \
        other side the second root does the same, and both are negative.",
    handles: &[
        Handle::new(&["q_x", "q_y"], |it, to| {
            [it.q_x, it.q_y, _] = PLANE.place(to).to_array();
        }),
        Handle::new(&["d_x", "d_y"], |it, to| {
            [it.d_x, it.d_y, _] = (PLANE.place(to) - it.ray().origin).to_array();
        }),
        Handle::new(&["c_x", "c_y"], |it, to| {
            [it.c_x, it.c_y, _] = PLANE.place(to).to_array();
        }),
        Handle::new(&["radius"], |it, to| {
            it.radius = (PLANE.place(to) - it.center()).length();
        }),
    ],
    actions: &[
        Action::new("Hit", |it| it.put([0.0, 0.0], [3.0, 0.6], 1.2)),
        Action::new("Miss", |it| it.put([0.0, -0.7], [3.0, 0.5], 0.8)),
        Action::new("Touch", |it| it.put([0.0, -0.5], [3.0, 0.5], 1.0)),
        Action::new("Inside", |it| it.put([2.5, 0.0], [3.0, 0.6], 1.2)),
        Action::new("Behind", |it| it.put([4.0, 0.5], [2.0, 0.5], 1.0)),
    ],
    answer,
};

/// The formula as it should be, and three slips: their names in the catalogue.
const SLIPS: [&str; 3] = ["b-sign", "plus-b", "radius-not-squared"];
const CHOICES: &[&str] = &[
    "as it should be",
    "b = 2 d · (C − Q)",
    "t = (b − √(b² − 4ac)) / 2a",
    "c = (C − Q)² − r",
];

impl Parameters {
    fn center(&self) -> Point3 {
        Point3::new(self.c_x, self.c_y, 0.0)
    }

    fn ray(&self) -> Ray {
        // Without a length it would be no direction: the shortest is one step.
        let direction = match (self.d_x, self.d_y) {
            (0.0, 0.0) => Vec3::new(0.05, 0.0, 0.0),
            (x, y) => Vec3::new(x, y, 0.0),
        };
        Ray::new(Point3::new(self.q_x, self.q_y, 0.0), direction)
    }

    /// Puts eye and sphere there; the ray goes to the right.
    fn put(&mut self, q: [f64; 2], c: [f64; 2], radius: f64) {
        [self.q_x, self.q_y] = q;
        [self.d_x, self.d_y] = [1.0, 0.0];
        [self.c_x, self.c_y] = c;
        self.radius = radius;
    }

    /// Ray and sphere, and who finds the roots.
    fn scene(&self, slipped: Option<Program>) -> Scene {
        Scene {
            center: self.center(),
            radius: self.radius,
            ray: self.ray(),
            slipped,
        }
    }
}

/// A sphere and a ray in the plane of x and y, and who finds the roots.
struct Scene {
    center: Point3,
    radius: f64,
    ray: Ray,
    /// What a slip makes of chapter 3; or else the chapter itself finds them.
    slipped: Option<Program>,
}

impl Scene {
    /// All t that are found.
    fn roots(&self) -> Vec<f64> {
        roots(&self.ray, |ray| match &self.slipped {
            Some(program) => program.hit_sphere(self.center, self.radius, ray),
            None => hit_sphere(self.center, self.radius, ray),
        })
    }

    /// The a, b and c of the quadratic equation.
    fn coefficients(&self) -> [f64; 3] {
        let (Ray { origin, direction }, r) = (self.ray, self.radius);
        let Some(program) = &self.slipped else {
            let oc = self.center - origin;
            let a = direction.dot(direction);
            return [a, -2.0 * direction.dot(oc), oc.dot(oc) - r * r];
        };
        let oc = (program.oc)(self.center, origin);
        [
            (program.a)(program, direction),
            (program.linear)((program.dot)(direction, oc)),
            (program.constant)((program.squared)(program, oc), r),
        ]
    }

    /// b² − 4ac.
    fn discriminant(&self) -> f64 {
        let [a, b, c] = self.coefficients();
        b * b - 4.0 * a * c
    }

    /// How far from the center the line passes.
    fn passing(&self) -> f64 {
        (self.center - self.foot()).length()
    }

    /// The point of the line that is nearest to the center.
    fn foot(&self) -> Point3 {
        let Ray { origin, direction } = self.ray;
        self.ray
            .at(direction.dot(self.center - origin) / direction.length_squared())
    }
}

fn answer(parameters: &Parameters) -> Answer {
    let right = parameters.scene(None);
    let name = (parameters.formula as usize)
        .checked_sub(1)
        .map(|n| SLIPS[n]);
    let slipped = name
        .and_then(slips::find)
        .map(|slip| parameters.scene(Some(slip.program(Chapter::Normals))));
    let sentence = match &slipped {
        None => sentence(&right),
        Some(wrong) => sentence_on(wrong, &right),
    };
    let shown = slipped.as_ref().unwrap_or(&right);
    let below = right.center - Vec3::new(0.0, right.radius, 0.0);
    let lines = red_sphere_lines(right.center, right.radius, &right.ray);
    let handles = [right.ray.origin, right.ray.at(1.0), right.center, below];
    Answer {
        drawing: draw(shown),
        sentence,
        handles: handles.map(|it| PLANE.point(it)).into(),
        says: [vec![("roots", roots_in_words(&right.roots()))], lines].concat(),
    }
}

/// What the roots mean.
fn sentence(right: &Scene) -> String {
    let roots = right.roots();
    let at = listed(&roots);
    match roots[..] {
        [] => "The discriminant is negative: the line passes the center farther away than *r*. There is no root, and the \
            ray misses.".to_owned(),
        [only] if only < 0.0 => {
            format!("The discriminant is 0: the line only touches, behind the eye: {at}. The ray misses.")
        }
        [_] => format!("The discriminant is 0: the line only touches. Its one root is {at}."),
        [one, other] if near(one, 0.0) || near(other, 0.0) => {
            format!("The eye is on the sphere, where *t* is 0. The roots are {at}.")
        }
        [nearer, _] if nearer > 0.0 => {
            format!("The discriminant is positive, and both roots are ahead: {at}. The eye sees the first.")
        }
        [_, farther] if farther > 0.0 => {
            format!("One root is behind the eye and one ahead: {at}. The eye is inside.")
        }
        _ => format!(
            "The discriminant is positive, but both roots are behind the eye: {at}. The line meets the sphere, the ray does not."
        ),
    }
}

/// What a slip makes of it.
fn sentence_on(wrong: &Scene, right: &Scene) -> String {
    let [found, true_ones] = [wrong, right].map(Scene::roots);
    let is_right = |t: &f64| true_ones.iter().any(|it| near(*it, *t));
    let off: Vec<f64> = found.iter().copied().filter(|t| !is_right(t)).collect();
    if off.is_empty() && found.len() == true_ones.len() {
        let no_harm = match found[..] {
            [] => "there is no root, as there should be none",
            _ => "the roots are the right ones",
        };
        return format!(
            "Here the slip does no harm: {no_harm}. Change something, for example the radius."
        );
    }
    let should = match true_ones[..] {
        [] => "There should be no root".to_owned(),
        [_] => format!("The root should be {}", listed(&true_ones)),
        _ => format!("The roots should be {}", listed(&true_ones)),
    };
    let comes = if found.len() == 2 { "come" } else { "comes" };
    let places = match off[..] {
        [] => String::new(),
        [only] => format!(" At {} the line is not on the sphere.", spoken(only)),
        _ => " These places are not on the sphere.".to_owned(),
    };
    let farther = match found.iter().all(|t| is_on_axis(*t)) {
        true => "",
        false => " A root that is not on the axis is beyond its end.",
    };
    format!(
        "{should}, but {} {comes} out.{places}{farther}",
        listed(&found)
    )
}

/// Whether two roots differ by rounding alone, in this figure.
fn near(one: f64, other: f64) -> bool {
    (one - other).abs() < 1e-9
}

fn roots_in_words(roots: &[f64]) -> String {
    match roots {
        [] => "there is no root".to_owned(),
        [_] => format!("there is one root, {}", listed(roots)),
        _ => format!("the roots are {}", listed(roots)),
    }
}

fn listed(roots: &[f64]) -> String {
    match *roots {
        [] => "none".to_owned(),
        [only] => spoken(only),
        _ => roots
            .iter()
            .map(|&t| spoken(t))
            .collect::<Vec<_>>()
            .join(" and "),
    }
}

/// Where the scene is on the sheet.
const PLANE: Plane = Plane::new(60.0, 118.0, 60.0);

/// Draws the scene, the axis, and the numbers.
fn draw(scene: &Scene) -> Svg {
    let mut svg = FIGURE.sheet(400.0, 352.0);
    draw_scene(&mut svg, scene);
    let roots = scene.roots();
    draw_axis(&mut svg, &roots);
    for (t, n) in roots.into_iter().zip(1..) {
        let point = PLANE.point(scene.ray.at(t));
        let name = format!("*t*_{{{n}}}");
        if point.cmpge(DVec2::ZERO).all() && point.cmple(SCENE).all() {
            svg.circle("ink hollow", point, 5.0);
            svg.label("ink", point + DVec2::new(0.0, 22.0), Anchor::Middle, &name);
        }
        if is_on_axis(t) {
            svg.circle("ink hollow", on_axis(t), 5.0);
            svg.label(
                "ink",
                on_axis(t) - DVec2::new(0.0, 11.0),
                Anchor::Middle,
                &name,
            );
        }
    }
    draw_numbers(&mut svg, scene);
    svg
}

/// The part of the sheet above the axis.
const SCENE: DVec2 = DVec2::new(400.0, 226.0);

/// Whether a root is shown on the axis.
fn is_on_axis(t: f64) -> bool {
    (LEAST..=MOST).contains(&t)
}

/// The least and the greatest t on the axis.
const LEAST: f64 = -2.5;
const MOST: f64 = 6.0;

fn on_axis(t: f64) -> DVec2 {
    DVec2::new(128.0 + 42.0 * t, 258.0)
}

fn draw_scene(svg: &mut Svg, scene: &Scene) {
    let &Scene {
        center,
        radius,
        ray,
        ..
    } = scene;
    let [eye, middle, foot] = [ray.origin, center, scene.foot()].map(|it| PLANE.point(it));
    svg.circle("sphere area", middle, PLANE.scale * radius);
    svg.line("sphere dashed", middle, foot);
    if let Some((first, last)) = PLANE.on_sheet(&ray, SCENE) {
        let at = |t| PLANE.point(ray.at(t));
        svg.line("ray dashed", at(first), at(last.min(0.0)));
        if last > 0.0 {
            svg.arrow("ray line", at(first.max(0.0)), at(last));
        }
    }
    svg.arrow("ray bold", eye, PLANE.point(ray.at(1.0)));
    svg.circle("ray solid", eye, 4.5);
    svg.circle("sphere solid", middle, 4.5);
    svg.label("ink", eye + DVec2::new(0.0, 24.0), Anchor::Middle, "**Q**");
    let above = PLANE.point(ray.at(0.5)) - DVec2::new(0.0, 12.0);
    svg.label("ray", above, Anchor::Middle, "**d**");
    let beside = middle + DVec2::new(16.0, -6.0);
    svg.label("sphere", beside, Anchor::Start, "**C**");
    let half = 0.5 * (middle + foot) + DVec2::new(8.0, 5.0);
    svg.label("sphere", half, Anchor::Start, "*l*");
}

fn draw_axis(svg: &mut Svg, roots: &[f64]) {
    let [start, zero, end] = [LEAST, 0.0, MOST].map(on_axis);
    let above = DVec2::new(0.0, 42.0);
    svg.rect(
        "faint wash",
        start - above,
        zero - start + DVec2::new(0.0, 46.0),
    );
    svg.small_label(
        "ink",
        start - above + DVec2::new(6.0, 13.0),
        Anchor::Start,
        "behind",
    );
    svg.arrow("ray line", start, end + DVec2::new(10.0, 0.0));
    for mark in -2..=6 {
        let at = on_axis(f64::from(mark));
        svg.line("ray thin", at, at + DVec2::new(0.0, 5.0));
        let below = at + DVec2::new(0.0, 20.0);
        svg.small_label("faint", below, Anchor::Middle, &spoken(mark.into()));
    }
    if let &[nearer, farther] = roots {
        let [nearer, farther] = [nearer, farther].map(|t| on_axis(t.clamp(LEAST, MOST)));
        svg.line("ink bold", nearer, farther);
    }
}

fn draw_numbers(svg: &mut Svg, scene: &Scene) {
    let [a, b, c] = scene.coefficients().map(spoken);
    let [discriminant, l, r] = [scene.discriminant(), scene.passing(), scene.radius].map(spoken);
    let relation = match scene.passing().total_cmp(&scene.radius) {
        std::cmp::Ordering::Less => '<',
        std::cmp::Ordering::Equal => '=',
        std::cmp::Ordering::Greater => '>',
    };
    let lines = [
        (14.0, 302.0, format!("*a* = {a}")),
        (14.0, 322.0, format!("*b* = {b}")),
        (14.0, 342.0, format!("*c* = {c}")),
        (150.0, 302.0, format!("*b*² − 4*ac* = {discriminant}")),
        (150.0, 322.0, format!("*l* = {l} {relation} *r* = {r}")),
    ];
    for (x, y, words) in lines {
        svg.label("ink", DVec2::new(x, y), Anchor::Start, &words);
    }
}
