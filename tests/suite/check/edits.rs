//! What the generator makes of a sample, and how it writes all of it into one text.

use edits::schemata::{self, Notation, Schema, Written};
use edits::{Defined, Edit, Edits};
use interpreter::{SourceFile, Value};

/// A program with one of everything that is edited.
const SAMPLE: &str = r#"
const BLUE: Color = Color::new(0.5, 0.7, 1.0);

pub struct Vec3 { pub x: f64, pub y: f64, pub z: f64 }

impl Vec3 {
    fn plus(self, other: Vec3) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }
    fn dot(&self, other: &Vec3) -> f64 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }
}

fn ray_color(ray: &Ray) -> Color {
    let unit_direction = ray.direction.normalize();
    let a = 0.5 * (unit_direction.y + 1.0);
    (1.0 - a) * Color::ONE + a * BLUE
}

fn hit(center: Vec3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    let oc = center - ray.origin;
    let a = ray.direction.length_squared();
    let h = ray.direction.dot(oc);
    let discriminant = h * h - a * (oc.length_squared() - radius * radius);
    if discriminant < 0.0 {
        return None;
    }
    let root = (h - discriminant.sqrt()) / a;
    (t_min < root && root < t_max).then_some(root)
}

fn nearest(all: &[Sphere], ray: &Ray) -> Option<f64> {
    let mut closest = f64::INFINITY;
    let mut found = None;
    if all.is_empty() {
        return Some(closest);
    }
    for sphere in all.iter() {
        if let Some(t) = hit(sphere.center, sphere.radius, ray, 0.0, closest) && t > 0.0 {
            closest = t;
            found = Some(t);
        }
    }
    found
}

fn picture(width: u32, height: u32) {
    for j in (0..height).rev() {
        let share = f64::from(j) / (height - 1) as f64;
        println!("{} {} {}", (255.999 * share) as u32, width, match j { 0 => 1, _ => 2 });
    }
}
"#;

