//! Figure 2 of the notes: P(t) = A + t·b.

use common::rtweekend::*;
use glam::DVec2;

use crate::figure::Figure;
use crate::plane::Plane;
use crate::svg::{Anchor, spoken};

/// The words of this figure.
pub const FIGURE: Figure = Figure {
    name: "ray",
    title: "Points on a ray",
    description: "A straight line rises to the right. It passes through a point A, where t is 0. \
        An arrow b leads from A to the point where t is 1. Equal steps further on t is 2 and 3. \
        On the other side of A the line is dashed, and t is negative.",
    caption: "**P**(*t*) = **A** + *t* **b**. Each *t* is a place on the line: from one whole number to the next it \
        is one arrow **b**. Behind **A**, *t* is negative.",
    draw: || draw(&Parameters::default()),
};

/// What can be changed.
#[derive(Clone, Debug)]
pub struct Parameters {
    /// The ray, in the plane of x and y.
    pub ray: Ray,
    /// The values of t that are marked.
    pub marks: Vec<f64>,
}

impl Default for Parameters {
    fn default() -> Self {
        Self {
            ray: Ray::new(Point3::ZERO, Vec3::new(1.0, 0.5, 0.0)),
            marks: vec![-1.0, 0.0, 1.0, 2.0, 3.0],
        }
    }
}

/// Draws the ray with its marks.
pub fn draw(Parameters { ray, marks }: &Parameters) -> String {
    let mut svg = FIGURE.sheet(400.0, 236.0);
    let plane = Plane::new(134.0, 164.0, 70.0);
    let at = |t| plane.point(ray.at(t));

    svg.line("ray dashed", at(-1.35), at(0.0));
    svg.arrow("ray line", at(0.0), at(3.6));
    svg.arrow("ray bold", at(0.0), at(1.0));
    let aside = 20.0 * plane.vector(ray.direction).perp().normalize();
    svg.label(
        "ray",
        at(0.5) + aside + DVec2::new(0.0, 5.0),
        Anchor::Middle,
        "**b**",
    );

    for &t in marks {
        svg.circle("ray solid", at(t), 4.5);
        let above = at(t) - aside + DVec2::new(-4.0, 2.0);
        svg.label("ink", above, Anchor::End, &format!("*t* = {}", spoken(t)));
    }
    let below = |t| at(t) + aside + DVec2::new(4.0, 8.0);
    svg.label("ink", below(0.0), Anchor::Start, "**A** = **P**(0)");
    svg.label(
        "ink",
        below(2.0),
        Anchor::Start,
        "**P**(2) = **A** + 2**b**",
    );
    svg.label("faint", below(-1.0), Anchor::Start, "behind");
    svg.finish()
}
