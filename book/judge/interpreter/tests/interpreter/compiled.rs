//! Differential testing against the compiler: what is typed in a page is run, and refused, as rustc
//! has it.

use common::rtweekend::*;
use interpreter::{Fault, FaultKind, Program, SourceFile, Value};
use slips::{Chapter, ChapterCode};

fn read(text: &str) -> Result<Program, Fault> {
    interpreter::read(&[SourceFile::new("src/lib.rs", text)])
}

fn chapter_files(chapter: Chapter) -> Vec<SourceFile> {
    let files = chapter.files().iter();
    files.map(|it| SourceFile::new(it.name, it.text)).collect()
}

/// The prelude's functions, each with a mistake, draw another picture than by their doubles.
#[test]
fn an_edit_of_the_prelude_is_drawn() {
    let right = interpreter::read(&chapter_files(Chapter::Normals)).expect("it is read");
    for [function, text] in rows(include_str!("texts/prelude.txt")) {
        let edited = right.patched(&function, &text).expect("it is read");
        assert_ne!(edited.draw(40), right.draw(40), "{function}");
    }
}

/// Makes rows of an edited function of vectors, an expression of `a` and `b` that calls it, and what
/// the compiler makes of that expression.
macro_rules! edits {
    ($($name:literal $edit:literal, $expression:literal: |$a:ident, $b:ident| $compiled:expr;)*) => {
        [$(($name, $edit, $expression, (|$a, $b| $compiled) as fn(Vec3, Vec3) -> Vec3)),*]
    };
}

#[test]
fn an_edited_operator_or_function_of_vectors_computes_as_the_compiled_one() {
    let edits = edits! {
        "DVec3::add" "fn add(self, v: Vec3) -> Vec3 { Vec3::new(self.x + v.x, self.y, self.z) }",
            "a + b + 0.5": |a, b| Vec3::new(a.x + b.x + 0.5, a.y, a.z);
        "DVec3::sub" "fn sub(self, v: Vec3) -> Vec3 { Vec3::new(self.x - v.x, self.y - v.y, self.y - v.y) }",
            "a - b": |a, b| Vec3::new(a.x - b.x, a.y - b.y, a.y - b.y);
        "DVec3::neg" "fn neg(self) -> Vec3 { Vec3::new(-self.x, -self.y, self.z) }",
            "-a * b": |a, b| Vec3::new(-a.x * b.x, -a.y * b.y, a.z * b.z);
        "DVec3::mul" "fn mul(self, v: Vec3) -> Vec3 { Vec3::new(self.x * v.x, self.y * v.y, self.z * v.y) }",
            "2.0 * (a * b)": |a, b| 2.0 * Vec3::new(a.x * b.x, a.y * b.y, a.z * b.y);
        "f64::mul" "fn mul(self, v: Vec3) -> Vec3 { Vec3::new(self * v.x, self * v.y, self * v.y) }",
            "a * 0.3 - 0.7 * b": |a, b| Vec3::new(a.x, a.y, a.y) * 0.3 - 0.7 * Vec3::new(b.x, b.y, b.y);
        "DVec3::div" "fn div(self, v: Vec3) -> Vec3 { Vec3::new(self.x, self.y / v.y, self.z / v.z) }",
            "a / b / 3.0": |a, b| Vec3::new(a.x, a.y / b.y / 3.0, a.z / b.z / 3.0);
        "DVec3::dot" "fn dot(self, v: Vec3) -> f64 { self.x * v.x + self.x * v.x + self.x * v.x }",
            "a.dot(b) * a": |a, b| (a.x * b.x + a.x * b.x + a.x * b.x) * a;
        "DVec3::length" "fn length(self) -> f64 { (self.x * self.x + self.y * self.y).sqrt() }",
            "a.normalize() * b": |a, b| a * (1.0 / (a.x * a.x + a.y * a.y).sqrt()) * b;
        "DVec3::normalize" "fn normalize(self) -> Vec3 { let v = self * (1.0 / self.length()); Vec3::new(self.x, v.y, v.z) }",
            "a.normalize() + b": |a, b| a.normalize().with_x(a.x) + b;
    };
    let [a, b] = [Vec3::new(0.3, -1.7, 2.9), Vec3::new(-1.1, 0.6, 0.7)];
    for (name, edit, expression, compiled) in edits {
        let text = format!("fn f(a: Vec3, b: Vec3) -> Vec3 {{ {expression} }}");
        let right = read(&text).expect("rustc compiles it");
        let names: Vec<_> = right.prelude_functions().map(|it| it.0).collect();
        assert!(names.contains(&name), "{name} is none of {names:?}");
        let value = |program: &Program| program.call("f", &mut [a.into(), b.into()]);
        let value = |program| value(program).expect("it runs").vec3();
        let edited = right.patched(name, edit).expect("rustc compiles it");
        assert_eq!(value(&edited), Some(compiled(a, b)), "{name}");
        assert_ne!(value(&edited), value(&right), "{name}");
    }
}

