//! A ray, a sphere, and the roots on the axis of t. Ray and sphere move, and slips break the
//! formula.

use std::cmp::Ordering;

use normals::hit_sphere;
use slips::{Chapter, Program};

use crate::roots::roots;
use crate::traced::red_sphere_lines;
use crate::vocabulary::*;

parameters! {
    q: Point3 =
        Number::new("Q, to the right", -0.7, 5.3, 0.0),
        Number::new("Q, upwards", -1.5, 1.7, 0.0);
    d: Vec3 =
        Number::new("d, to the right", -3.0, 3.0, 1.0),
        Number::new("d, upwards", -2.0, 2.0, 0.0);
    c: Point3 =
        Number::new("C, to the right", 0.5, 4.8, 3.0),
        Number::new("C, upwards", -0.6, 0.8, 0.6);
    radius: f64 = Number::new("radius", 0.2, 1.3, 1.2);
    formula: f64 = Number::choice("The formula", CHOICES);
}

/// The figure, as a reader moves it.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: Figure {
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
    },
    question: "Where does the first root go when the eye enters the sphere? Drag **Q** into it, and \
        out at the other side.",
    solution: "It gets smaller, is 0 on the surface, and negative inside: then it is behind the eye. On the \
        other side the second root does the same, and both are negative.",
    handles: &[
        point!(PLANE, q),
        point!(PLANE, d from q),
        point!(PLANE, c),
        Handle {
            field: "radius",
            at: |it| PLANE.point(it.c - it.radius * Vec3::Y),
            drag: |it, to| it.radius = (PLANE.place(to) - it.c).length(),
        },
    ],
    actions: &[
        ("Hit", |it| it.put(xy(0.0, 0.0), xy(3.0, 0.6), 1.2)),
        ("Miss", |it| it.put(xy(0.0, -0.7), xy(3.0, 0.5), 0.8)),
        ("Touch", |it| it.put(xy(0.0, -0.5), xy(3.0, 0.5), 1.0)),
        ("Inside", |it| it.put(xy(2.5, 0.0), xy(3.0, 0.6), 1.2)),
        ("Behind", |it| it.put(xy(4.0, 0.5), xy(2.0, 0.5), 1.0)),
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
    /// Puts eye and sphere there; the ray goes to the right.
    fn put(&mut self, q: Point3, c: Point3, radius: f64) {
        let d = Vec3::X;
        *self = Self {
            q,
            d,
            c,
            radius,
            ..*self
        };
    }

    /// Ray and sphere, and the program that finds the roots.
    fn scene(&self, slipped: Option<Program>) -> Scene {
        Scene {
            center: self.c,
            radius: self.radius,
            ray: ray(self.q, self.d),
            slipped,
        }
    }
}

/// A sphere and a ray in the plane of x and y.
struct Scene {
    center: Point3,
    radius: f64,
    ray: Ray,
    /// What a slip makes of chapter 3; or else the chapter itself finds the roots.
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

    /// The point of the line that is nearest to the center.
    fn foot(&self) -> Point3 {
        self.ray.at(nearest(&self.ray, self.center))
    }
}

