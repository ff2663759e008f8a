//! Figure 2 of the notes: P(t) = A + t·b.

use common::rtweekend::*;
use glam::DVec2;

use crate::figure::Figure;
use crate::plane::Plane;
use crate::svg::{Anchor, Svg, spoken};

/// The words of this figure.
pub const FIGURE: Figure = Figure {
    name: "ray",
    title: "Points on a ray",
    description: "A straight line rises to the right. It passes through a point A, where t is 0. \
        An arrow b leads from A to the point where t is 1. Equal steps further on t is 2, where the \
        point P is, and 3. On the other side of A the line is dashed, and t is negative. It says \
        that P is A plus twice b, and how far from A that is.",
    caption: "**P**(*t*) = **A** + *t* **b**. Each *t* is a place on the line: from one whole number to the next it \
        is one arrow **b**. Behind **A**, *t* is negative.",
    draw: || draw(&Parameters::default()),
};

/// What can be changed.
#[derive(Clone, Copy, Debug)]
pub struct Parameters {
    /// The ray, in the plane of x and y.
    pub ray: Ray,
    /// Where on it the point P is.
    pub t: f64,
}

impl Default for Parameters {
    fn default() -> Self {
        Self {
            ray: Ray::new(Point3::ZERO, Vec3::new(1.0, 0.5, 0.0)),
            t: 2.0,
        }
    }
}

/// Where the scene is on the sheet.
pub const PLANE: Plane = Plane::new(142.0, 172.0, 60.0);

/// Draws the ray with its marks, and the point P.
pub fn draw(&Parameters { ray, t }: &Parameters) -> String {
    let mut svg = FIGURE.sheet(SIZE.x, SIZE.y);
    let at = |t| PLANE.point(ray.at(t));
    if let Some((first, last)) = PLANE.on_sheet(&ray, SIZE) {
        svg.line("ray dashed", at(first), at(last.min(0.0)));
        if last > 0.0 {
            svg.arrow("ray line", at(first.max(0.0)), at(last));
        }
        for mark in MARKS
            .into_iter()
            .filter(|mark| (first..last).contains(mark))
        {
            draw_mark(&mut svg, &ray, mark);
        }
    }
    svg.arrow("ray bold", at(0.0), at(1.0));
    let beside = aside(&ray) + DVec2::new(0.0, 5.0);
    svg.label("ray", at(0.5) + beside, Anchor::Middle, "**b**");
    svg.label("ink", at(0.0) + beside, Anchor::Middle, "**A**");
    svg.circle("ink hollow", at(t), 6.0);
    svg.label("ink", at(t) + beside, Anchor::Middle, "**P**");
    for (line, words) in (0..).zip(formulas(&ray, t)) {
        let at = DVec2::new(14.0, 24.0 + 22.0 * f64::from(line));
        svg.label("ink", at, Anchor::Start, &words);
    }
    svg.finish()
}

/// The size of the sheet.
const SIZE: DVec2 = DVec2::new(400.0, 236.0);

/// The values of t that are marked.
const MARKS: [f64; 5] = [-1.0, 0.0, 1.0, 2.0, 3.0];

/// From the line of the ray to what is written beside it.
fn aside(ray: &Ray) -> DVec2 {
    20.0 * PLANE.vector(ray.direction).perp().normalize_or_zero()
}

/// A dot on the line and its t, as long as the marks leave room for words.
fn draw_mark(svg: &mut Svg, ray: &Ray, mark: f64) {
    let point = PLANE.point(ray.at(mark));
    svg.circle("ray solid", point, 4.5);
    let beyond = -0.8 * aside(ray);
    let anchor = match beyond.x < 0.0 {
        true => Anchor::End,
        false => Anchor::Start,
    };
    if PLANE.vector(ray.direction).length() > 40.0 {
        let words = format!("*t* = {}", spoken(mark));
        svg.small_label(
            "faint",
            point + beyond + DVec2::new(0.0, 4.0),
            anchor,
            &words,
        );
    }
}

/// What P is, and how far from A.
fn formulas(ray: &Ray, t: f64) -> [String; 2] {
    let length = ray.direction.length();
    let [t, distance, length] = [t, t * length, length].map(spoken);
    [
        format!("**P**({t}) = **A** + {t} **b**"),
        format!("from **A**: *t* · |**b**| = {t} · {length} = {distance}"),
    ]
}
