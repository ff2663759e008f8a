//! A predicate map: the edge of a sphere, from the whole ball down to single ulps. A reader
//! zooms into it until it frays.

use std::sync::LazyLock;

use speed_vs_accuracy::{Case, D_BAND, Method, Precision, Stage, beside, stage_of_hit, tangent};

use crate::vocabulary::*;

parameters! {
    doublings: f64 = Number::whole("Size of a cell: doublings of an ulp", 0.0, MOST_DOUBLINGS, 0.0);
    cell: Vec3 =
        in_cells("Cell, to the right of the middle", 4.0),
        in_cells("Cell, above the middle", 2.0);
    tangent: Vec3 =
        in_cells("Tangent, to the right of the middle", 0.0),
        in_cells("Tangent, above the middle", 0.0);
    method: f64 = Number::choice(
        "The method at the left",
        &[METHODS[0].name, METHODS[1].name, METHODS[2].name],
    );
}

/// The choices of a method.
const METHODS: [Method; 3] = [Method::HALF_B, Method::CROSS_Q, Method::DOUBLE_DOUBLE];

/// A place on a map, in cells from its middle.
const fn in_cells(name: &'static str, default: f64) -> Number {
    Number::whole(name, -REACH as f64, REACH as f64, default)
}

/// The figure, as a reader moves it.
pub(crate) static LIVE: Live<Parameters> = Live {
    figure: Figure {
        name: "edge",
        title: "The edge, ulp by ulp",
        description: "Two maps side by side, of the same neighboring rays: cells in rows and columns, hits \
            at the lower left and misses at the upper right. In the left map, by half_b, cells along the \
            border are marked in a broad band: there it decides wrongly. In the right map, by certified_hit, \
            the border is straight, and all cells are shaded that integers had to decide. Below is an axis of \
            how large a cell is, from two to the power of 48 ulps to a single one, with a mark at the end.",
        caption: "Each cell is a ray, the same on the left and on the right; the circle is a tangent, the square \
            is the chosen ray. Tinted cells are hits. On the left the cells are marked that the method decides \
            wrongly, on the right those that the filter leaves to integers.",
        draw: || LIVE.on_page(),
    },
    question: "How far must you zoom in before the edge is ragged? Begin with the whole ball, zoom in, and then \
        choose a marked cell. Which method is wrong there?",
    solution: "Until a step from cell to cell changes *D* by less than its rounding error. Then the method on the left \
        is wrong. On the right integers decide, which are never rounded.",
    handles: &[
        point!(SIZES, doublings),
        point!(MAPS[0], cell),
        point!(MAPS[1], tangent),
    ],
    actions: &[
        ("The whole ball", |it| {
            (it.doublings, it.tangent) = (49.0, xy(6.0, 3.0));
        }),
        ("16 times closer", |it| {
            it.doublings = (it.doublings - 4.0).max(0.0);
        }),
        ("One ulp", |it| {
            (it.doublings, it.tangent) = (0.0, Vec3::ZERO);
        }),
    ],
    answer,
};

fn answer(it: &Parameters) -> Answer {
    let decisions = it.decisions();
    let wrong = decisions.iter().filter(|it| it.is_wrong()).count();
    let chosen = it.decision(it.cell);
    let case = it.case(it.cell);
    let name = it.method().name;
    let found = if chosen.found { "hit" } else { "miss" };
    let verdict = if chosen.is_wrong() { "wrong" } else { "right" };
    let sentence = format!(
        "In the chosen cell {name} says {found}, and is {verdict}. {} On this map {name} is wrong in {wrong} of \
        {} cells.",
        of_stage(chosen.stage, &case),
        decisions.len()
    );
    let says = vec![
        ("step", ulps(it.doublings)),
        ("method", name.to_owned()),
        ("wrong", wrong.to_string()),
    ];
    Answer::new(draw(it, &decisions), sentence, says)
}

/// Why that stage answered.
fn of_stage(stage: Stage, case: &Case) -> String {
    let (computed, bound) = (case.discriminant(), bound(case));
    let [d, band] = [computed, bound].map(printed);
    let found = format!("The filter's *D* is {d}, give or take {band}");
    let name = match stage {
        Stage::Filter => return format!("{found}, so its sign is certain."),
        Stage::FixedWidth => "integers of fixed width",
        Stage::Exact => "integers of any length",
    };
    let why = if computed.abs() <= bound {
        "it may have either sign"
    } else {
        "its sign is certain, but not yet the root"
    };
    format!("{found}: {why}. The answer comes from {name}.")
}

/// The cells lie from so many to the left of the middle to so many to the right.
const REACH: i32 = 12;
const CELLS: usize = 2 * REACH as usize + 1;