fn answer(parameters: &Parameters) -> Answer {
    let right = parameters.scene(None);
    let slip = chosen(parameters.formula, &SLIPS);
    let slipped = slip.map(|slip| parameters.scene(Some(slip.program(Chapter::Normals))));
    let sentence = match &slipped {
        None => sentence(&right),
        Some(wrong) => sentence_on(wrong, &right),
    };
    let lines = red_sphere_lines(right.center, right.radius, &right.ray);
    let says = [vec![("roots", roots_in_words(&right.roots()))], lines].concat();
    let drawing = draw(slipped.as_ref().unwrap_or(&right));
    Answer::new(drawing, sentence, says)
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
    let farther = if found.iter().all(is_on_axis) {
        ""
    } else {
        " A root that is not on the axis is beyond its end."
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
    let roots: Vec<String> = roots.iter().copied().map(spoken).collect();
    match &roots[..] {
        [] => "none".to_owned(),
        roots => roots.join(" and "),
    }
}

/// Where the scene is on the sheet, and its size.
const PLANE: Plane = Plane::new(60.0, 118.0, 60.0);
const SIZE: DVec2 = DVec2::new(400.0, 226.0);

/// Where a t is, below the scene.
const AXIS: Axis = Axis::new(23.0, 258.0, 357.0, LEAST, MOST);
const LEAST: f64 = -2.5;
const MOST: f64 = 6.0;

/// Whether a root is shown on the axis.
fn is_on_axis(t: &f64) -> bool {
    (LEAST..=MOST).contains(t)
}

/// Draws the scene, the axis, and the numbers.
fn draw(scene: &Scene) -> Svg {
    let mut svg = LIVE.figure.sheet(352.0);
    draw_scene(&mut svg, scene);
    let roots = scene.roots();
    draw_axis(&mut svg, &roots);
    for (t, n) in roots.into_iter().zip(1..) {
        let point = PLANE.point(scene.ray.at(t));
        let name = format!("*t*_{{{n}}}");
        if point.clamp(DVec2::ZERO, SIZE) == point {
            svg.circle("ink hollow", point, 5.0);
            svg.label("ink", point, Below, &name);
        }
        if is_on_axis(&t) {
            svg.circle("ink hollow", AXIS.at(t), 5.0);
            svg.label("ink", AXIS.at(t), Above, &name);
        }
    }
    let [left, right] = numbers(scene);
    svg.readout(DVec2::new(14.0, 302.0), &left);
    svg.readout(DVec2::new(150.0, 302.0), &right);
    svg
}

fn draw_scene(svg: &mut Svg, scene: &Scene) {
    let [middle, foot] = [scene.center, scene.foot()].map(|it| PLANE.point(it));
    svg.circle("sphere area", middle, PLANE.scale * scene.radius);
    svg.line("sphere dashed", middle, foot);
    PLANE.draw_line(svg, &scene.ray, SIZE, f64::INFINITY);
    PLANE.draw_ray(svg, &scene.ray);
    svg.dot("sphere", middle, UpperRight, "**C**");
    svg.label("sphere", 0.5 * (middle + foot), Right, "*l*");
}

fn draw_axis(svg: &mut Svg, roots: &[f64]) {
    let [start, zero, end] = [LEAST, 0.0, MOST].map(|t| AXIS.at(t));
    let corner = start - DVec2::new(0.0, 42.0);
    let size = zero - start + DVec2::new(0.0, 46.0);
    svg.rect("faint wash", corner, size);
    let inside = corner + DVec2::new(6.0, 13.0);
    svg.small_label("ink", inside, Start, "behind");
    svg.arrow("ray line", start, end + DVec2::new(10.0, 0.0));
    let whole = ticks((-2..=6).map(f64::from), spoken);
    AXIS.draw_ticks(svg, "ray thin", DVec2::new(0.0, 5.0), &whole);
    if let &[nearer, farther] = roots {
        svg.line("ink bold", AXIS.at(nearer), AXIS.at(farther));
    }
}

/// The coefficients, and what they come to.
fn numbers(scene: &Scene) -> [Vec<String>; 2] {
    let [a, b, c] = scene.coefficients();
    let passing = (scene.center - scene.foot()).length();
    let relation = match passing.total_cmp(&scene.radius) {
        Ordering::Less => '<',
        Ordering::Equal => '=',
        Ordering::Greater => '>',
    };
    let [l, r, discriminant] = [passing, scene.radius, b * b - 4.0 * a * c].map(spoken);
    let coefficients = [("a", a), ("b", b), ("c", c)];
    [
        coefficients
            .map(|(name, value)| format!("*{name}* = {}", spoken(value)))
            .into(),
        vec![
            format!("*b*² − 4*ac* = {discriminant}"),
            format!("*l* = {l} {relation} *r* = {r}"),
        ],
    ]
}
