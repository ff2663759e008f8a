//! The contract: what each function of the chapters answers where formulas end. The table
//! stands on the page of all methods; here each of its cells is asked.

use std::fmt::Write;

use hittable_list::{Hittable, Sphere};
use laws::Case;
use speed_vs_accuracy::find;

const NAN: f64 = f64::NAN;
const INF: f64 = f64::INFINITY;

/// What is asked, in the words of the page; center and radius, origin and direction, and the
/// range of t.
type Row = (&'static str, [f64; 4], [f64; 6], [f64; 2]);

/// The ball of chapter 3, and its ray straight ahead: the roots are ½ and 1½.
const BALL: [f64; 4] = [0.0, 0.0, -1.0, 0.5];
const AHEAD: [f64; 6] = [0.0, 0.0, 0.0, 0.0, 0.0, -1.0];
const ALL: [f64; 2] = [0.0, INF];

const ROWS: &[Row] = &[
    ("straight ahead, for comparison", BALL, AHEAD, ALL),
    (
        "$r = 0$, the line through the center",
        [0.0, 0.0, -1.0, 0.0],
        AHEAD,
        ALL,
    ),
    (
        "$r = 0$, a line beside it",
        [0.0, 0.0, -1.0, 0.0],
        [0.0, 1.0, 0.0, 0.0, 0.0, -1.0],
        ALL,
    ),
    ("$r = -½$", [0.0, 0.0, -1.0, -0.5], AHEAD, ALL),
    ("$r$ is NaN", [0.0, 0.0, -1.0, NAN], AHEAD, ALL),
    ("$r = ∞$", [0.0, 0.0, -1.0, INF], AHEAD, ALL),
    ("the direction is 0", BALL, [0.0; 6], ALL),
    (
        "the direction is subnormal, 2⁻¹⁰⁶⁰ long",
        BALL,
        [0.0, 0.0, 0.0, 0.0, 0.0, -8.095e-320],
        ALL,
    ),
    (
        "the direction is 10²⁰⁰ long",
        BALL,
        [0.0, 0.0, 0.0, 0.0, 0.0, -1e200],
        ALL,
    ),
    (
        "from the surface, outwards",
        [0.0, 0.0, 0.0, 1.0],
        [1.0, 0.0, 0.0, 1.0, 0.0, 0.0],
        ALL,
    ),
    (
        "from the surface, inwards",
        [0.0, 0.0, 0.0, 1.0],
        [1.0, 0.0, 0.0, -1.0, 0.0, 0.0],
        ALL,
    ),
    ("from the center", [0.0, 0.0, 0.0, 1.0], AHEAD, ALL),
    (
        "from inside",
        [0.0, 0.0, 0.0, 2.0],
        [0.0, 0.0, 1.0, 0.0, 0.0, -1.0],
        ALL,
    ),
    (
        "away from the sphere",
        BALL,
        [0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
        ALL,
    ),
    (
        "a tangent",
        [0.0, 0.0, 0.0, 1.0],
        [1.0, 0.0, 2.0, 0.0, 0.0, -1.0],
        ALL,
    ),
    (
        "a tangent from its point of contact",
        [0.0, 0.0, 0.0, 1.0],
        [1.0, 0.0, 0.0, 0.0, 0.0, -1.0],
        ALL,
    ),
    ("$t_{min}$ is the nearer root", BALL, AHEAD, [0.5, INF]),
    ("$t_{max}$ is the nearer root", BALL, AHEAD, [0.0, 0.5]),
    ("$t_{min}$ is NaN", BALL, AHEAD, [NAN, INF]),
    ("$t_{max}$ is NaN", BALL, AHEAD, [0.0, NAN]),
    ("$t_{min} > t_{max}$", BALL, AHEAD, [1.0, 0.0]),
    (
        "the origin is NaN",
        BALL,
        [NAN, 0.0, 0.0, 0.0, 0.0, -1.0],
        ALL,
    ),
    (
        "the origin is at ∞",
        BALL,
        [0.0, 0.0, INF, 0.0, 0.0, -1.0],
        ALL,
    ),
    (
        "the direction is NaN",
        BALL,
        [0.0, 0.0, 0.0, NAN, 0.0, -1.0],
        ALL,
    ),
    (
        "the direction is infinite",
        BALL,
        [0.0, 0.0, 0.0, 0.0, 0.0, -INF],
        ALL,
    ),
    ("the center is NaN", [NAN, 0.0, -1.0, 0.5], AHEAD, ALL),
    ("the center is at −∞", [0.0, 0.0, -INF, 0.5], AHEAD, ALL),
    (
        "$h^2$ overflows, $a$ and $c$ do not",
        [0.0, 0.0, -1e100, 5e99],
        [0.0, 0.0, 0.0, 0.0, 0.0, -1e100],
        ALL,
    ),
    ("$c$ overflows", [0.0, 0.0, -1e160, 5e159], AHEAD, ALL),
    ("$c$ underflows", [0.0, 0.0, -1e-170, 5e-171], AHEAD, ALL),
];

#[test]
fn each_cell_of_the_table_on_the_page_is_what_the_function_answers() {
    let page = include_str!("../../../book/notes/methods.md");
    let table = page.split("## The contract\n").nth(1).expect("a section");
    let mut lines = table.lines().filter(|line| line.starts_with('|'));
    let head = lines.next().expect("the page has the table");
    let columns: Vec<Vec<&str>> = cells(head).skip(1).map(names).collect();
    let mut expected = String::new();
    for &(name, sphere, ray, range) in ROWS {
        let _ = write!(expected, "| {name} |");
        for column in &columns {
            let mut answers = column
                .iter()
                .map(|function| answer(function, sphere, ray, range));
            let first = answers.next().expect("a column has a name");
            assert!(
                answers.all(|other| other == first),
                "{name}: {column:?} are not alike"
            );
            let _ = write!(expected, " {first} |");
        }
        expected.push('\n');
    }
    let found: String = lines
        .skip(1)
        .take(ROWS.len())
        .map(|line| format!("{line}\n"))
        .collect();
    assert!(found == expected, "the table should be\n{expected}");
}

fn cells(line: &str) -> impl Iterator<Item = &str> {
    line.trim_matches('|').split('|').map(str::trim)
}

/// The functions in the head of a column, which all answer alike.
fn names(head: &str) -> Vec<&str> {
    head.split('`').skip(1).step_by(2).collect()
}

/// `t`, or what else is answered.
fn answer(
    function: &str,
    [x, y, z, radius]: [f64; 4],
    ray: [f64; 6],
    [t_min, t_max]: [f64; 2],
) -> String {
    let [qx, qy, qz, dx, dy, dz] = ray;
    let case = Case::from_numbers([x, y, z, radius, qx, qy, qz, dx, dy, dz]);
    let Case {
        center,
        radius,
        ray,
    } = case;
    let t = match function {
        "red_sphere" => {
            let is_hit = red_sphere::hit_sphere(center, radius, &ray);
            return if is_hit { "hit" } else { "miss" }.to_owned();
        }
        "normals" => normals::hit_sphere(center, radius, &ray),
        "half_b_sphere" => half_b_sphere::hit_sphere(center, radius, &ray),
        "Sphere::hit" => Sphere::new(center, radius)
            .hit(&ray, t_min, t_max)
            .map(|hit| hit.t),
        name => case.put_to(&find(name).expect("a method"), t_min, t_max),
    };
    match t {
        None => "miss".to_owned(),
        Some(t) if t.is_infinite() || (t != 0.0 && !(1e-3..1e4).contains(&t.abs())) => {
            format!("{t:.3e}").replace("-", "−")
        }
        Some(t) => t.to_string().replace("-", "−"),
    }
}
