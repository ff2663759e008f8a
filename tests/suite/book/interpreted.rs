//! What is typed in a page: is it run, and refused, as the compiler has it?

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use common::rtweekend::*;
use slips::{Chapter, Interpreted, Letters};
use suite::command::{assert_success, cargo, run, text};
use typed::Program;

use crate::lesson::write_if_changed;

const WIDTHS: [u32; 3] = [40, 63, 100];

/// The files of each chapter, as they stand.
fn files_of(chapter: Chapter) -> Vec<(&'static str, &'static str)> {
    macro_rules! text {
        ($folder:literal, $name:literal) => {
            (
                $name,
                include_str!(concat!("../../../chapters/", $folder, "/", $name)),
            )
        };
    }
    match chapter {
        Chapter::BuildTest => vec![text!("0_build_test", "src/lib.rs")],
        Chapter::Gradient => vec![text!("1_gradient", "src/lib.rs")],
        Chapter::RedSphere => vec![text!("2_red_sphere", "src/lib.rs")],
        Chapter::Normals => vec![text!("3_normals", "src/lib.rs")],
        Chapter::HalfBSphere => vec![text!("4_half_b_sphere", "src/lib.rs")],
        Chapter::HittableList => vec![
            text!("5_hittable_list", "src/lib.rs"),
            text!("5_hittable_list", "src/hittable.rs"),
            text!("5_hittable_list", "src/hittable_list.rs"),
            text!("5_hittable_list", "src/sphere.rs"),
        ],
        Chapter::SpeedVsAccuracy => Vec::new(),
    }
}

fn read(files: &[(&str, &str)]) -> Result<Program, String> {
    typed::read(files).map_err(|faults| faults[0].to_string())
}

/// The chapter with the first of these words replaced in one of its files.
fn with(chapter: Chapter, right: &str, wrong: &str) -> Option<Result<Program, String>> {
    let files = files_of(chapter);
    let changed = files
        .iter()
        .position(|(_, text)| text.matches(right).count() == 1)?;
    let text = files[changed].1.replacen(right, wrong, 1);
    let mut files = files;
    files[changed].1 = &text;
    Some(read(&files))
}

#[test]
fn the_chapters_draw_their_pictures_from_their_texts() {
    for chapter in Chapter::OF_THE_BOOK {
        let program = read(&files_of(chapter)).expect("rustc compiles it");
        for width in WIDTHS {
            let drawn = program.draw(width).expect("nothing stops it");
            assert_eq!(drawn, chapter.picture(width), "{chapter:?} at {width}");
        }
    }
}

/// Each known mistake that is another text for a part of a line.
#[test]
fn mistakes_draw_what_they_draw_when_they_are_compiled() {
    let mut drawn = 0;
    let mut other = Vec::new();
    for chapter in Chapter::OF_THE_BOOK {
        for slip in slips::all().filter(|slip| slip.chapters.contains(&chapter)) {
            let words = slip.words(Letters::Rust, chapter);
            let Some(Ok(program)) = with(chapter, &words.right, &words.wrong) else {
                continue;
            };
            drawn += 1;
            let is_same = WIDTHS.iter().all(|&width| {
                let compiled = slip.program(chapter).run(width).picture();
                program.draw(width).is_ok_and(|picture| picture == compiled)
            });
            if !is_same {
                other.push((slip.name, chapter));
            }
        }
    }
    assert!(
        other.is_empty(),
        "{drawn} are drawn, but otherwise are {other:?}"
    );
    // The catalogue says less than half of its mistakes in words that compile.
    assert!(drawn > 100, "{drawn} mistakes are drawn");
}

/// Nobody can make the page wait, or end it.
#[test]
fn a_hostile_text_is_answered_at_once() {
    let nested = |n: usize| format!("{}1.0{}", "(".repeat(n), ")".repeat(n));
    let hostile = [
        "(".repeat(1_000_000),
        nested(3000),
        format!("{}true", "!".repeat(5000)),
        format!("x{}", ".sqrt()".repeat(5000)),
        format!("[{}", "if true {} else ".repeat(1000)),
        "loop {}".to_owned(),
        "while true {}".to_owned(),
        "for _ in 0.. {}".to_owned(),
        "(0..).map(|n| n).collect::<Vec<_>>().len()".to_owned(),
        "hit_sphere(center, radius, ray)".to_owned(),
        "\u{202e}\u{0} <script>alert(1)</script>".to_owned(),
    ];
    for wrong in hostile {
        let start = Instant::now();
        let read = with(
            Chapter::Normals,
            "let oc = center - ray.origin;",
            &format!("{wrong}; {LINE}"),
        );
        let is_refused = match read.expect("the line is there") {
            Ok(program) => program.draw(40).is_err(),
            Err(_) => true,
        };
        let beginning: String = wrong.chars().take(40).collect();
        assert!(is_refused, "{beginning} is drawn");
        assert!(
            start.elapsed() < Duration::from_secs(2),
            "{beginning} takes too long"
        );
    }
}

