//! The discriminant and the roots: drag the eye into the sphere, or behind it.

use common::rtweekend::*;
use figures::discriminant::{PLANE, Parameters, Right, Solver, draw, is_on_axis};
use figures::spoken;
use slips::Chapter;
use slips::{self, Program};

use crate::live::{Action, Answer, Handle, Live, Number};

/// Which root goes where.
pub(crate) const LIVE: Live = Live {
    name: "discriminant",
    question: "Where does the first root go when the eye enters the sphere? Drag **Q** into it, and \
        out at the other side.",
    numbers: &[
        Number::new("Q, to the right", -0.7, 5.3, 0.0),
        Number::new("Q, upwards", -1.5, 1.7, 0.0),
        Number::new("d, to the right", -3.0, 3.0, 1.0),
        Number::new("d, upwards", -2.0, 2.0, 0.0),
        Number::new("C, to the right", 0.5, 4.8, 3.0),
        Number::new("C, upwards", -0.6, 0.8, 0.6),
        Number::new("radius", 0.2, 1.2, 1.2),
        Number::choice("The formula", CHOICES),
    ],
    handles: &[
        Handle {
            numbers: &[4, 5],
            drag: |numbers, to| {
                let place = PLANE.place(to);
                (numbers[4], numbers[5]) = (place.x, place.y);
            },
        },
        Handle {
            numbers: &[6],
            drag: |numbers, to| {
                numbers[6] = (PLANE.place(to) - parameters(numbers, &Right).center).length();
            },
        },
        Handle {
            numbers: &[2, 3],
            drag: |numbers, to| {
                let way = PLANE.place(to) - parameters(numbers, &Right).ray.origin;
                (numbers[2], numbers[3]) = (way.x, way.y);
            },
        },
        Handle {
            numbers: &[0, 1],
            drag: |numbers, to| {
                let place = PLANE.place(to);
                (numbers[0], numbers[1]) = (place.x, place.y);
            },
        },
    ],
    actions: &[
        Action {
            name: "Hit",
            act: |numbers| place(numbers, [0.0, 0.0, 1.0, 0.0, 3.0, 0.6, 1.2]),
        },
        Action {
            name: "Miss",
            act: |numbers| place(numbers, [0.0, -0.7, 1.0, 0.0, 3.0, 0.5, 0.8]),
        },
        Action {
            name: "Touch",
            act: |numbers| place(numbers, [0.0, -0.5, 1.0, 0.0, 3.0, 0.5, 1.0]),
        },
        Action {
            name: "Inside",
            act: |numbers| place(numbers, [2.5, 0.0, 1.0, 0.0, 3.0, 0.6, 1.2]),
        },
        Action {
            name: "Behind",
            act: |numbers| place(numbers, [4.0, 0.5, 1.0, 0.0, 2.0, 0.5, 1.0]),
        },
    ],
    answer,
};

/// The formula as it should be, and three slips: their names in the catalogue.
const SLIPS: [&str; 3] = ["b-sign", "plus-b", "radius-not-squared"];
const CHOICES: &[&str] = &[
    "as it should be",
    "b = 2 d · (C − Q)",
    "t = (b − √D) / 2a",
    "c = (C − Q)² − r",
];

/// The program of a reader who made a slip.
struct Slipped(Program);

impl Solver for Slipped {
    fn coefficients(&self, center: Point3, radius: f64, ray: &Ray) -> [f64; 3] {
        let Self(program) = self;
        let oc = (program.oc)(center, ray.origin);
        [
            (program.a)(program, ray.direction),
            (program.linear)((program.dot)(ray.direction, oc)),
            (program.constant)((program.squared)(program, oc), radius),
        ]
    }

    fn hit_sphere(&self, center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
        self.0.hit_sphere(center, radius, ray)
    }
}

fn answer(numbers: &[f64]) -> Answer {
    let name = (numbers[7] as usize).checked_sub(1).map(|n| SLIPS[n]);
    let slip = name.and_then(slips::find);
    let right = parameters(numbers, &Right);
    let slipped = slip.map(|slip| Slipped(slip.program(Chapter::Normals)));
    let (shown, sentence) = match &slipped {
        None => (right, sentence(&right)),
        Some(slipped) => {
            let wrong = parameters(numbers, slipped);
            (wrong, sentence_on(&wrong, &right))
        }
    };
    let below = right.center - Vec3::new(0.0, right.radius, 0.0);
    let handles = [right.center, below, right.ray.at(1.0), right.ray.origin];
    Answer {
        svg: draw(&shown),
        sentence,
        handles: handles.map(|it| PLANE.point(it)).into(),
        says: vec![("roots", told(&shown.roots()))],
    }
}

fn parameters<'a>(numbers: &[f64], solver: &'a dyn Solver) -> Parameters<'a> {
    let &[q_x, q_y, d_x, d_y, c_x, c_y, radius, ..] = numbers else {
        unreachable!("the figure has eight numbers")
    };
    // Without a length it would be no direction: the shortest is one step.
    let direction = match (d_x, d_y) {
        (0.0, 0.0) => Vec3::new(0.05, 0.0, 0.0),
        _ => Vec3::new(d_x, d_y, 0.0),
    };
    Parameters {
        center: Point3::new(c_x, c_y, 0.0),
        radius,
        ray: Ray::new(Point3::new(q_x, q_y, 0.0), direction),
        solver,
    }
}

/// What the roots mean.
fn sentence(right: &Parameters) -> String {
    let roots = right.roots();
    let at = listed(&roots);
    match roots[..] {
        [] => "*D* is negative: the line passes the center farther away than *r*. There is no root, and the \
            ray misses.".to_owned(),
        [only] if only < 0.0 => {
            format!("*D* is 0: the line only touches, behind the eye: {at}. The ray misses.")
        }
        [_] => format!("*D* is 0: the line only touches. Its one root is {at}."),
        [one, other] if near(one, 0.0) || near(other, 0.0) => {
            format!("The eye is on the sphere, where *t* is 0. The roots are {at}.")
        }
        [nearer, _] if nearer > 0.0 => {
            format!("*D* is positive, and both roots are ahead: {at}. The eye sees the first.")
        }
        [_, farther] if farther > 0.0 => {
            format!("One root is behind the eye and one ahead: {at}. The eye is inside.")
        }
        _ => format!(
            "*D* is positive, but both roots are behind the eye: {at}. The line meets the sphere, the ray does not."
        ),
    }
}

/// What a slip makes of it.
fn sentence_on(wrong: &Parameters, right: &Parameters) -> String {
    let [found, true_ones] = [wrong, right].map(Parameters::roots);
    let is_right = |t: &f64| true_ones.iter().any(|it| near(*it, *t));
    let off: Vec<f64> = found.iter().copied().filter(|t| !is_right(t)).collect();
    if off.is_empty() && found.len() == true_ones.len() {
        return "Here the slip does no harm: the roots are the right ones. Change something, the radius too.".to_owned();
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
        false => " What is missing on the axis is farther off.",
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

fn told(roots: &[f64]) -> String {
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

fn place(numbers: &mut [f64], scene: [f64; 7]) {
    numbers[..7].copy_from_slice(&scene);
}
