//! The contract: what each function of the chapters answers where formulas end. The table
//! stands on the page of all methods; here each of its cells is asked.

use std::fmt::Write;

use common::rtweekend::*;
use hittable_list::{Hittable, Sphere};
use laws::Case;
use speed_vs_accuracy::find;

const NAN: f64 = f64::NAN;
const INF: f64 = f64::INFINITY;

/// What is asked in a row: the ball of chapter 3 and its ray straight ahead, whose roots are ½
/// and 1½, but for what the row changes.
struct Asked {
    case: Case,
    t_min: f64,
    t_max: f64,
}

impl Asked {
    /// The question of the first row, changed.
    fn but_for(change: fn(&mut Self)) -> Self {
        let case = Case::new(Vec3::NEG_Z, 0.5, Ray::new(Point3::ZERO, Vec3::NEG_Z));
        let (t_min, t_max) = (0.0, INF);
        let mut asked = Self { case, t_min, t_max };
        change(&mut asked);
        asked
    }

    /// The ball of radius 1 around 0, by a ray from there in that direction.
    fn unit_ball(&mut self, from: [f64; 3], direction: [f64; 3]) {
        let ray = Ray::new(from.into(), direction.into());
        self.case = Case::new(Point3::ZERO, 1.0, ray);
    }

    /// A sphere straight ahead, twice its radius away.
    fn ahead(&mut self, away: f64) {
        (self.case.center.z, self.case.radius) = (-away, away / 2.0);
    }
}

type Row = (&'static str, fn(&mut Asked));

/// Each row in the words of the page, and a change that it tells of. All changes of one row are
/// answered alike.
const ROWS: &[Row] = &[
    ("straight ahead, for comparison", |_| {}),
    ("$r = 0$, the line through the center", |it| {
        it.case.radius = 0.0;
    }),
    ("$r = 0$, a line beside it", |it| {
        it.case.radius = 0.0;
        it.case.ray.origin.y = 1.0;
    }),
    ("$r = 0$, from the center", |it| {
        (it.case.radius, it.case.center.z) = (0.0, 0.0);
    }),
    ("$r$ is subnormal, 2⁻¹⁰⁶⁰", |it| {
        it.case.radius = 8.095e-320;
    }),
    ("$r = -½$", |it| it.case.radius = -0.5),
    ("$r$ is NaN", |it| it.case.radius = NAN),
    ("$r = ∞$", |it| it.case.radius = INF),
    ("the direction is 0", |it| {
        it.case.ray.direction = Vec3::ZERO;
    }),
    ("the direction is subnormal, 2⁻¹⁰⁶⁰ long", |it| {
        it.case.ray.direction.z = -8.095e-320;
    }),
    ("the direction is 10⁻¹⁷⁰ long", |it| {
        it.case.ray.direction.z = -1e-170;
    }),
    ("the direction is 10²⁰⁰ long", |it| {
        it.case.ray.direction.z = -1e200;
    }),
    ("from the surface, outwards; $t_{min} = -0$, too", |it| {
        it.unit_ball([1.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    }),
    ("from the surface, outwards; $t_{min} = -0$, too", |it| {
        it.unit_ball([1.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
        it.t_min = -0.0;
    }),
    ("from the surface, inwards", |it| {
        it.unit_ball([1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]);
    }),
    ("from the center", |it| {
        it.unit_ball([0.0; 3], [0.0, 0.0, -1.0]);
    }),
    ("from inside", |it| {
        it.unit_ball([0.0, 0.0, 0.5], [0.0, 0.0, -1.0]);
    }),
    ("away from the sphere", |it| it.case.ray.direction.z = 1.0),
    ("a tangent", |it| {
        it.unit_ball([1.0, 0.0, 2.0], [0.0, 0.0, -1.0]);
    }),
    ("a tangent from its point of contact", |it| {
        it.unit_ball([1.0, 0.0, 0.0], [0.0, 0.0, -1.0]);
    }),
    ("$t_{min}$ is the nearer root", |it| it.t_min = 0.5),
    ("$t_{max}$ is the nearer root", |it| it.t_max = 0.5),
    ("$t_{max}$ is between the roots", |it| it.t_max = 1.0),
    ("$t_{max}$ is before the wall, from inside", |it| {
        it.unit_ball([0.0, 0.0, 0.5], [0.0, 0.0, -1.0]);
        it.t_max = 1.0;
    }),
    ("$t_{min} = -∞$, the sphere is behind", |it| {
        it.case.ray.direction.z = 1.0;
        it.t_min = -INF;
    }),
    ("no number is between the ends, but the root is", |it| {
        (it.case.center.z, it.case.radius) = (-2.0, 1.0_f64.next_down());
        (it.t_min, it.t_max) = (1.0, 1.0_f64.next_up());
    }),
    ("an end is NaN, or $t_{min} > t_{max}$", |it| it.t_min = NAN),
    ("an end is NaN, or $t_{min} > t_{max}$", |it| it.t_max = NAN),
    ("an end is NaN, or $t_{min} > t_{max}$", |it| {
        (it.t_min, it.t_max) = (1.0, 0.0);
    }),
    ("origin, direction or center is not finite", |it| {
        it.case.ray.origin.x = NAN
    }),
    ("origin, direction or center is not finite", |it| {
        it.case.ray.origin.z = INF
    }),
    ("origin, direction or center is not finite", |it| {
        it.case.ray.direction.x = NAN
    }),
    ("origin, direction or center is not finite", |it| {
        it.case.ray.direction.z = -INF;
    }),
    ("origin, direction or center is not finite", |it| {
        it.case.center.x = NAN
    }),
    ("origin, direction or center is not finite", |it| {
        it.case.center.z = -INF
    }),
    ("$h^2$ overflows, $a$ and $c$ do not", |it| {
        it.ahead(1e100);
        it.case.ray.direction.z = -1e100;
    }),
    ("$h^2$ overflows, from inside, $t_{min} = -1$", |it| {
        it.unit_ball([0.25, 0.0, 0.0], [-1e160, 0.0, 0.0]);
        it.t_min = -1.0;
    }),
    ("$c$ overflows", |it| it.ahead(1e160)),
    ("$c$ underflows", |it| it.ahead(1e-170)),
];

#[test]
fn each_cell_of_the_table_on_the_page_is_what_the_function_answers() {
    let page = include_str!("../../../book/notes/methods.md");
    let table = page.split("## The contract\n").nth(1).expect("a section");
    let mut lines = table.lines().filter(|line| line.starts_with('|'));
    let head = lines.next().expect("the page has the table");
    let columns: Vec<Vec<&str>> = cells(head).skip(1).map(names).collect();
    let mut expected = String::new();
    let rows = || ROWS.chunk_by(|(one, _), (other, _)| one == other);
    for row in rows() {
        let name = row[0].0;
        let asked: Vec<Asked> = row
            .iter()
            .map(|(_, change)| Asked::but_for(*change))
            .collect();
        let _ = write!(expected, "| {name} |");
        for column in &columns {
            let mut answers = asked
                .iter()
                .flat_map(|it| column.iter().map(move |function| answer(function, it)));
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
        .take(rows().count())
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
fn answer(function: &str, asked: &Asked) -> String {
    let Asked { case, t_min, t_max } = *asked;
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