/// Two functions with other texts, one after the other, and one that does not go with the rest.
#[test]
fn a_function_that_is_read_anew_draws_what_the_whole_text_does() {
    let mistakes = [
        ("hit_sphere", "discriminant < 0.0", "discriminant > 0.0"),
        ("ray_color", "0.5 * (normal + Vec3::ONE)", "normal"),
    ];
    let mut text = Chapter::Normals.files()[0].text.to_owned();
    let right = read(&text).expect("rustc compiles it");
    let mut patched = right.clone();
    let mut alone = Vec::new();
    for (function, line, wrong) in mistakes {
        let old = patched.functions().find(|it| it.0 == function);
        let new = old.expect("it is there").1.replace(line, wrong);
        patched = patched.patched(function, &new).expect("rustc compiles it");
        alone.push(right.patched(function, &new).expect("rustc compiles it"));
        text = text.replace(line, wrong);
        let whole = read(&text).expect("rustc compiles it");
        assert_eq!(patched.draw(63), whole.draw(63), "{function}");
        assert_ne!(patched.draw(63), right.draw(63), "{function}");
    }
    let merged = alone[0]
        .merged_with(&alone[1], &right)
        .expect("they differ");
    assert_eq!(merged.draw(63), patched.draw(63));
    assert!(merged.merged_with(&alone[0], &right).is_none());
    let patched = right.patched("ray_color", "fn ray_color(ray: &Ray) -> Color { ray }");
    let drawn = patched.expect("types are seen when it runs").draw(16);
    assert!(drawn.is_err_and(|it| it.message == "expected `Vec3`, found `Ray`"));
}

#[test]
fn a_mutant_runs_by_its_number_and_one_that_is_refused_is_lost_alone() {
    let sum = "0.5 * (unit_direction.y + 1.0)";
    let mutants = "mutants!(4, 0.5 * mutants!(7, (unit_direction.y + 1.0), \
         (unit_direction.y - 1.0)), unit_direction, unknown)";
    let text = Chapter::Gradient.files()[0].text;
    let all = read(&text.replace(sum, mutants)).expect("it is read");
    let draws = |number, other: &str| {
        let other = read(&text.replace(sum, other)).expect("it is read");
        all.with_mutant(number).draw(40) == other.draw(40)
    };
    for nothing in [0, 3, 6, 8] {
        assert!(draws(nothing, sum), "{nothing}");
    }
    assert!(draws(7, "0.5 * (unit_direction.y - 1.0)"));
    assert!(draws(4, "unit_direction"));
    let lost = all
        .with_mutant(5)
        .draw(40)
        .expect_err("there is no such name");
    assert!(lost.message.contains("`unknown`"), "{lost}");
}

#[test]
fn a_call_from_outside_returns_its_value_and_what_it_changed() {
    let program = interpreter::read(&chapter_files(Chapter::HittableList)).expect("it is read");
    let call = |name: &str, given: &mut [Value]| program.call(name, given).expect("it runs");
    let center = Vec3::new(0.0, 0.0, -1.0);
    let sphere = call("Sphere::new", &mut [center.into(), 0.5.into()]);
    let mut list = [call("HittableList::default", &mut []), sphere];
    call("HittableList::add", &mut list);
    let [list, _] = list;
    let ray = Ray::new(Vec3::ZERO, Vec3::new(0.0, 0.0, -1.0));
    let hit = call(
        "HittableList::hit",
        &mut [list, ray.into(), 0.0.into(), 9.0.into()],
    );
    let t = program.field(&hit.parts()[0], "t");
    assert_eq!(t.and_then(|it| it.float()), Some(0.5));
    assert!(program.first_refusal().is_none());
    assert!(
        program
            .call("Sphere::new", &mut [center.into(), center.into()])
            .is_err()
    );
    assert!(program.first_refusal().is_some());
}

