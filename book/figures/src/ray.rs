//! Figure 2 of the notes: P(t) = A + t·b. A, the tip of b, and P along the line move.

use common::rtweekend::*;
use glam::DVec2;

use crate::figure::Figure;
use crate::live::{Action, Answer, Handle, Live, Movable, Number, Parameters as _, parameters};
use crate::number::spoken;
use crate::plane::Plane;
use crate::svg::{Anchor, Svg};

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
    name: "ray",
    title: "Points on a ray",
    description: "A straight line rises to the right. It passes through a point A, where t is 0. \
        An arrow b leads from A to the point where t is 1. Equal steps further on t is 2, where the \
        point P is, and 3. On the other side of A the line is dashed, and t is negative. It says \
        that P is A plus twice b, and how far from A that is.",
    caption: "**P**(*t*) = **A** + *t* **b**. Each *t* is a place on the line: from one whole number to the next it \
        is one arrow **b**. Behind **A**, *t* is negative.",
    draw: || LIVE.on_page(),
};

parameters! {
    a_x: Number::new("A, to the right", -2.0, 4.0, 0.0),
    a_y: Number::new("A, upwards", -0.75, 2.5, 0.0),
    b_x: Number::new("b, to the right", -4.0, 4.0, 1.0),
    b_y: Number::new("b, upwards", -2.5, 2.5, 0.5),
    t: Number::new("t", -2.0, 4.0, 2.0),
}

/// The figure, as a reader moves it.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: FIGURE,
    question: "What becomes of *t* if **b** is twice as long, and **P** stays? Drag the tip of **b**, then \
        **P** back to where it was.",
    handles: &[
        Handle::new(&["a_x", "a_y"], |it, to| {
            [it.a_x, it.a_y, _] = PLANE.place(to).to_array();
        }),
        Handle::new(&["b_x", "b_y"], |it, to| {
            let way = PLANE.place(to) - it.ray().origin;
            [it.b_x, it.b_y, _] = way.to_array();
        }),
        Handle::new(&["t"], |it, to| {
            let ray = it.ray();
            let way = PLANE.place(to) - ray.origin;
            it.t = way.dot(ray.direction) / ray.direction.length_squared();
        }),
    ],
    actions: &[
        Action::new("Double b, keep P", |it| it.stretch(2.0)),
        Action::new("Halve b, keep P", |it| it.stretch(0.5)),
        Action::new("P behind A", |it| it.t = -1.0),
    ],
    answer,
};

impl Parameters {
    fn ray(&self) -> Ray {
        Ray::new(
            Point3::new(self.a_x, self.a_y, 0.0),
            Vec3::new(self.b_x, self.b_y, 0.0),
        )
    }

    /// Makes b longer or shorter by a `factor`, where there is room, and leaves P in its place.
    fn stretch(&mut self, factor: f64) {
        let mut numbers = [
            self.a_x,
            self.a_y,
            self.b_x * factor,
            self.b_y * factor,
            self.t / factor,
        ];
        let stretched = numbers;
        LIVE.confine(&mut numbers);
        if numbers == stretched {
            *self = Self::of(&stretched);
        }
    }
}

fn answer(parameters: &Parameters) -> Answer {
    let (ray, t) = (parameters.ray(), parameters.t);
    let length = ray.direction.length();
    let [t_said, length_said] = [t, length].map(spoken);
    let distance = spoken(t.abs() * length);
    let side = match t {
        ..0.0 => " behind",
        0.0 => "",
        _ => " ahead of",
    };
    Answer {
        drawing: draw(&ray, t),
        sentence: match side {
            _ if length == 0.0 => {
                "**b** has no length, so **P** is **A**, whatever *t* is.".to_owned()
            }
            "" => "At *t* = 0 the place is **A** itself, however long **b** is.".to_owned(),
            _ => format!(
                "*t* = {t_said} says: from **A** go {t_said} times the arrow **b**, which is {length_said} \
                 long. So **P** is {distance}{side} **A**."
            ),
        },
        handles: [ray.origin, ray.at(1.0), ray.at(t)]
            .map(|it| PLANE.point(it))
            .into(),
        says: vec![
            ("t", t_said),
            ("length", length_said),
            ("distance", distance),
        ],
    }
}

/// Where the scene is on the sheet.
const PLANE: Plane = Plane::new(142.0, 172.0, 60.0);

/// Draws the ray with its marks, and the point P.
fn draw(ray: &Ray, t: f64) -> Svg {
    let mut svg = FIGURE.sheet(SIZE.x, SIZE.y);
    let at = |t| PLANE.point(ray.at(t));
    if let Some((first, last)) = PLANE.on_sheet(ray, SIZE) {
        svg.line("ray dashed", at(first), at(last.min(0.0)));
        if last > 0.0 {
            svg.arrow("ray line", at(first.max(0.0)), at(last));
        }
        for mark in MARKS
            .into_iter()
            .filter(|mark| (first..last).contains(mark))
        {
            draw_mark(&mut svg, ray, mark);
        }
    }
    svg.arrow("ray bold", at(0.0), at(1.0));
    let beside = aside(ray) + DVec2::new(0.0, 5.0);
    svg.label("ray", at(0.5) + beside, Anchor::Middle, "**b**");
    svg.label("ink", at(0.0) + beside, Anchor::Middle, "**A**");
    svg.circle("ink hollow", at(t), 6.0);
    svg.label("ink", at(t) + beside, Anchor::Middle, "**P**");
    for (line, words) in (0..).zip(formulas(ray, t)) {
        let at = DVec2::new(14.0, 24.0 + 22.0 * f64::from(line));
        svg.label("ink", at, Anchor::Start, &words);
    }
    svg
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
