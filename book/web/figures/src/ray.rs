//! Figure 2 of the notes: P(t) = Q + t·d. Q, the tip of d, and P along the line move.

use crate::parameters::FigureParameters as _;
use crate::prelude::*;

parameters! {
    q: Point3 =
        Parameter::new("Q, to the right", -2.0, 4.0, 0.0),
        Parameter::new("Q, upwards", -0.75, 2.0, 0.0);
    d: Vec3 =
        Parameter::new("d, to the right", -4.0, 4.0, 1.0),
        Parameter::new("d, upwards", -2.5, 2.5, 0.5);
    t: f64 = Parameter::new("t", -2.0, 4.0, 2.0);
}

/// The live figure: a ray to be moved, its point P at a t that a reader chooses, and marks along
/// it.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: figure!("ray"),
    handles: &[
        point!(PLANE, q),
        point!(PLANE, d from q),
        Handle {
            field: "t",
            at: |it| PLANE.point(it.ray().at(it.t)),
            drag: |it, to| it.t = nearest(&it.ray(), PLANE.place(to)),
        },
    ],
    actions: &[
        ("Double d, keep P", |it| it.stretch(2.0)),
        ("Halve d, keep P", |it| it.stretch(0.5)),
        ("P behind Q", |it| it.t = -1.0),
    ],
    answer,
};

impl Parameters {
    fn ray(&self) -> Ray {
        Ray::new(self.q, self.d)
    }

    /// Multiplies d by `factor` and divides t by it, so that P stays; changes nothing if either
    /// would leave its range.
    fn stretch(&mut self, factor: f64) {
        let (d, t) = (factor * self.d, self.t / factor);
        let stretched = Self { d, t, ..*self };
        let mut numbers = stretched.numbers();
        LIVE.confine(&mut numbers);
        if numbers == stretched.numbers() {
            *self = stretched;
        }
    }
}

fn answer(parameters: &Parameters) -> DrawnFigure {
    let (ray, t) = (parameters.ray(), parameters.t);
    let length = ray.direction.length();
    let [t_said, length_said] = [t, length].map(spoken);
    let distance = spoken(t.abs() * length);
    let side = if t < 0.0 { "behind" } else { "ahead of" };
    let sentence = if length == 0.0 {
        "**d** has no length, so **P** is **Q**, whatever *t* is.".to_owned()
    } else if t == 0.0 {
        "At *t* = 0 the place is **Q** itself, however long **d** is.".to_owned()
    } else {
        format!(
            "*t* = {t_said} says: from **Q** go {t_said} times the arrow **d**, which is {length_said} \
             long. So **P** is {distance} {side} **Q**."
        )
    };
    let says = [
        ("t", t_said),
        ("length", length_said),
        ("distance", distance),
    ];
    DrawnFigure::new(draw(&ray, t), sentence, says)
}

/// The place of the scene on the sheet, and the size of its part of the sheet.
const PLANE: Plane = Plane::new(142.0, 142.0, 60.0);
const SIZE: DVec2 = spot(400.0, 206.0);

/// The values of t that are marked.
const MARKS: [f64; 5] = [-1.0, 0.0, 1.0, 2.0, 3.0];

/// Draws the ray with its marks, and the point P.
fn draw(ray: &Ray, t: f64) -> Svg {
    let mut svg = LIVE.figure.sheet(SIZE.y);
    let at = |t| PLANE.point(ray.at(t));
    PLANE.draw_line(&mut svg, ray, SIZE, f64::INFINITY);
    if let Some((first, last)) = PLANE.on_sheet(ray, SIZE) {
        let seen = MARKS.iter().filter(|mark| (first..last).contains(mark));
        seen.for_each(|mark| draw_mark(&mut svg, ray, *mark));
    }
    svg.arrow("ray bold", at(0.0), at(1.0));
    let beside = aside(ray).down(5.0);
    svg.label("ray", at(0.5) + beside, Middle, "**d**");
    svg.label("ink", at(0.0) + beside, Middle, "**Q**");
    svg.circle("ink hollow", at(t), 6.0);
    svg.label("ink", at(t) + beside, Middle, "**P**");
    svg
}

/// Returns a vector on the sheet from the ray's line to the labels beside it.
fn aside(ray: &Ray) -> DVec2 {
    20.0 * PLANE.vector(ray.direction).perp().normalize_or_zero()
}

/// Draws a dot on the line at the t `mark`, and its value if the marks are not too close for words.
fn draw_mark(svg: &mut Svg, ray: &Ray, mark: f64) {
    let point = PLANE.point(ray.at(mark));
    svg.circle("ray solid", point, 4.5);
    let beyond = (point - 0.8 * aside(ray)).down(4.0);
    let anchor = if aside(ray).x > 0.0 { End } else { Start };
    if PLANE.vector(ray.direction).length() > 40.0 {
        let words = format!("*t* = {}", spoken(mark));
        svg.small_label("faint", beyond, anchor, &words);
    }
}
