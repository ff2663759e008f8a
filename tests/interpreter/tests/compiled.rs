//! Differential testing against the compiler: what is typed in a page is run, and refused, as
//! rustc has it.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use common::rtweekend::*;
use interpreter::Program;
use slips::{Chapter, Interpreted, Letters};

const WIDTHS: [u32; 3] = [40, 63, 100];

fn program_of(files: &[(&str, &str)]) -> Result<Program, String> {
    interpreter::read(files).map_err(|faults| faults[0].to_string())
}

/// The chapter with the first of these words replaced in one of its files.
fn with(chapter: Chapter, right: &str, wrong: &str) -> Option<Result<Program, String>> {
    let files = chapter.files();
    let changed = files
        .iter()
        .position(|(_, text)| text.matches(right).count() == 1)?;
    let text = files[changed].1.replacen(right, wrong, 1);
    let mut files = files.to_vec();
    files[changed].1 = &text;
    Some(program_of(&files))
}

#[test]
fn the_chapters_draw_their_pictures_from_their_texts() {
    for chapter in Chapter::OF_THE_BOOK {
        let program = program_of(chapter.files()).expect("rustc compiles it");
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

/// What readers have beside the chapter's text.
#[test]
fn what_the_compiler_reads_is_read() {
    let (_, normals) = Chapter::Normals.files()[0];
    let sky = "\nfn sky(ray: &Ray) -> Color {\n    Color::new(0.0, ray.direction.y, 1.0)\n}\n";
    let own_sky = format!("{normals}{sky}");
    let program = program_of(&[("src/lib.rs", &own_sky)]).expect("its own name goes first");
    let drawn = program.draw(40).expect("nothing stops it");
    assert_ne!(drawn, Chapter::Normals.picture(40));

    let renamed = normals.replace(
        "use common::rtweekend::*;",
        "mod names;\nuse common::rtweekend::*;\nuse names::Where;",
    );
    let renamed = renamed.replace("center: Point3", "center: Where");
    let names = "pub type Where = common::rtweekend::Point3;\n";
    let program = program_of(&[("src/lib.rs", &renamed), ("src/names.rs", names)])
        .expect("a type may have two names");
    let drawn = program.draw(40).expect("nothing stops it");
    assert_eq!(drawn, Chapter::Normals.picture(40));

    // An `impl` may be read before its trait.
    let mut files = Chapter::HittableList.files().to_vec();
    files[1..].reverse();
    let program = program_of(&files).expect("the order of files says nothing");
    let drawn = program.draw(40).expect("nothing stops it");
    assert_eq!(drawn, Chapter::HittableList.picture(40));
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
        let read = with(Chapter::Normals, LINE, &format!("{wrong}; {LINE}"));
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

/// Each expression as its text, and as the compiler has it.
macro_rules! expressions {
    ($x:ident $n:ident $i:ident $v:ident: $($expression:expr),* $(,)?) => {
        [$((
            stringify!($expression),
            (|$x: f64, $n: u32, $i: i32, $v: Vec3| $expression) as fn(f64, u32, i32, Vec3) -> f64,
        )),*]
    };
}

/// What people mistype, and what differs from language to language.
#[test]
#[allow(
    warnings,
    clippy::all,
    reason = "some of it looks wrong, and is asked for that"
)]
fn expressions_come_to_what_the_compiler_makes_of_them() {
    let (x, n, i, v) = (2.5, 7, -7, Vec3::new(1.0, 2.0, 3.0));
    let expressions = expressions! { x n i v:
        x - 1.0 - 0.5,
        x / 3.0 / 2.0,
        -x * 2.0 + 1.0,
        -x.powi(2),
        (-x).powi(2),
        x % 1.0,
        -x % 1.0,
        (-x).rem_euclid(1.0),
        1.0 / (x - 2.5),
        -1.0 / (x - 2.5),
        (x - 2.5) / (x - 2.5),
        -(x - 2.5),
        0.0 * -x,
        (-x).sqrt(),
        (-x).max(f64::NAN),
        f64::NAN.min(x),
        x.max(-x).min(1.0),
        0.1 + 0.2,
        0.1 + 0.2 + x,
        x + 1e16 - 1e16,
        f64::from(n / 2),
        f64::from(i / 2),
        f64::from(i % 4),
        f64::from(i.rem_euclid(4)),
        f64::from(n) / 2.0,
        (n as f64) / 2.0,
        f64::from(-i / 2 * 2),
        f64::from(x as u8),
        f64::from((-x) as u8),
        f64::from((x * 200.0) as u8),
        f64::from(f64::NAN as i32),
        f64::from(f64::INFINITY as i32),
        f64::from(n as u8 as i8),
        f64::from((n + 250) as u8),
        f64::from(i as u32),
        f64::from(x as f32) + f64::from(0.1_f32),
        f64::from(1.0_f32 / 3.0_f32),
        f64::from(n << 3 | 1),
        f64::from(!i),
        if x < 3.0 && n > 6 || i > 0 { 1.0 } else { 2.0 },
        if !(x < f64::NAN) { 1.0 } else { 2.0 },
        (0..n).map(f64::from).sum::<f64>(),
        (1..=4).rev().fold(0.0, |sum, k| sum * 10.0 + f64::from(k)),
        [x, -x, 1.0].into_iter().filter(|&t| t > 0.0).min_by(|a, b| a.total_cmp(b)).unwrap(),
        v.dot(v) - v.length_squared() + (v / 3.0).x + (v * (1.0 / 3.0)).y,
        (x * v - v * x).length() + v.cross(Vec3::Z).y,
        { let mut w = v; w.x += 1.0; w.x - v.x },
    };
    for (expression, compiled) in expressions {
        let function = format!(
            "use common::rtweekend::*;\n\n\
             pub fn hit_sphere(v: Point3, x: f64, _ray: &Ray) -> Option<f64> {{\n    \
             let n = (x * 2.8) as u32;\n    let i = -(n as i32);\n    let _ = i;\n    \
             Some({expression})\n}}\n"
        );
        let program = program_of(&[("src/lib.rs", &function)])
            .unwrap_or_else(|fault| panic!("{expression}: {fault}"));
        let own = program
            .hit_sphere(v, x, &Ray::new(Vec3::ZERO, Vec3::X))
            .expect("it gives a number");
        let compiled = compiled(x, n, i, v);
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
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("refused");
    fs::create_dir_all(folder.join("src")).expect("a folder");
    let common = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../common");
    let manifest = format!(
        "[package]\nname = \"refused\"\nedition = \"2024\"\n\n[dependencies]\n\
         common = {{ path = {common:?} }}\n\n[workspace]\n"
    );
    fs::write(folder.join("Cargo.toml"), manifest).expect("a file");
    let (_, chapter) = Chapter::Normals.files()[0];
    for (right, wrong) in REFUSED {
        let changed = chapter.replacen(right, wrong, 1);
        fs::write(folder.join("src/lib.rs"), &changed).expect("a file");
        let said = said_of(&folder);
        let lines = lines_of_errors(&said);
        assert!(!lines.is_empty(), "{wrong} compiles: {said}");
        let faults = interpreter::read(&[("src/lib.rs", &changed)]).expect_err(wrong);
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

/// What the compiler says of the crate.
fn said_of(folder: &Path) -> String {
    let check = ["check", "--quiet", "--offline", "--message-format", "short"];
    let cargo = Command::new(env!("CARGO"))
        .args(check)
        .current_dir(folder)
        .output();
    String::from_utf8_lossy(&cargo.expect("cargo starts").stderr).into_owned()
}

fn lines_of_errors(said: &str) -> Vec<usize> {
    let errors = said.lines().filter(|line| line.contains(": error"));
    let places = errors.filter_map(|line| line.strip_prefix("src/lib.rs:"));
    let numbers = places.filter_map(|place| place.split(':').next()?.parse().ok());
    numbers.collect()
}