const LINE: &str = "let oc = center - ray.origin;";

/// What people mistype, and what differs from language to language: `x` is 2.5, `n` is 7,
/// `i` is -7, `v` is (1, 2, 3).
const EXPRESSIONS: [&str; 47] = [
    "x - 1.0 - 0.5",
    "x / 3.0 / 2.0",
    "-x * 2.0 + 1.0",
    "-x.powi(2)",
    "(-x).powi(2)",
    "x % 1.0",
    "-x % 1.0",
    "(-x).rem_euclid(1.0)",
    "1.0 / (x - 2.5)",
    "-1.0 / (x - 2.5)",
    "(x - 2.5) / (x - 2.5)",
    "-(x - 2.5)",
    "0.0 * -x",
    "(-x).sqrt()",
    "(-x).max(f64::NAN)",
    "f64::NAN.min(x)",
    "x.max(-x).min(1.0)",
    "0.1 + 0.2",
    "0.1 + 0.2 + x",
    "x + 1e16 - 1e16",
    "f64::from(n / 2)",
    "f64::from(i / 2)",
    "f64::from(i % 4)",
    "f64::from(i.rem_euclid(4))",
    "f64::from(n) / 2.0",
    "(n as f64) / 2.0",
    "f64::from(-i / 2 * 2)",
    "f64::from(x as u8)",
    "f64::from((-x) as u8)",
    "f64::from((x * 200.0) as u8)",
    "f64::from(f64::NAN as i32)",
    "f64::from(f64::INFINITY as i32)",
    "f64::from(n as u8 as i8)",
    "f64::from((n + 250) as u8)",
    "f64::from(i as u32)",
    "f64::from(x as f32) + f64::from(0.1_f32)",
    "f64::from(1.0_f32 / 3.0_f32)",
    "f64::from(n << 3 | 1)",
    "f64::from(!i)",
    "if x < 3.0 && n > 6 || i > 0 { 1.0 } else { 2.0 }",
    "if !(x < f64::NAN) { 1.0 } else { 2.0 }",
    "(0..n).map(f64::from).sum::<f64>()",
    "(1..=4).rev().fold(0.0, |sum, k| sum * 10.0 + f64::from(k))",
    "[x, -x, 1.0].into_iter().filter(|&t| t > 0.0).min_by(|a, b| a.total_cmp(b)).unwrap()",
    "v.dot(v) - v.length_squared() + (v / 3.0).x + (v * (1.0 / 3.0)).y",
    "(x * v - v * x).length() + v.cross(Vec3::Z).y",
    "{ let mut w = v; w.x += 1.0; w.x - v.x }",
];

fn function_of(expression: &str) -> String {
    format!(
        "use common::rtweekend::*;\n\n\
         pub fn hit_sphere(v: Point3, x: f64, _ray: &Ray) -> Option<f64> {{\n    \
         let n = (x * 2.8) as u32;\n    let i = -(n as i32);\n    let _ = i;\n    \
         Some({expression})\n}}\n"
    )
}

#[test]
#[ignore = "builds a program of expressions"]
fn expressions_come_to_what_the_compiler_makes_of_them() {
    let folder = folder("expressions");
    let mut main = "#![allow(warnings)]\n".to_owned();
    let mut calls = String::new();
    for (k, expression) in EXPRESSIONS.iter().enumerate() {
        writeln!(main, "mod e{k} {{\n{}}}", function_of(expression)).expect("a string takes all");
        let call =
            format!("e{k}::hit_sphere(Vec3::new(1.0, 2.0, 3.0), std::hint::black_box(2.5), &ray)");
        writeln!(calls, "    println!(\"{{}}\", {call}.unwrap().to_bits());")
            .expect("a string takes all");
    }
    write!(
        main,
        "use common::rtweekend::*;\nfn main() {{\n    let ray = Ray::new(Vec3::ZERO, Vec3::X);\n{calls}}}\n"
    )
    .expect("a string takes all");
    write_if_changed(&folder.join("src/main.rs"), &main);
    let output = run(cargo()
        .args(["run", "--quiet", "--offline"])
        .current_dir(&folder));
    assert_success(&output);
    let ray = Ray::new(Vec3::ZERO, Vec3::X);
    for (expression, bits) in EXPRESSIONS.iter().zip(text(&output.stdout).lines()) {
        let function = function_of(expression);
        let program = read(&[("src/lib.rs", &function)])
            .unwrap_or_else(|fault| panic!("{expression}: {fault}"));
        let own = program
            .hit_sphere(Vec3::new(1.0, 2.0, 3.0), 2.5, &ray)
            .expect("it gives a number");
        let compiled = f64::from_bits(bits.parse().expect("a number"));
        let is_same = own.to_bits() == compiled.to_bits() || own.is_nan() && compiled.is_nan();
        assert!(is_same, "{expression} is {compiled:?}, and here {own:?}");
    }
}

