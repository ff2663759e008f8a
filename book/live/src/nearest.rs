//! The nearest of several: drag the spheres, change their order, and go through the loop
//! turn by turn.

use common::rtweekend::*;
use figures::nearest::{PLANE, Parameters, Right, Search, Turn, draw, in_digits};
use slips::Chapter;
use slips::{self, Ball, Program};

use crate::live::{Action, Answer, Handle, Live, Number};

/// Whether the order matters.
pub(crate) const LIVE: Live = Live {
    name: "nearest",
    question: "Which sphere wins if you change the order of the list? And which, if the search \
        returns at the first hit? Drag them so that even that is right.",
    numbers: &[
        Number::new("Sphere 1, to the right", 0.0, 4.4, 2.9),
        Number::new("Sphere 1, upwards", -0.45, 0.45, 0.3),
        Number::new("Sphere 2, to the right", 0.0, 4.4, 1.85),
        Number::new("Sphere 2, upwards", -0.45, 0.45, -0.25),
        Number::new("Sphere 3, to the right", 0.0, 4.4, 3.8),
        Number::new("Sphere 3, upwards", -0.45, 0.45, -0.2),
        Number::new("d, to the right", 0.25, 2.0, 1.0),
        Number::new("d, upwards", -0.5, 0.5, 0.0),
        Number::new("Q, to the right", 0.0, 2.0, 0.0),
        Number::new("Q, upwards", -0.6, 0.6, 0.0),
        Number::whole("Turns", 0.0, 3.0, 3.0),
        Number::choice("The list", LISTS),
        Number::choice("The search", SEARCHES),
    ],
    handles: &[
        Handle {
            numbers: &[0, 1],
            drag: |numbers, to| put(&mut numbers[0..2], PLANE.place(to)),
        },
        Handle {
            numbers: &[2, 3],
            drag: |numbers, to| put(&mut numbers[2..4], PLANE.place(to)),
        },
        Handle {
            numbers: &[4, 5],
            drag: |numbers, to| put(&mut numbers[4..6], PLANE.place(to)),
        },
        Handle {
            numbers: &[6, 7],
            drag: |numbers, to| {
                let way = PLANE.place(to) - parameters(numbers, &Right).ray.origin;
                put(&mut numbers[6..8], way);
            },
        },
        Handle {
            numbers: &[8, 9],
            drag: |numbers, to| put(&mut numbers[8..10], PLANE.place(to)),
        },
    ],
    actions: &[Action {
        name: "Next turn",
        act: |numbers| numbers[10] = (numbers[10] + 1.0) % 4.0,
    }],
    answer,
};

const ORDERS: [[usize; 3]; 6] = [
    [0, 1, 2],
    [0, 2, 1],
    [1, 0, 2],
    [1, 2, 0],
    [2, 0, 1],
    [2, 1, 0],
];
const LISTS: &[&str] = &[
    "1, 2, 3", "1, 3, 2", "2, 1, 3", "2, 3, 1", "3, 1, 2", "3, 2, 1",
];

/// The search as it should be, and two slips: their names in the catalogue, and whether they
/// go on after a hit.
const SLIPS: [(&str, bool); 2] = [("first-hit-wins", false), ("closest-ignored", true)];
const SEARCHES: &[&str] = &[
    "as it should be",
    "returns at the first hit",
    "closest_so_far is not handed on",
];

/// The program of a reader who made a slip.
struct Slipped {
    program: Program,
    goes_on: bool,
}

impl Search for Slipped {
    fn winner(&self, list: &[(Point3, f64)], ray: &Ray) -> Option<(f64, usize)> {
        let ball = |&(center, radius)| Ball { center, radius };
        let own = std::array::from_fn(|n| list.get(n).map(ball));
        let program = Program {
            world: &PLACES[..list.len()],
            own,
            ..self.program
        };
        let (t, hit) = program.search(ray)?;
        let place = own.iter().position(|&it| it == Some(hit))?;
        Some((t, place))
    }

