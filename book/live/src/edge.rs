//! The edge, ulp by ulp: zoom into it until it frays.

use figures::edge::{
    Decision, Discriminants, MIDDLES, MOST_DOUBLINGS, Parameters, REACH, cell_at, doublings_at,
    draw, on_axis, on_map, ulps,
};
use figures::number::printed;
use glam::DVec2;
use speed_vs_accuracy::{Method, Stage};

use crate::live::{Action, Answer, Handle, Live, Number};

/// Which method decides what.
pub(crate) const LIVE: Live = Live {
    name: "edge",
    question: "How close must you look before the edge frays? Begin with the whole ball, zoom in, and then \
        choose a cell that is marked. Who is wrong there?",
    numbers: &[
        Number::whole(
            "Size of a cell: doublings of an ulp",
            0.0,
            MOST_DOUBLINGS as f64,
            0.0,
        ),
        in_cells("Cell, to the right of the middle", 4.0),
        in_cells("Cell, above the middle", 2.0),
        in_cells("Tangent, to the right of the middle", 0.0),
        in_cells("Tangent, above the middle", 0.0),
        Number::choice(
            "The method at the left",
            &[
                METHODS[0].name,
                METHODS[1].name,
                METHODS[2].name,
                METHODS[3].name,
            ],
        ),
    ],
    handles: &[
        Handle {
            numbers: &[0],
            drag: |numbers, to| numbers[0] = doublings_at(to),
        },
        Handle {
            numbers: &[1, 2],
            drag: |numbers, to| [numbers[1], numbers[2]] = cell_at(MIDDLES[0], to).to_array(),
        },
        Handle {
            numbers: &[3, 4],
            drag: |numbers, to| [numbers[3], numbers[4]] = cell_at(MIDDLES[1], to).to_array(),
        },
    ],
    actions: &[
        Action {
            name: "The whole ball",
            act: |numbers| [numbers[0], numbers[3], numbers[4]] = [49.0, 6.0, 3.0],
        },
        Action {
            name: "16 times closer",
            act: |numbers| numbers[0] = (numbers[0] - 4.0).max(0.0),
        },
        Action {
            name: "One ulp",
            act: |numbers| [numbers[0], numbers[3], numbers[4]] = [0.0; 3],
        },
    ],
    answer,
};

/// The choices of a method.
const METHODS: [Method; 4] = [
    Method::HALF_B,
    Method::KAHAN_Q,
    Method::CROSS_Q,
    Method::DOUBLE_DOUBLE,
];

/// A place on a map, in cells from its middle.
const fn in_cells(name: &'static str, default: f64) -> Number {
    Number::whole(name, -REACH as f64, REACH as f64, default)
}

fn answer(numbers: &[f64]) -> Answer {
    let parameters = parameters(numbers);
    let decisions = parameters.decisions();
    let wrong = decisions
        .iter()
        .filter(|it| it.is_wrong())
        .count()
        .to_string();
    let chosen = parameters.decision(parameters.cell);
    Answer {
        svg: draw(&parameters, &decisions),
        sentence: format!(
            "{} {} On this map {} is wrong in {wrong} of {} cells.",
            of_method(parameters.method.name, &chosen),
            of_stage(chosen.stage, &parameters.discriminants()),
            parameters.method.name,
            decisions.len()
        ),
        handles: vec![
            on_axis(parameters.doublings.into()),
            on_map(MIDDLES[0], parameters.cell),
            on_map(MIDDLES[1], parameters.tangent),
        ],
        says: vec![
            ("step", ulps(parameters.doublings)),
            ("method", parameters.method.name.to_owned()),
            ("wrong", wrong),
        ],
    }
}

fn parameters(numbers: &[f64]) -> Parameters {
    let cell = |n: usize| DVec2::new(numbers[n], numbers[n + 1]);
    Parameters {
        doublings: numbers[0] as u8,
        cell: cell(1),
        tangent: cell(3),
        method: METHODS[numbers[5] as usize],
    }
}

/// What the plain method says of the chosen cell.
fn of_method(name: &str, decision: &Decision) -> String {
    let found = if decision.found { "hit" } else { "miss" };
    let verdict = match decision.is_wrong() {
        true => "and is wrong",
        false => "and is right",
    };
    format!("In the chosen cell {name} says {found}, {verdict}.")
}

/// Why that stage answered.
fn of_stage(stage: Stage, numbers: &Discriminants) -> String {
    let found = format!(
        "The filter's *D* is {}, give or take {}",
        printed(numbers.computed),
        printed(numbers.bound)
    );
    let who = match stage {
        Stage::Filter => return format!("{found}, so its sign is certain."),
        Stage::Rescaled => "the filter in other units",
        Stage::Sharper => "the sharper filter",
        Stage::FixedWidth => "integers of fixed width",
        Stage::Exact => "integers of any length",
    };
    let why = match numbers.computed.abs() <= numbers.bound {
        true => "it may have either sign",
        false => "its sign is certain, but not yet the root",
    };
    format!("{found}: {why}. The answer comes from {who}.")
}