/// Mistakes that the compiler finds, in chapter 3.
const REFUSED: [(&str, &str); 25] = [
    ("discriminant < 0.0", "discriminant < 0"),
    ("4.0 * a * c", "4 * a * c"),
    ("return None;", "return false;"),
    ("return None;", "return -1.0;"),
    (
        "Some((-b - discriminant.sqrt()) / (2.0 * a))",
        "(-b - discriminant.sqrt()) / (2.0 * a)",
    ),
    ("(2.0 * a))", "(2.0 * a));"),
    ("let oc = center", "let co = center"),
    ("discriminant.sqrt()", "discrimnant.sqrt()"),
    ("discriminant.sqrt()", "sqrt(discriminant)"),
    ("discriminant.sqrt()", "discriminant.sqroot()"),
    ("center - ray.origin", "center - ray.orig"),
    ("center - ray.origin", "center - ray.origin()"),
    ("center - ray.origin", "center - ray"),
    (
        "hit_sphere(center, 0.5, ray)",
        "hit_sphere(center, 0.5, *ray)",
    ),
    ("hit_sphere(center, 0.5, ray)", "hit_sphere(center, ray)"),
    (
        "hit_sphere(center, 0.5, ray)",
        "hit_sphere(0.5, center, ray)",
    ),
    ("hit_sphere(center, 0.5, ray)", "hit_sphere(center, 1, ray)"),
    ("ray.at(t)", "ray.at()"),
    (
        "(ray.at(t) - center).normalize()",
        "ray.at(t) - center.normalize",
    ),
    ("0.5 * (normal + Vec3::ONE)", "0.5 * (normal + 1)"),
    (
        "0.5 * (normal + Vec3::ONE)",
        "Color(normal.x, normal.y, normal.z)",
    ),
    ("    sky(ray)\n", "    sky(ray);\n"),
    (
        "let a = ray.direction.dot(ray.direction);",
        "let a = ray.direction.dot(ray.direction)",
    ),
    ("-> Option<f64>", "-> f64"),
    (
        "let discriminant = b * b",
        "let discriminant = 0.0; discriminant = b * b",
    ),
];

#[test]
#[ignore = "asks the compiler of some thirty texts"]
fn what_the_compiler_refuses_is_refused_at_the_same_line() {
    let folder = folder("refused");
    let (_, chapter) = files_of(Chapter::Normals)[0];
    for (right, wrong) in REFUSED {
        let changed = chapter.replacen(right, wrong, 1);
        write_if_changed(&folder.join("src/lib.rs"), &changed);
        let check = ["check", "--quiet", "--offline", "--message-format", "short"];
        let said = text(&run(cargo().args(check).current_dir(&folder)).stderr);
        let line = |it: &str| {
            it.strip_prefix("src/lib.rs:")?
                .split(':')
                .next()?
                .parse()
                .ok()
        };
        let errors = said.lines().filter(|it| it.contains(": error"));
        let lines: Vec<usize> = errors.filter_map(line).collect();
        assert!(!lines.is_empty(), "{wrong} compiles: {said}");
        let faults = typed::read(&[("src/lib.rs", &changed)]).expect_err(wrong);
        let place = faults[0].place.as_ref().expect("it is somewhere");
        let is_near = lines.iter().any(|it| it.abs_diff(place.line) <= 1);
        // Of a body that gives nothing the compiler shows the type that is promised.
        let is_of_a_body =
            said.contains("implicitly returns") || faults[0].help.contains("semicolon");
        assert!(
            is_near || is_of_a_body,
            "{wrong}: {}, where rustc has\n{said}",
            faults[0]
        );
    }
}

/// A folder for a crate that has the prelude.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("interpreted")
        .join(name);
    let common = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../common");
    let manifest = format!(
        "[package]\nname = \"{name}\"\nedition = \"2024\"\n\n[dependencies]\ncommon = {{ path = {common:?} }}\n\n[workspace]\n"
    );
    write_if_changed(&folder.join("Cargo.toml"), &manifest);
    folder
}