    fn t_max(&self, last_hit: Option<f64>) -> Option<f64> {
        (self.goes_on || last_hit.is_none()).then_some(self.program.t_max)
    }
}

/// Room for three spheres.
static PLACES: [Ball; 3] = [Ball::new(0.0, 0.0, 0.0, 0.0); 3];

fn answer(numbers: &[f64]) -> Answer {
    let slip = (numbers[12] as usize).checked_sub(1).map(|n| SLIPS[n]);
    let slipped = slip.and_then(|(name, goes_on)| {
        let program = slips::find(name)?.program(Chapter::HittableList);
        Some(Slipped { program, goes_on })
    });
    let right = parameters(numbers, &Right);
    let shown = match &slipped {
        Some(slipped) => parameters(numbers, slipped),
        None => right,
    };
    let held: Vec<String> = (0..=shown.turns)
        .map(|turns| Parameters { turns, ..shown }.held())
        .map(|held| in_digits(held.map_or(f64::INFINITY, |(t, _)| t)))
        .collect();
    let Ray { origin, .. } = shown.ray;
    let [one, two, three] = shown.spheres.map(|(center, _)| center);
    Answer {
        svg: draw(&shown),
        sentence: format!("{}{}", turn(&shown), end(&shown, &right)),
        handles: [one, two, three, shown.ray.at(1.0), origin]
            .map(|it| PLANE.point(it))
            .into(),
        says: vec![("held", held.join(", "))],
    }
}

fn parameters<'a>(numbers: &[f64], search: &'a dyn Search) -> Parameters<'a> {
    let &[
        x_1,
        y_1,
        x_2,
        y_2,
        x_3,
        y_3,
        d_x,
        d_y,
        q_x,
        q_y,
        turns,
        list,
        _,
    ] = numbers
    else {
        unreachable!("the figure has thirteen numbers")
    };
    let default = Parameters::default();
    let mut spheres = default.spheres;
    for (sphere, (x, y)) in spheres.iter_mut().zip([(x_1, y_1), (x_2, y_2), (x_3, y_3)]) {
        sphere.0 = Point3::new(x, y, 0.0);
    }
    Parameters {
        spheres,
        order: ORDERS[list as usize],
        ray: Ray::new(Point3::new(q_x, q_y, 0.0), Vec3::new(d_x, d_y, 0.0)),
        turns: turns as usize,
        search,
    }
}

/// What happened in the last turn.
fn turn(shown: &Parameters) -> String {
    let Some(Turn { sphere, t_max, hit }) = shown.turns().pop() else {
        return "No sphere has had its turn: the first one will be asked for every *t* above 0."
            .to_owned();
    };
    match (t_max.map(in_digits), hit.map(in_digits)) {
        (None, _) => format!("Sphere {sphere} is not asked: the search has returned."),
        (Some(end), None) => {
            format!("Sphere {sphere} is asked for 0 < *t* < {end}, and not hit there.")
        }
        (Some(end), Some(t)) => {
            format!("Sphere {sphere} is asked for 0 < *t* < {end}, and hit at {t}.")
        }
    }
}

/// What comes out when all had their turn.
fn end(shown: &Parameters, right: &Parameters) -> String {
    if shown.turns < shown.order.len() {
        return String::new();
    }
    match (shown.held(), right.held()) {
        (Some((t, sphere)), Some((nearest, nearer))) if t > nearest => format!(
            " Sphere {sphere} wins, and is painted over sphere {nearer}, which is nearer: its *t* is {}.",
            in_digits(nearest)
        ),
        (Some((_, sphere)), _) => format!(" Sphere {sphere} wins, and no other is nearer."),
        (None, _) => " No sphere is hit ahead of **Q**.".to_owned(),
    }
}

fn put(numbers: &mut [f64], place: Vec3) {
    (numbers[0], numbers[1]) = (place.x, place.y);
}
