//! The contract: what each function of the chapters answers where formulas end. The table
//! stands on the page of all methods; here each of its cells is asked.

use std::fmt::Write;

use common::rtweekend::*;
use hittable_list::{Hittable, Sphere};
use laws::{Case, IntervalCase};
use speed_vs_accuracy::find;

use crate::methods::question;

/// Each row in the words of the page, and what it changes in the ball of chapter 3 and its ray
/// straight ahead, whose roots are ½ and 1½: the origin `o`, the direction `d`, the center `c`, the
/// radius `r`, and the ends `from` and `to` of the range. All
/// changes of one row are answered alike.
const ROWS: &str = "\
straight ahead, for comparison |
$r = 0$, the line through the center | r 0
$r = 0$, a line beside it | r 0, o.y 1
$r = 0$, from the center | r 0, c.z 0
$r$ is subnormal, 2⁻¹⁰⁶⁰ | r 8.095e-320
$r = -½$ | r -0.5
$r$ is NaN | r NaN
$r = ∞$ | r inf
the direction is 0 | d.z 0
the direction is subnormal, 2⁻¹⁰⁶⁰ long | d.z -8.095e-320
the direction is 10⁻¹⁷⁰ long | d.z -1e-170
the direction is 10²⁰⁰ long | d.z -1e200
from the surface, outwards; $t_{min} = -0$, too | c.z 0, r 1, o.x 1, d.x 1, d.z 0 | c.z 0, r 1, o.x 1, d.x 1, d.z 0, from -0
from the surface, inwards | c.z 0, r 1, o.x 1, d.x -1, d.z 0
from the center | c.z 0, r 1
from inside | c.z 0, r 1, o.z 0.5
away from the sphere | d.z 1
a tangent | c.z 0, r 1, o.x 1, o.z 2
a tangent from its point of contact | c.z 0, r 1, o.x 1
$t_{min}$ is the nearer root | from 0.5
$t_{max}$ is the nearer root | to 0.5
$t_{max}$ is between the roots | to 1
$t_{max}$ is before the wall, from inside | c.z 0, r 1, o.z 0.5, to 1
$t_{min} = -∞$, the sphere is behind | d.z 1, from -inf
no number is between the ends, but the root is | c.z -2, r 0.9999999999999999, from 1, to 1.0000000000000002
an end is NaN, or $t_{min} > t_{max}$ | from NaN | to NaN | from 1, to 0
origin, direction or center is not finite | o.x NaN | o.z inf | d.x NaN | d.z -inf | c.x NaN | c.z -inf
$h^2$ overflows, $a$ and $c$ do not | c.z -1e100, r 5e99, d.z -1e100
$h^2$ overflows, from inside, $t_{min} = -1$ | c.z 0, r 1, o.x 0.25, d.x -1e160, d.z 0, from -1
$c$ overflows | c.z -1e160, r 5e159
$c$ underflows | c.z -1e-170, r 5e-171
";

/// Makes the question of a row.
fn asked(changes: &str) -> IntervalCase {
    let mut case = Case::new(Vec3::NEG_Z, 0.5, Ray::new(Point3::ZERO, Vec3::NEG_Z));
    let [mut t_min, mut t_max] = [0.0, f64::INFINITY];
    for change in changes.split(", ").filter(|it| !it.is_empty()) {
        let (what, number) = change.split_once(' ').expect("a number");
        *match what {
            "o.x" => &mut case.ray.origin.x,
            "o.y" => &mut case.ray.origin.y,
            "o.z" => &mut case.ray.origin.z,
            "d.x" => &mut case.ray.direction.x,
            "d.z" => &mut case.ray.direction.z,
            "c.x" => &mut case.center.x,
            "c.z" => &mut case.center.z,
            "r" => &mut case.radius,
            "from" => &mut t_min,
            "to" => &mut t_max,
            what => panic!("nothing is called {what}"),
        } = number.parse().expect("a number");
    }
    IntervalCase { case, t_min, t_max }
}

#[test]
fn each_cell_of_the_table_on_the_page_is_what_the_function_answers() {
    let page = include_str!("../../../book/notes/methods.md");
    let table = page.split("## The contract\n").nth(1).expect("a section");
    let mut lines = table.lines().filter(|line| line.starts_with('|'));
    let head = lines.next().expect("the page has the table");
    let columns: Vec<Vec<&str>> = cells(head).skip(1).map(names).collect();
    let mut expected = String::new();
    for row in ROWS.lines() {
        let mut row = row.split('|').map(str::trim);
        let name = row.next().expect("a name");
        let all_asked: Vec<IntervalCase> = row.map(asked).collect();
        let _ = write!(expected, "| {name} |");
        for column in &columns {
            let answers = |asked| column.iter().map(move |function| answer(function, asked));
            let mut answers = all_asked.iter().flat_map(answers);
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
        .take(ROWS.lines().count())
        .map(|line| format!("{line}\n"))
        .collect();
    assert!(found == expected, "the table should be\n{expected}");
}

fn cells(line: &str) -> impl Iterator<Item = &str> {
    line.trim_matches('|').split('|').map(str::trim)
}

/// Lists the functions in the head of a column, which all answer alike.
fn names(head: &str) -> Vec<&str> {
    head.split('`').skip(1).step_by(2).collect()
}

/// Returns `t` as the function answers it, or its other answer.
fn answer(function: &str, asked: &IntervalCase) -> String {
    let IntervalCase { case, t_min, t_max } = *asked;
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
        name => question(&case).put_to(&find(name).expect("a method"), t_min, t_max),
    };
    match t {
        None => "miss".to_owned(),
        Some(t) if t.is_infinite() || (t != 0.0 && !(1e-3..1e4).contains(&t.abs())) => {
            format!("{t:.3e}").replace("-", "−")
        }
        Some(t) => t.to_string().replace("-", "−"),
    }
}