#[test]
fn a_traced_pixel_has_its_values_in_their_order() {
    let program = interpreter::read(&chapter_files(Chapter::Normals)).expect("it is read");
    let canvas = program.canvas(40).expect("it draws");
    let said = canvas.trace(20, 11).into_iter().map(|step| {
        let name = step.name.as_deref().unwrap_or("return").to_owned();
        format!("{}: {name} {}", step.function, step.value)
    });
    let said: Vec<String> = said.collect();
    assert_eq!(said[0], "ray_color: center (0, 0, -1)");
    let names = [
        "center",
        "oc",
        "a",
        "b",
        "c",
        "discriminant",
        "normal",
        "return",
    ];
    let order: Vec<&str> = said.iter().filter_map(|it| it.split(' ').nth(1)).collect();
    assert_eq!(order, names, "{said:?}");
}

/// A function of a number, two integers and a vector.
type Expression = fn(f64, u32, i32, Vec3) -> f64;

/// Lists expressions, each with its text and as the compiler has it.
macro_rules! expressions {
    ($x:ident $n:ident $i:ident $v:ident: $($expression:expr),* $(,)?) => {
        &[$((stringify!($expression), |$x, $n, $i, $v| $expression)),*]
    };
}

/// Expressions that people mistype, and those that differ from language to language.
#[allow(warnings, clippy::all, reason = "some look wrong on purpose")]
const EXPRESSIONS: &[(&str, Expression)] = expressions! { x n i v:
    x - 1.0 - 0.5,
    x / 3.0 / 2.0,
    -x * 2.0 + 1.0,
    -x.powi(2),
    (-x).powi(2),
    1.0 / (x - 2.5),
    -1.0 / (x - 2.5),
    (x - 2.5) / (x - 2.5),
    -(x - 2.5),
    0.0 * -x,
    (-x).sqrt(),
    (-x).max(f64::NAN),
    f64::NAN.min(x),
    x.max(-x).min(1.0),
    0.1 + 0.2 + x,
    x + 1e16 - 1e16,
    f64::from(n / 2),
    f64::from(i / 2),
    (n as f64) / 2.0,
    f64::from(-i / 2 * 2),
    f64::from(i % 4) + f64::from(i.rem_euclid(4)) + f64::from(i.abs().pow(2)),
    f64::from((-x) as u8),
    f64::from((x * 200.0) as u8),
    f64::from(f64::NAN as i32),
    f64::from(f64::INFINITY as i32),
    f64::from((n + 250) as u8),
    f64::from(i as u32),
    if x < 3.0 && n > 6 || i > 0 { 1.0 } else { 2.0 },
    if !(x < f64::NAN) { 1.0 } else { 2.0 },
    (0..n).map(f64::from).fold(0.0, |sum, k| sum / 2.0 + k),
    (1..=4).rev().fold(0.0, |sum, k| sum * 10.0 + f64::from(k)),
    [x, -x, 1.0].into_iter().filter(|&t| t > 0.0).min_by(|a, b| a.total_cmp(b)).unwrap(),
    v.dot(v) - v.length_squared() + (v / 3.0).x + (v * (1.0 / 3.0)).y,
    (x * v - v * x).length() + v.cross(Vec3::Z).y,
    { let mut w = v; w.x += 1.0; w.x - v.x },
    { let mut sum = 0.0; for k in 0..n { if k % 2 == 0 { continue; } sum += f64::from(k) * x; } sum },
    { let mut all = vec![x, 1.0]; all.push(-x); all.sort_by(|a, b| a.total_cmp(b)); all[0] + all[2] / 3.0 },
    { let mut count = 0.0; let mut add = |k: f64| count += k; add(x); add(1.0); count },
    { let (a, b) = (x, v.y); let f = move |k: f64| a * k - b; f(f(2.0)) },
    { let mut all = [x, 2.0, 3.0]; for it in &mut all { *it *= 2.0; } all.iter().sum::<f64>() },
    { let mut k = 0; let r = loop { k += 1; if k * k > 50 { break k; } }; f64::from(r) },
    x.mul_add(2.0, 1.0) + x.abs().recip() + f64::hypot(x, 1.0) + x.rem_euclid(0.7) + x % 0.7,
};

