//! A ray, a sphere, and the roots on the axis of t.

use common::rtweekend::*;
use glam::DVec2;
use normals::hit_sphere;

use crate::figure::Figure;
use crate::plane::Plane;
use crate::svg::{Anchor, Svg, spoken};

/// The words of this figure.
pub const FIGURE: Figure = Figure {
    name: "discriminant",
    title: "The roots on the axis of t",
    description: "A ray starts at Q and goes through a sphere with center C. Where it goes in and \
        where it comes out a circle is drawn, t1 and t2. Below is an axis of t with the same two \
        circles on it, both to the right of 0. To the left of 0 the axis is shaded: that is behind \
        the eye. Below the axis are a, b, c and D as numbers, and that the line passes the center \
        at a distance s that is less than r.",
    caption: "Each root is a place on the line and a number on the axis. What is behind the eye has \
        a negative *t*. The line passes the center at the distance *s*.",
    draw: || draw(&Parameters::default()),
};

/// What can be changed.
#[derive(Clone, Copy)]
pub struct Parameters<'a> {
    /// The center of the sphere, in the plane of x and y.
    pub center: Point3,
    /// Its radius.
    pub radius: f64,
    /// The ray, in the same plane.
    pub ray: Ray,
    /// Who finds the roots.
    pub solver: &'a dyn Solver,
}

/// Finds the nearer root, in one way or another.
pub trait Solver {
    /// The a, b and c of the quadratic equation.
    fn coefficients(&self, center: Point3, radius: f64, ray: &Ray) -> [f64; 3];

    /// The nearer root.
    fn hit_sphere(&self, center: Point3, radius: f64, ray: &Ray) -> Option<f64>;
}

/// The function of chapter 3, and equations (13) to (15).
#[derive(Clone, Copy, Debug)]
pub struct Right;

impl Solver for Right {
    fn coefficients(&self, center: Point3, radius: f64, ray: &Ray) -> [f64; 3] {
        let oc = center - ray.origin;
        let a = ray.direction.dot(ray.direction);
        let b = -2.0 * ray.direction.dot(oc);
        let c = oc.dot(oc) - radius * radius;
        [a, b, c]
    }

    fn hit_sphere(&self, center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
        hit_sphere(center, radius, ray)
    }
}

impl Default for Parameters<'_> {
    fn default() -> Self {
        Self {
            center: Point3::new(3.0, 0.6, 0.0),
            radius: 1.2,
            ray: Ray::new(Point3::ZERO, Vec3::new(1.0, 0.0, 0.0)),
            solver: &Right,
        }
    }
}

impl Parameters<'_> {
    /// All t that the solver finds: the farther one is the nearer one of the ray turned
    /// round.
    pub fn roots(&self) -> Vec<f64> {
        let nearer = |ray| self.solver.hit_sphere(self.center, self.radius, &ray);
        let turned = Ray::new(self.ray.origin, -self.ray.direction);
        let farther = nearer(turned).map(|t| -t);
        let mut roots: Vec<f64> = nearer(self.ray).into_iter().chain(farther).collect();
        roots.dedup();
        roots
    }

    /// b² − 4ac.
    pub fn discriminant(&self) -> f64 {
        let [a, b, c] = self.coefficients();
        b * b - 4.0 * a * c
    }

    /// How far from the center the line passes.
    pub fn passing(&self) -> f64 {
        (self.center - self.foot()).length()
    }

    fn coefficients(&self) -> [f64; 3] {
        self.solver
            .coefficients(self.center, self.radius, &self.ray)
    }

    /// The point of the line that is nearest to the center.
    fn foot(&self) -> Point3 {
        let Ray { origin, direction } = self.ray;
        self.ray
            .at(direction.dot(self.center - origin) / direction.length_squared())
    }
}

/// Where the scene is on the sheet.
pub const PLANE: Plane = Plane::new(60.0, 118.0, 60.0);

/// Draws the scene, the axis, and the numbers.
pub fn draw(parameters: &Parameters) -> String {
    let mut svg = FIGURE.sheet(400.0, 352.0);
    draw_scene(&mut svg, parameters);
    let roots = parameters.roots();
    draw_axis(&mut svg, &roots);
    for (t, n) in roots.into_iter().zip(1..) {
        let point = PLANE.point(parameters.ray.at(t));
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
    draw_numbers(&mut svg, parameters);
    svg.finish()
}

/// The part of the sheet above the axis.
const SCENE: DVec2 = DVec2::new(400.0, 226.0);

/// Whether a root is shown on the axis.
pub fn is_on_axis(t: f64) -> bool {
    (LEAST..=MOST).contains(&t)
}

/// The least and the greatest t on the axis.
const LEAST: f64 = -2.5;
const MOST: f64 = 6.0;

fn on_axis(t: f64) -> DVec2 {
    DVec2::new(128.0 + 42.0 * t, 258.0)
}

fn draw_scene(svg: &mut Svg, parameters: &Parameters) {
    let &Parameters {
        center,
        radius,
        ray,
        ..
    } = parameters;
    let [eye, middle, foot] = [ray.origin, center, parameters.foot()].map(|it| PLANE.point(it));
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
    svg.label("sphere", half, Anchor::Start, "*s*");
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

fn draw_numbers(svg: &mut Svg, parameters: &Parameters) {
    let [a, b, c] = parameters.coefficients().map(spoken);
    let [discriminant, s, r] = [
        parameters.discriminant(),
        parameters.passing(),
        parameters.radius,
    ]
    .map(spoken);
    let relation = match parameters.passing().total_cmp(&parameters.radius) {
        std::cmp::Ordering::Less => '<',
        std::cmp::Ordering::Equal => '=',
        std::cmp::Ordering::Greater => '>',
    };
    let lines = [
        (14.0, 302.0, format!("*a* = {a}")),
        (14.0, 322.0, format!("*b* = {b}")),
        (14.0, 342.0, format!("*c* = {c}")),
        (150.0, 302.0, format!("*D* = *b*² − 4*ac* = {discriminant}")),
        (150.0, 322.0, format!("*s* = {s} {relation} *r* = {r}")),
    ];
    for (x, y, words) in lines {
        svg.label("ink", DVec2::new(x, y), Anchor::Start, &words);
    }
}