/// In so few doublings a cell becomes an eighth, and the map thrice the ball.
const MOST_DOUBLINGS: f64 = 50.0;

/// Where each map is on the sheet, in cells from its middle: the plain method's first.
const MAPS: [Plane; 2] = [
    Plane::new(98.0, 118.0, SIDE),
    Plane::new(302.0, 118.0, SIDE),
];
const SIDE: f64 = 7.5;

/// The sizes of a cell.
const SIZES: Axis = Axis::new(20.0, 258.0, 360.0, 0.0, MOST_DOUBLINGS);

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

/// By so much the filter's D is off at most.
fn bound(case: &Case) -> f64 {
    D_BAND * case.a() * case.m()
}

impl Parameters {
    /// The method that decides in the left map.
    fn method(&self) -> Method {
        METHODS[self.method as usize]
    }

    /// The ray of a cell: from one to the next its origin moves by two to the power of the
    /// doublings, in ulps.
    fn case(&self, cell: Vec3) -> Case {
        static TANGENT: LazyLock<Case> = LazyLock::new(|| tangent(Precision::Double));
        let ulps = (1_u64 << self.doublings as u8) as f64 * (cell - self.tangent);
        beside(&TANGENT, Precision::Double, ulps.x, ulps.y)
    }

    /// What is decided about the ray of a cell: whether its line meets the sphere.
    fn decision(&self, cell: Vec3) -> Decision {
        let case = self.case(cell);
        let (t_min, t_max) = (f64::NEG_INFINITY, f64::INFINITY);
        let hits = |method| case.put_to(method, t_min, t_max).is_some();
        Decision {
            found: hits(&self.method()),
            hits: hits(&Method::CERTIFIED_HIT),
            stage: stage_of_hit(case.center, case.radius, &case.ray, t_min, t_max),
        }
    }

    /// The decisions of all cells, row by row from above.
    fn decisions(&self) -> Vec<Decision> {
        let rows = (-REACH..=REACH).rev();
        rows.flat_map(|up| (-REACH..=REACH).map(move |right| xy(right.into(), up.into())))
            .map(|cell| self.decision(cell))
            .collect()
    }
}

/// Draws both maps of these decisions, and the axis of sizes.
fn draw(it: &Parameters, decisions: &[Decision]) -> Svg {
    let mut svg = LIVE.figure.sheet(304.0);
    let set = |of: fn(&Decision) -> bool| decisions.iter().map(of).collect::<Vec<bool>>();
    let (hits, wrong) = (set(|it| it.hits), set(Decision::is_wrong));
    let words = format!("wrong: {}", wrong.iter().filter(|it| **it).count());
    let cells = [("sphere wash", hits.clone()), (WRONG, wrong)];
    draw_map(&mut svg, it, MAPS[0], it.method().name, &cells);
    svg.key(WRONG, DVec2::new(4.0, 218.0), &words);
    let cells = [
        ("sphere wash", hits),
        (INTEGERS, set(|it| it.stage > Stage::Filter)),
    ];
    draw_map(&mut svg, it, MAPS[1], "certified_hit", &cells);
    svg.key(INTEGERS, DVec2::new(208.0, 218.0), "integers");
    draw_sizes(&mut svg, it.doublings);
    svg
}

/// How cells are marked that are decided wrongly, and those that integers had to decide.
const WRONG: &str = "wrong solid";
const INTEGERS: &str = "depth-3 certain solid";

/// A map: cells of each class, the tangent and the chosen cell.
fn draw_map(svg: &mut Svg, it: &Parameters, map: Plane, name: &str, cells: &[(&str, Vec<bool>)]) {
    let half = 0.5 * SIDE * CELLS as f64;
    let corner = map.origin - half;
    svg.label("ink", map.origin.down(-half - 8.0), Middle, name);
    Frame { corner, side: SIDE }.map(svg, CELLS, cells);
    svg.circle("ink line", map.point(it.tangent), 4.0);
    let chosen = map.point(it.cell) - 0.5 * SIDE;
    svg.rect("ink line", chosen, DVec2::splat(SIDE));
}

fn draw_sizes(svg: &mut Svg, doublings: f64) {
    SIZES.draw(svg, &ticks([0.0, 16.0, 32.0, 48.0].into_iter(), ulps));
    svg.circle("ray solid", SIZES.point(doublings), 4.5);
    let words = format!("from cell to cell: {}", ulps(doublings));
    svg.small_label("ink", SIZES.point(24.0).down(38.0), Middle, &words);
}

/// An ulp, doubled so many times.
fn ulps(doublings: f64) -> String {
    match doublings {
        0.0 => "1 ulp".to_owned(),
        _ => format!("2{} ulps", raised(doublings as i32)),
    }
}
