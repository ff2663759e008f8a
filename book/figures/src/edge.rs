//! A predicate map: the edge of a sphere, from the whole ball down to single ulps. A reader
//! zooms into it until it frays.

use std::sync::LazyLock;

use glam::DVec2;
use speed_vs_accuracy::{
    Case, D_BAND, Method, Precision, Stage, beside, exact_discriminant, stage_of_hit, tangent,
};

use crate::figure::Figure;
use crate::live::{Action, Answer, Handle, Live, Number, parameters};
use crate::number::{printed, raised};
use crate::svg::{Anchor, Svg};

/// The words of this figure.
pub(crate) const FIGURE: Figure = Figure {
    name: "edge",
    title: "The edge, ulp by ulp",
    description: "Two maps side by side, of the same neighboring rays: cells in rows and columns, hits \
        at the lower left and misses at the upper right. In the left map, by half_b, cells along the \
        border are marked in a broad band: there it decides wrongly. In the right map, by certified_hit, \
        the border is straight, and all cells are shaded that integers had to decide. Below is an axis of \
        how large a cell is, from two to the power of 48 ulps to a single one, with a mark at the end. \
        Below that is an axis of D with a bar around 0 on it, which is the bound, and two marks: D as it \
        is computed, and D as it is.",
    caption: "Each cell is a ray, the same on the left and on the right; the circle is a tangent, the square \
        is the chosen ray. Tinted cells are hits. On the left the cells are marked that the method decides \
        wrongly, on the right those that the first filter leaves to later stages.",
    draw: || LIVE.on_page(),
};

parameters! {
    doublings: Number::whole(
        "Size of a cell: doublings of an ulp",
        0.0,
        MOST_DOUBLINGS as f64,
        0.0,
    ),
    right: in_cells("Cell, to the right of the middle", 4.0),
    up: in_cells("Cell, above the middle", 2.0),
    tangent_right: in_cells("Tangent, to the right of the middle", 0.0),
    tangent_up: in_cells("Tangent, above the middle", 0.0),
    method: Number::choice(
        "The method at the left",
        &[
            METHODS[0].name,
            METHODS[1].name,
            METHODS[2].name,
        ],
    ),
}

/// The choices of a method.
const METHODS: [Method; 3] = [Method::HALF_B, Method::CROSS_Q, Method::DOUBLE_DOUBLE];

/// A place on a map, in cells from its middle.
const fn in_cells(name: &'static str, default: f64) -> Number {
    Number::whole(name, -REACH as f64, REACH as f64, default)
}

/// The figure, as a reader moves it.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: FIGURE,
    question: "How far must you zoom in before the edge is ragged? Begin with the whole ball, zoom in, and then \
        choose a marked cell. Which method is wrong there?",
    solution: "Until a step from cell to cell changes *D* by less than its rounding error. Then the method on the left \
        is wrong. On the right integers decide, which are never rounded.",
    handles: &[
        Handle::new(&["doublings"], |it, to| it.doublings = doublings_at(to)),
        Handle::new(&["right", "up"], |it, to| {
            [it.right, it.up] = cell_at(MIDDLES[0], to).to_array();
        }),
        Handle::new(&["tangent_right", "tangent_up"], |it, to| {
            [it.tangent_right, it.tangent_up] = cell_at(MIDDLES[1], to).to_array();
        }),
    ],
    actions: &[
        Action::new("The whole ball", |it| {
            [it.doublings, it.tangent_right, it.tangent_up] = [49.0, 6.0, 3.0];
        }),
        Action::new("16 times closer", |it| {
            it.doublings = (it.doublings - 4.0).max(0.0);
        }),
        Action::new("One ulp", |it| {
            [it.doublings, it.tangent_right, it.tangent_up] = [0.0; 3];
        }),
    ],
    answer,
};

impl Parameters {
    fn map(&self) -> Map {
        Map {
            method: METHODS[self.method as usize],
            doublings: self.doublings as u8,
            tangent: DVec2::new(self.tangent_right, self.tangent_up),
            cell: DVec2::new(self.right, self.up),
        }
    }
}

/// Neighboring rays beside a tangent.
struct Map {
    /// Who decides in the left map.
    method: Method,
    /// From cell to cell the origin moves by two to this power ulps.
    doublings: u8,
    /// How many cells the tangent is from the middle, to the right and upwards.
    tangent: DVec2,
    /// The chosen cell, counted from the middle.
    cell: DVec2,
}

