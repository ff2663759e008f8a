//! A ray is a function: drag A, the tip of b, and P along the line.

use common::rtweekend::*;
use figures::ray::{PLANE, Parameters, draw};
use figures::spoken;

use crate::live::{Action, Answer, Handle, Live, Number};

/// The first figure that readers move.
pub(crate) const LIVE: Live = Live {
    name: "ray",
    question: "What becomes of *t* if **b** is twice as long, and **P** stays? Drag the tip of **b**, then \
        **P** back to where it was.",
    numbers: &[
        Number::new("A, to the right", -2.0, 4.0, 0.0),
        Number::new("A, upwards", -0.75, 2.5, 0.0),
        Number::new("b, to the right", -4.0, 4.0, 1.0),
        Number::new("b, upwards", -2.5, 2.5, 0.5),
        Number::new("t", -2.0, 4.0, 2.0),
    ],
    handles: &[
        Handle {
            numbers: &[0, 1],
            drag: |numbers, to| {
                let place = PLANE.place(to);
                (numbers[0], numbers[1]) = (place.x, place.y);
            },
        },
        Handle {
            numbers: &[2, 3],
            drag: |numbers, to| {
                let way = PLANE.place(to) - parameters(numbers).ray.origin;
                (numbers[2], numbers[3]) = (way.x, way.y);
            },
        },
        Handle {
            numbers: &[4],
            drag: |numbers, to| {
                let ray = parameters(numbers).ray;
                let way = PLANE.place(to) - ray.origin;
                numbers[4] = way.dot(ray.direction) / ray.direction.length_squared();
            },
        },
    ],
    actions: &[
        Action {
            name: "Double b, keep P",
            act: |numbers| stretch(numbers, 2.0),
        },
        Action {
            name: "Halve b, keep P",
            act: |numbers| stretch(numbers, 0.5),
        },
        Action {
            name: "P behind A",
            act: |numbers| numbers[4] = -1.0,
        },
    ],
    answer,
};

fn answer(numbers: &[f64]) -> Answer {
    let parameters = parameters(numbers);
    let Parameters { ray, t } = parameters;
    let length = ray.direction.length();
    let [t_said, length_said] = [t, length].map(spoken);
    let distance = spoken(t.abs() * length);
    let side = match t {
        ..0.0 => " behind",
        0.0 => "",
        _ => " ahead of",
    };
    Answer {
        svg: draw(&parameters),
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

fn parameters(numbers: &[f64]) -> Parameters {
    let &[a_x, a_y, b_x, b_y, t] = numbers else {
        unreachable!("the figure has five numbers")
    };
    Parameters {
        ray: Ray::new(Point3::new(a_x, a_y, 0.0), Vec3::new(b_x, b_y, 0.0)),
        t,
    }
}

/// Makes b longer or shorter by a `factor`, where there is room, and leaves P in its place.
fn stretch(numbers: &mut [f64], factor: f64) {
    let mut stretched = [
        numbers[2] * factor,
        numbers[3] * factor,
        numbers[4] / factor,
    ];
    let before = stretched;
    for (value, number) in stretched.iter_mut().zip(&LIVE.numbers[2..]) {
        *value = value.clamp(number.least, number.most);
    }
    if stretched == before {
        numbers[2..].copy_from_slice(&stretched);
    }
}
