//! Figure 2 of the notes: P(t) = Q + t·d. Q, the tip of d, and P along the line move.

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
    description: "A straight line rises to the right. It passes through a point Q, where t is 0. \
        An arrow d leads from Q to the point where t is 1. Equal steps further on t is 2, where the \
        point P is, and 3. On the other side of Q the line is dashed, and t is negative. It says \
        that P is Q plus twice d, and how far from Q that is.",
    caption: "**P**(*t*) = **Q** + *t* **d**. Each *t* is a place on the line: from one whole number to the next it \
        is one arrow **d**. Behind **Q**, *t* is negative.",
    draw: || LIVE.on_page(),
};

parameters! {
    q_x: Number::new("Q, to the right", -2.0, 4.0, 0.0),
    q_y: Number::new("Q, upwards", -0.75, 2.0, 0.0),
    d_x: Number::new("d, to the right", -4.0, 4.0, 1.0),
    d_y: Number::new("d, upwards", -2.5, 2.5, 0.5),
    t: Number::new("t", -2.0, 4.0, 2.0),
}

/// The figure, as a reader moves it.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: FIGURE,
    question: "What is *t* if **d** is twice as long, and **P** stays? Drag the tip of **d**, then \
        **P** back to where it was.",
    solution: "*t* is halved: half as many arrows, each twice as long, lead to the same place.",
    handles: &[
        Handle::new(&["q_x", "q_y"], |it, to| {
            [it.q_x, it.q_y, _] = PLANE.place(to).to_array();
        }),
        Handle::new(&["d_x", "d_y"], |it, to| {
            let way = PLANE.place(to) - it.ray().origin;
            [it.d_x, it.d_y, _] = way.to_array();
        }),
        Handle::new(&["t"], |it, to| {
            let ray = it.ray();
            let way = PLANE.place(to) - ray.origin;
            it.t = way.dot(ray.direction) / ray.direction.length_squared();
        }),
    ],
    actions: &[
        Action::new("Double d, keep P", |it| it.stretch(2.0)),
        Action::new("Halve d, keep P", |it| it.stretch(0.5)),
        Action::new("P behind Q", |it| it.t = -1.0),
    ],
    answer,
};

impl Parameters {
    fn ray(&self) -> Ray {
        Ray::new(
            Point3::new(self.q_x, self.q_y, 0.0),
            Vec3::new(self.d_x, self.d_y, 0.0),
        )
    }

    /// Makes d longer or shorter by a `factor`, where there is room, and leaves P in its place.
    fn stretch(&mut self, factor: f64) {
        let mut numbers = [
            self.q_x,
            self.q_y,
            self.d_x * factor,
            self.d_y * factor,
            self.t / factor,
        ];
        let stretched = numbers;
        let live: &dyn Movable = &LIVE;
        live.confine(&mut numbers);
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
                "**d** has no length, so **P** is **Q**, whatever *t* is.".to_owned()
            }
            "" => "At *t* = 0 the place is **Q** itself, however long **d** is.".to_owned(),
            _ => format!(
                "*t* = {t_said} says: from **Q** go {t_said} times the arrow **d**, which is {length_said} \
                 long. So **P** is {distance}{side} **Q**."
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
const PLANE: Plane = Plane::new(142.0, 142.0, 60.0);

/// Draws the ray with its marks, and the point P.
fn draw(ray: &Ray, t: f64) -> Svg {
    // Below the scene is room for the formulas, which nothing that is dragged can reach.
    let mut svg = FIGURE.sheet(SIZE.x, SIZE.y + 48.0);
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
    svg.label("ray", at(0.5) + beside, Anchor::Middle, "**d**");
    svg.label("ink", at(0.0) + beside, Anchor::Middle, "**Q**");
    svg.circle("ink hollow", at(t), 6.0);
    svg.label("ink", at(t) + beside, Anchor::Middle, "**P**");
    for (line, words) in (0..).zip(formulas(ray, t)) {
        let at = DVec2::new(14.0, SIZE.y + 20.0 + 22.0 * f64::from(line));
        svg.label("ink", at, Anchor::Start, &words);
    }
    svg
}

/// The size of the scene.
const SIZE: DVec2 = DVec2::new(400.0, 206.0);

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
        format!("**P**({t}) = **Q** + {t} **d**"),
        format!("from **Q**: *t* · |**d**| = {t} · {length} = {distance}"),
    ]
}