#[test]
fn expressions_come_to_what_the_compiler_makes_of_them() {
    let (x, n, i, v) = (2.5, 7, -7, Vec3::new(1.0, 2.0, 3.0));
    for (expression, compiled) in EXPRESSIONS {
        let function = format!(
            "fn f(v: Point3, x: f64) -> f64 {{\n    let n = (x * 2.8) as u32;\n    \
             let i = -(n as i32);\n    {expression}\n}}\n"
        );
        let program = read(&function).unwrap_or_else(|fault| panic!("{expression}: {fault}"));
        let own = program.call("f", &mut [v.into(), x.into()]);
        let own = own.unwrap_or_else(|fault| panic!("{expression}: {fault}"));
        let (own, compiled) = (own.float().expect("it is a number"), compiled(x, n, i, v));
        let is_same = own.to_bits() == compiled.to_bits() || own.is_nan() && compiled.is_nan();
        assert!(is_same, "{expression} is {compiled:?}, and here {own:?}");
    }
}

/// Returns the rows of a table without its head, split at ` ¦ `.
fn rows<const N: usize>(table: &str) -> impl Iterator<Item = [String; N]> {
    table.lines().skip(1).map(|row| {
        let parts = row.splitn(N, " ¦ ").map(|it| it.replace('⏎', "\n"));
        let parts = parts.collect::<Vec<_>>().try_into();
        parts.unwrap_or_else(|_| panic!("{row} lacks a part"))
    })
}

/// Returns a row's chapter, and its files with one of them changed as the row says.
fn changed(row: &[String]) -> (Chapter, Vec<SourceFile>) {
    let chapter = Chapter::find(&row[0]).expect("a chapter");
    let mut files = chapter_files(chapter);
    let file = files.iter_mut().find(|it| it.text.contains(&row[1]));
    let text = &mut file.unwrap_or_else(|| panic!("{row:?} is not there")).text;
    *text = text.replacen(&row[1], &row[2], 1);
    (chapter, files)
}

#[test]
fn what_the_compiler_reads_is_read() {
    for row in rows::<3>(include_str!("texts/read.txt")) {
        let (chapter, files) = changed(&row);
        let drawn = interpreter::read(&files).and_then(|it| it.draw(40));
        assert_eq!(drawn, Ok(chapter.picture(40)), "{row:?}");
    }
}

/// A text that is accepted though rustc refuses it draws the right picture.
#[test]
fn what_is_refused_or_is_not_read_is_said_in_its_line() {
    let mut other = String::new();
    for row in rows::<4>(include_str!("texts/refused.txt")) {
        let (chapter, files) = changed(&row);
        let said = match interpreter::read(&files).and_then(|it| it.draw(16)) {
            Ok(picture) if picture == chapter.picture(16) => "drawn".to_owned(),
            Ok(_) => "another picture".to_owned(),
            Err(fault) => {
                let line = fault.place().map_or(0, |it| it.line);
                let kind = match fault.kind {
                    FaultKind::Unparsed | FaultKind::Refused => "",
                    FaultKind::Unfinished => "unfinished: ",
                    FaultKind::Unread => "can't read ",
                    FaultKind::Stopped => "stops: ",
                };
                format!("{line}: {kind}{}", fault.message)
            }
        };
        if said != row[3] {
            other += &row[..3].join(" ¦ ").replace('\n', "⏎");
            other += &format!(" ¦ {said}\n");
        }
    }
    assert!(other.is_empty(), "otherwise is said\n{other}");
}