/// What stands in the sample, and what it becomes by an edit.
const MADE: &str = r"
center - ray.origin → center + ray.origin
(t_min < root → (t_min > root
root && root → root || root
h * h - a * ( → h * h - a / (
a * BLUE → (a + BLUE)
* Color::ONE + a * BLUE → * Color::ONE + a + BLUE
center - ray.origin → ray.origin - center
(1.0 - a) * Color::ONE + a * BLUE → (1.0 - a) * BLUE + a * Color::ONE
center - ray.origin → center
radius * radius) → radius)
h * h - a * ( → h - a * (
0.5 * (unit_direction.y + 1.0) → 0.5 * unit_direction.y + 1.0
(h - discriminant.sqrt()) / a → h - discriminant.sqrt() / a
h - discriminant.sqrt() → (h - discriminant).sqrt()
(height - 1) as f64 → (height as f64 - 1 as f64)
ray.direction.dot(oc) → -ray.direction.dot(oc)
a * BLUE → -a * BLUE
discriminant < 0.0 → true
if discriminant < 0.0 → if !(discriminant < 0.0)
0.5 * ( → 1.0 * (
0.5 * ( → -0.5 * (
255.999 → 256.0
ray, 0.0, → ray, closest,
height - 1) → height - 2)
* h - a → * a - a
ray, 0.0, closest) → ray, 0.0, f64::INFINITY)
+ a * BLUE → + a * Color::ONE
ray.origin → ray.direction
unit_direction.y → unit_direction.x
ray.direction.length_squared() → ray.direction.length()
ray.direction.normalize() → ray.direction
= ray.direction.length → = ray.direction.normalize().length
= ray.direction.dot(oc) → = 2.0 * ray.direction.dot(oc)
= center - ray → = center * center - ray
= center - ray.origin → = (center - ray.origin) * radius
(h - discriminant.sqrt()) / a → (a - discriminant.sqrt()) / h
hit(sphere.center, sphere.radius, ray, 0.0, closest) → hit(sphere.center, sphere.radius, ray, closest, 0.0)
hit(sphere.center, sphere.radius, ray, 0.0, closest) → hit(sphere.center, sphere.radius, ray, 0.0, 0.0)
ray.direction.dot(oc) → oc.dot(ray.direction)
ray.direction.dot(oc) → ray.direction.dot(ray.direction)
Some(t); → t;
= Some(t); → = None;
self.x + other.x, y: self.y + other.y, z: self.z + other.z → self.x - other.x, y: self.y - other.y, z: self.z - other.z
self.x * other.x + self.y * other.y + self.z * other.z → self.x + self.y + self.z
Color::new(0.5, 0.7, 1.0) → Color::new(0.7, 0.5, 1.0)
closest = t; →
found = Some(t); → found = Some(t);found = closest;
closest = t; → closest += t;
(0..height).rev() → (0..height)
(0..height) → (0..=height)
return Some(closest) → found = Some(closest)
0 => 1, _ => 2 → 0 => 2, _ => 1
255.999 * share → 255.999 / share
";

#[test]
fn each_kind_of_mistake_is_made() {
    let Edits { edits, .. } = edits::of_texts(&[SAMPLE]).expect("it is Rust");
    let made: Vec<String> = edits
        .iter()
        .map(|it| squeezed(&it.applied_to(SAMPLE)))
        .collect();
    let missing = MADE.trim().lines().filter(|row| {
        let (old, new) = row.split_once(" →").expect("a row has two sides");
        assert!(SAMPLE.contains(old), "{row}");
        !made.contains(&squeezed(&SAMPLE.replacen(old, new, 1)))
    });
    let missing: Vec<&str> = missing.collect();
    assert!(missing.is_empty(), "{missing:#?}");
}

#[test]
fn every_edit_is_rust_and_changes_its_text() {
    for edit in edits::of_texts(&[SAMPLE]).expect("it is Rust").edits {
        let text = edit.applied_to(SAMPLE);
        let file = syn::parse_file(&text);
        assert!(file.is_ok(), "{edit:?}");
        assert_ne!(squeezed(&text), squeezed(SAMPLE), "{edit:?}");
        let at = &edit.host.at;
        assert!(
            at.start <= edit.at.start && edit.at.end <= at.end,
            "{edit:?}"
        );
        assert!((1..=9).contains(&edit.rank), "{edit:?}");
    }
}

#[test]
fn a_sign_is_likelier_than_a_name_and_that_than_a_missing_statement() {
    let edits = edits::of_texts(&[SAMPLE]).expect("it is Rust").edits;
    let place = |old: &str, new: &str| {
        let text = squeezed(&SAMPLE.replacen(old, new, 1));
        let found = edits
            .iter()
            .position(|it| squeezed(&it.applied_to(SAMPLE)) == text);
        found.unwrap_or_else(|| panic!("{new}"))
    };
    let in_order = [
        place("center - ray.origin", "center + ray.origin"),
        place("0.0, closest)", "closest, 0.0)"),
        place("unit_direction.y", "unit_direction.x"),
        place("* h - a", "* a - a"),
        place("ray, 0.0,", "ray, closest,"),
        place("found = Some(t);", "found = Some(t);found = closest;"),
    ];
    assert!(in_order.is_sorted(), "{in_order:?}");
    assert!(edits.is_sorted_by_key(|it| it.rank));
}

#[test]
fn an_edit_shows_its_line_before_and_after() {
    let edits = edits::of_function(
        "f",
        "fn f(a: f64) -> f64 {\n    1.0 - a\n}",
        &Defined::default(),
    );
    let edit = &edits.expect("it is a function")[0];
    let lines = edit.lines("fn f(a: f64) -> f64 {\n    1.0 - a\n}");
    assert_eq!(
        (lines.number, &*lines.old, &*lines.new),
        (2, "1.0 - a", "1.0 + a")
    );
}

#[test]
fn tests_macros_and_what_has_to_stay_constant_are_left_alone() {
    let text = "const A: f64 = half(2.0);
        const fn half(it: f64) -> f64 { it / 2.0 }
        macro_rules! twice { ($it:expr) => { 2.0 * $it } }
        #[test] fn one_is_one() { assert_eq!(1.0 - 0.0, 1.0) }
        #[cfg(test)] mod tests { fn f() -> f64 { 1.0 - 2.0 } }";
    let edits = edits::of_texts(&[text]).expect("it is Rust").edits;
    let first = text.find('\n').expect("it has lines");
    assert!(
        !edits.is_empty() && edits.iter().all(|it| it.at.end < first),
        "{edits:#?}"
    );
}

/// A program that the interpreter runs, with an edit in the place of each kind of host.
const RUN: &str = "fn f(a: f64, b: f64) -> f64 {
    let mut sum = a - b;
    for it in [a, b] {
        if it > 1.0 {
            sum = sum + it;
        }
    }
    if sum < 0.0 { -sum } else { sum * 2.0 }
}";

#[test]
fn each_number_runs_the_program_with_its_edit() {
    let edits = edits::of_function("f", RUN, &Defined::default()).expect("it is a function");
    let (text, numbers) = schemata::mutants(RUN, &edits, 7);
    let all = read(&text).expect("the interpreter reads the mutants");
    assert_eq!(run(&all), run(&read(RUN).expect("it is read")));
    let mut compared = 0;
    for (edit, number) in edits.iter().zip(numbers) {
        let Some(expected) = read(&edit.applied_to(RUN)).map(|it| run(&it)) else {
            continue;
        };
        assert_eq!(run(&all.with_mutant(number)), expected, "{edit:?}\n{text}");
        compared += 1;
    }
    assert!(2 * compared > edits.len(), "{compared} of {}", edits.len());
}

fn read(text: &str) -> Option<interpreter::Program> {
    interpreter::read(&[SourceFile::new("src/lib.rs", text)]).ok()
}

fn run(program: &interpreter::Program) -> [Option<u64>; 2] {
    let given = [(3.0, 1.5), (0.5, 2.5)];
    let call = |(a, b)| {
        let result = program.call("f", &mut [Value::Float(a), Value::Float(b)]);
        result.ok().and_then(|it| it.float()).map(f64::to_bits)
    };
    given.map(call)
}

#[test]
fn both_notations_have_every_edit_once_and_copy_the_rest() {
    let Edits { edits, uses } = edits::of_texts(&[SAMPLE]).expect("it is Rust");
    let chosen: Vec<usize> = (0..edits.len()).collect();
    let numbers = schemata::numbered(&edits, &chosen, 0);
    let schema = Schema {
        edits: &edits,
        uses: &uses,
        numbers: &numbers,
    };
    for notation in [Notation::Match, Notation::Mutants] {
        let Written {
            text, alternatives, ..
        } = schema.write(0, &[SAMPLE], notation);
        assert!(syn::parse_file(&text).is_ok(), "{text}");
        let is_constant = |it: &Edit| it.host.form == edits::Form::Constant;
        for (at, n) in &alternatives {
            let is_whole = text[at.clone()] == edits[*n].hosted(SAMPLE);
            assert!(is_whole || is_constant(&edits[*n]), "{}", &text[at.clone()]);
        }
        let count = |n| alternatives.iter().filter(|it| it.1 == n).count();
        let once = |n: usize| if is_constant(&edits[n]) { 2 } else { 1 };
        assert!(chosen.iter().all(|&n| count(n) == once(n)));
    }
}

#[test]
fn a_byte_that_is_copied_is_found_in_the_first_text() {
    let Edits { edits, uses } = edits::of_texts(&[SAMPLE]).expect("it is Rust");
    let numbers = schemata::numbered(&edits, &[0, 1, 2, 3], 0);
    let schema = Schema {
        edits: &edits,
        uses: &uses,
        numbers: &numbers,
    };
    let written = schema.write(0, &[SAMPLE], Notation::Match);
    for word in ["fn nearest", "fn picture", "const BLUE"] {
        let there = written.text.find(word).expect("it is copied");
        assert_eq!(
            written.origin(there),
            SAMPLE.find(word).expect("it is there")
        );
    }
}

fn squeezed(text: &str) -> String {
    text.split_whitespace().collect()
}