fn answer(parameters: &Parameters) -> Answer {
    let map = parameters.map();
    let decisions = map.decisions();
    let wrong = decisions
        .iter()
        .filter(|it| it.is_wrong())
        .count()
        .to_string();
    let chosen = map.decision(map.cell);
    Answer {
        drawing: draw(&map, &decisions),
        sentence: format!(
            "{} {} On this map {} is wrong in {wrong} of {} cells.",
            of_method(map.method.name, &chosen),
            of_stage(chosen.stage, &map.discriminants()),
            map.method.name,
            decisions.len()
        ),
        handles: vec![
            on_axis(map.doublings.into()),
            on_map(MIDDLES[0], map.cell),
            on_map(MIDDLES[1], map.tangent),
        ],
        says: vec![
            ("step", ulps(map.doublings)),
            ("method", map.method.name.to_owned()),
            ("wrong", wrong),
        ],
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

/// The cells lie from so many to the left of the middle to so many to the right.
const REACH: i32 = 12;
const CELLS: usize = 2 * REACH as usize + 1;

/// In so few doublings a cell becomes an eighth, and the map thrice the ball.
const MOST_DOUBLINGS: u8 = 50;

/// Where the middle of each map is on the sheet, the plain method's first.
const MIDDLES: [DVec2; 2] = [DVec2::new(98.0, 118.0), DVec2::new(302.0, 118.0)];
const SIDE: f64 = 7.5;

/// Where on the sheet a cell of a map is.
fn on_map(middle: DVec2, cell: DVec2) -> DVec2 {
    middle + SIDE * DVec2::new(cell.x, -cell.y)
}

/// Which cell is there on the sheet.
fn cell_at(middle: DVec2, at: DVec2) -> DVec2 {
    let way = (at - middle) / SIDE;
    DVec2::new(way.x, -way.y)
}

/// Where on the axis of sizes cells of so many doublings are.
fn on_axis(doublings: f64) -> DVec2 {
    DVec2::new(20.0 + 7.2 * doublings, 258.0)
}

/// How many doublings are there on the sheet.
fn doublings_at(at: DVec2) -> f64 {
    (at.x - 20.0) / 7.2
}

/// What is decided about a ray, and by whom.
struct Decision {
    /// Whether the plain method says that it hits.
    found: bool,
    /// Whether it does, as `certified_hit` proves.
    hits: bool,
    /// The stage of `certified_hit` that decided.
    stage: Stage,
}

impl Decision {
    /// Whether the plain method is wrong.
    fn is_wrong(&self) -> bool {
        self.found != self.hits
    }
}

/// D of a ray, its bound, and what it should be.
struct Discriminants {
    /// D, as the filter has it.
    computed: f64,
    /// It is off by so much at most.
    bound: f64,
    /// D, to within an ulp.
    exact: f64,
}

impl Map {
    /// The ray of a cell.
    fn case(&self, cell: DVec2) -> Case {
        static TANGENT: LazyLock<Case> = LazyLock::new(|| tangent(Precision::Double));
        let ulps = (1_u64 << self.doublings) as f64 * (cell - self.tangent);
        beside(&TANGENT, Precision::Double, ulps.x, ulps.y)
    }

    /// What is decided about the ray of a cell: whether its line meets the sphere.
    fn decision(&self, cell: DVec2) -> Decision {
        let case = self.case(cell);
        let (t_min, t_max) = (f64::NEG_INFINITY, f64::INFINITY);
        let hits = |method| case.put_to(method, t_min, t_max).is_some();
        Decision {
            found: hits(&self.method),
            hits: hits(&Method::CERTIFIED_HIT),
            stage: stage_of_hit(case.center, case.radius, &case.ray, t_min, t_max),
        }
    }

    /// The decisions of all cells, row by row from above.
    fn decisions(&self) -> Vec<Decision> {
        let reach = -REACH..=REACH;
        let rows = reach.clone().rev();
        rows.flat_map(|up| reach.clone().map(move |right| (right, up)))
            .map(|(right, up)| self.decision(DVec2::new(right.into(), up.into())))
            .collect()
    }

    /// The numbers of the chosen cell.
    fn discriminants(&self) -> Discriminants {
        let case = self.case(self.cell);
        let exact = exact_discriminant(case.center, case.radius, &case.ray);
        Discriminants {
            computed: case.discriminant(),
            bound: D_BAND * case.a() * case.m(),
            exact: exact.expect("finite numbers"),
        }
    }
}

/// Draws both maps of these decisions, the axis of sizes, and D of the chosen cell.
fn draw(map: &Map, decisions: &[Decision]) -> Svg {
    let mut svg = FIGURE.sheet(400.0, 378.0);
    draw_plain(&mut svg, map, decisions);
    draw_certified(&mut svg, map, decisions);
    draw_axis(&mut svg, map.doublings);
    draw_discriminants(&mut svg, &map.discriminants());
    svg
}

fn draw_plain(svg: &mut Svg, map: &Map, decisions: &[Decision]) {
    let name = map.method.name;
    let hits: Vec<bool> = decisions.iter().map(|it| it.hits).collect();
    let wrong: Vec<bool> = decisions.iter().map(Decision::is_wrong).collect();
    let cells = [("sphere wash", &hits[..]), (WRONG, &wrong)];
    draw_map(svg, map, MIDDLES[0], name, &cells);
    let count = wrong.iter().filter(|it| **it).count();
    explain(svg, MIDDLES[0], WRONG, &format!("wrong: {count}"));
}

fn draw_certified(svg: &mut Svg, map: &Map, decisions: &[Decision]) {
    let set = |of: fn(&Decision) -> bool| decisions.iter().map(of).collect::<Vec<bool>>();
    let cells = [
        ("sphere wash", &set(|it| it.hits)[..]),
        (SHARPER, &set(|it| it.stage == Stage::Sharper)),
        (INTEGERS, &set(|it| it.stage >= Stage::FixedWidth)),
    ];
    draw_map(svg, map, MIDDLES[1], "certified_hit", &cells);
    explain(svg, MIDDLES[1], SHARPER, "sharper filter");
    let beside = MIDDLES[1] + DVec2::new(110.0, 0.0);
    explain(svg, beside, INTEGERS, "integers");
}

/// How cells are marked that are decided wrongly, and those that later stages than the
/// first filter had to decide.
const WRONG: &str = "wrong solid";
const SHARPER: &str = "depth-2 certain solid";
const INTEGERS: &str = "depth-3 certain solid";

/// A map: cells of each class, the tangent and the chosen cell.
fn draw_map(svg: &mut Svg, map: &Map, middle: DVec2, name: &str, cells: &[(&str, &[bool])]) {
    let half = 0.5 * SIDE * CELLS as f64;
    let corner = middle - DVec2::splat(half);
    let above = middle - DVec2::new(0.0, half + 8.0);
    svg.label("ink", above, Anchor::Middle, name);
    svg.group("pixels", |svg| {
        for (class, cells) in cells {
            svg.cells(class, corner, SIDE, CELLS, cells);
        }
    });
    svg.rect("faint thin", corner, DVec2::splat(2.0 * half));
    let tangent = on_map(middle, map.tangent);
    svg.circle("ink line", tangent, 4.0);
    let chosen = on_map(middle, map.cell) - DVec2::splat(0.5 * SIDE);
    svg.rect("ink line", chosen, DVec2::splat(SIDE));
}

/// What cells of a class mean, below the map with that `middle`.
fn explain(svg: &mut Svg, middle: DVec2, class: &str, words: &str) {
    let corner = middle + DVec2::new(-0.5 * SIDE * CELLS as f64, 100.0);
    svg.rect(class, corner, DVec2::splat(12.0));
    let beside = corner + DVec2::new(18.0, 11.0);
    svg.small_label("ink", beside, Anchor::Start, words);
}

fn draw_axis(svg: &mut Svg, doublings: u8) {
    let [start, end] = [0.0, f64::from(MOST_DOUBLINGS)].map(on_axis);
    svg.line("ink line", start, end);
    for tick in [0, 16, 32, 48] {
        let at = on_axis(tick.into());
        svg.line("ink line", at, at + DVec2::new(0.0, 5.0));
        let below = at + DVec2::new(0.0, 23.0);
        svg.small_label("faint", below, Anchor::Middle, &ulps(tick));
    }
    svg.circle("ray solid", on_axis(doublings.into()), 4.5);
    let below = on_axis(24.0) + DVec2::new(0.0, 38.0);
    let words = format!("from cell to cell: {}", ulps(doublings));
    svg.small_label("ink", below, Anchor::Middle, &words);
}

/// An ulp, doubled so many times.
fn ulps(doublings: u8) -> String {
    match doublings {
        0 => "1 ulp".to_owned(),
        _ => format!("2{} ulps", raised(doublings.into())),
    }
}

/// An axis of D around 0, counted in bounds.
fn draw_discriminants(svg: &mut Svg, numbers: &Discriminants) {
    let &Discriminants {
        computed,
        bound,
        exact,
    } = numbers;
    let at = |value: f64| DVec2::new(200.0 + 70.0 * (value / bound).clamp(-2.4, 2.4), 334.0);
    svg.arrow(
        "ink line",
        at(-f64::MAX),
        at(f64::MAX) + DVec2::new(12.0, 0.0),
    );
    let below = DVec2::new(0.0, 6.0);
    svg.rect(
        "viewport wash",
        at(-bound) - below,
        at(bound) - at(-bound) + 2.0 * below,
    );
    for (value, words) in [(-bound, "−bound"), (0.0, "0"), (bound, "bound")] {
        svg.line("viewport line", at(value) - below, at(value) + below);
        let beneath = at(value) + DVec2::new(0.0, 20.0);
        svg.small_label("viewport", beneath, Anchor::Middle, words);
    }
    let down = DVec2::new(0.0, 10.0);
    svg.line("ink bold", at(exact) - down, at(exact) + down);
    svg.circle("ray solid", at(computed), 4.5);
    for (idea, value, name, down) in [
        ("ray", computed, "the filter's *D*", -16.0),
        ("ink", exact, "*D* exactly", 37.0),
    ] {
        // So that the words stay on the sheet.
        let x = at(value).x.clamp(100.0, 300.0);
        let words = format!("{name}: {}", printed(value));
        let place = DVec2::new(x, at(value).y + down);
        svg.small_label(idea, place, Anchor::Middle, &words);
    }
}
