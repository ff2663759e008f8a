//! Differential testing against the compiler: what is typed in a page is run, and refused, as
//! rustc has it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use common::rtweekend::*;
use interpreter::{Ball, Fault, FaultKind, Program, SourceFile};
use slips::{Chapter, ChapterCode};

const WIDTHS: [u32; 3] = [40, 63, 100];

fn read<T: AsRef<str>>(files: &[(&str, T)]) -> Result<Program, Fault> {
    let files = files
        .iter()
        .map(|(name, text)| SourceFile::new(*name, text.as_ref()));
    interpreter::read(&files.collect::<Vec<_>>()).map_err(|faults| faults[0].clone())
}

fn texts(chapter: Chapter) -> Vec<(&'static str, &'static str)> {
    let files = chapter.files().iter();
    files.map(|file| (file.name, file.text)).collect()
}

/// Returns the files of a chapter with the first of these words replaced.
fn replaced(chapter: Chapter, right: &str, wrong: &str) -> Vec<(&'static str, String)> {
    let files = chapter.files().iter();
    let mut files: Vec<_> = files.map(|it| (it.name, it.text.to_owned())).collect();
    let changed = files.iter_mut().find(|it| it.1.contains(right));
    let (_, text) = changed.unwrap_or_else(|| panic!("{right} is not there"));
    *text = text.replacen(right, wrong, 1);
    files
}

fn with(chapter: Chapter, right: &str, wrong: &str) -> Result<Program, Fault> {
    read(&replaced(chapter, right, wrong))
}

#[test]
fn the_chapters_draw_their_pictures_from_their_texts() {
    for chapter in Chapter::OF_THE_BOOK {
        let program = read(&texts(chapter)).expect("rustc compiles it");
        for width in WIDTHS {
            let drawn = program.draw(width).expect("nothing stops it");
            assert_eq!(drawn, chapter.picture(width), "{chapter:?} at {width}");
        }
    }
}

/// Two functions with other texts, one after the other, and one that does not go with the rest.
#[test]
fn a_function_that_is_read_anew_draws_what_the_whole_text_does() {
    let text = Chapter::Normals.files()[0].text;
    let mistakes = [
        ("hit_sphere", "discriminant < 0.0", "discriminant > 0.0"),
        ("ray_color", "0.5 * (normal + Vec3::ONE)", "normal"),
    ];
    let right = read(&[("src/lib.rs", text)]).expect("rustc compiles it");
    let (mut patched, mut text) = (right.clone(), text.to_owned());
    for (function, line, wrong) in mistakes {
        let old = patched.functions().find(|it| it.0 == function);
        let new = old.expect("it is there").1.replace(line, wrong);
        patched = patched.patched(function, &new).expect("rustc compiles it");
        text = text.replace(line, wrong);
        let whole = read(&[("src/lib.rs", &text)]).expect("rustc compiles it");
        assert_eq!(patched.draw(63), whole.draw(63), "{function}");
        assert_ne!(patched.draw(63), right.draw(63), "{function}");
    }
    let patched = right.patched("ray_color", "fn ray_color(ray: &Ray) -> Color { ray }");
    let drawn = patched.expect("types are seen when it runs").draw(16);
    assert!(drawn.is_err_and(|it| it.message == "mismatched types"));
}

#[test]
fn a_mutant_runs_by_its_number_and_one_that_is_refused_is_lost_alone() {
    const ROWS: [(&str, &str); 2] = [
        ("unit_direction.y + 1.0", "unit_direction.y - 1.0"),
        (
            "(1.0 - a) * white + a * blue",
            "a * white + (1.0 - a) * blue",
        ),
    ];
    let mutants = "let a = mutants!(4, 0.5 * mutants!(7, (unit_direction.y + 1.0), \
         (unit_direction.y - 1.0)), unit_direction);";
    let sum = "mutants!(9, (1.0 - a) * white + a * blue, white, a * white + (1.0 - a) * blue)";
    let text = Chapter::Gradient.files()[0].text;
    let text = text.replace("let a = 0.5 * (unit_direction.y + 1.0);", mutants);
    let text = text.replace(ROWS[1].0, sum);
    let all = read(&[("src/lib.rs", &text)]).expect("it is read");
    let is_same = |number, other: &Program| all.with_mutant(number).draw(40) == other.draw(40);
    let typed = |row: usize| with(Chapter::Gradient, ROWS[row].0, ROWS[row].1);
    let right = read(&texts(Chapter::Gradient)).expect("rustc compiles it");
    for nothing in [0, 5, 8, 11] {
        assert!(is_same(nothing, &right), "{nothing}");
    }
    assert!(is_same(7, &typed(0).expect("it is read")));
    assert!(is_same(10, &typed(1).expect("it is read")));
    let half = "0.5 * (unit_direction.y + 1.0)";
    let other = with(Chapter::Gradient, half, "unit_direction");
    assert!(is_same(4, &other.expect("it is read")));
}

#[test]
fn what_the_compiler_reads_is_read() {
    let normals = Chapter::Normals.files()[0].text;
    let sky = "fn sky(ray: &Ray) -> Color {\n    Color::new(0.0, ray.direction.y, 1.0)\n}\n";
    let own_sky = format!("{normals}\n{sky}");
    let program = read(&[("src/lib.rs", &own_sky)]).expect("its own name goes first");
    let drawn = program.draw(40).expect("nothing stops it");
    assert_ne!(drawn, Chapter::Normals.picture(40));

    for row in rows::<3>(include_str!("texts/read.txt")) {
        let drawn = read(&changed(&row)).and_then(|it| it.draw(40));
        let chapter = Chapter::find(&row[0]).expect("a chapter");
        assert_eq!(drawn, Ok(chapter.picture(40)), "{row:?}");
    }
}

#[test]
fn a_prelude_of_ones_own_draws_the_picture_and_is_asked() {
    let chapter = Chapter::HittableList;
    let files = texts(chapter).into_iter().map(|(name, text)| {
        let text = text.replace("use common::rtweekend::*;", "use crate::rtweekend::*;");
        let text = match name {
            "src/lib.rs" => format!("{text}\nmod rtweekend;\n"),
            _ => text,
        };
        (name, text)
    });
    let mut files: Vec<(&str, String)> = files.collect();
    // An `impl` may be read before its trait.
    files.reverse();
    let own_prelude = include_str!("texts/own_prelude.rs");
    files.push(("src/rtweekend.rs", own_prelude.to_owned()));
    let program = read(&files).expect("rustc compiles it");
    assert_eq!(
        program.draw(16).expect("nothing stops it"),
        chapter.picture(16)
    );
    let right = read(&texts(chapter)).expect("rustc compiles it");
    let ray = Ray::new(Vec3::ZERO, Vec3::new(0.1, 0.2, -1.0));
    assert_eq!(program.ray_color(&ray), right.ray_color(&ray));
    let ball = Ball::new(0.0, 0.0, -1.0, 0.5);
    let hit = right.record(ball, &ray, 0.0, 9.0).map(|it| it.normal);
    assert_eq!(
        program.record(ball, &ray, 0.0, 9.0).map(|it| it.normal),
        hit
    );
}

#[test]
fn a_function_that_ends_with_an_early_return_so_far_is_unfinished() {
    let read = read(&replaced(Chapter::Normals, "    sky(ray)\n", ""));
    assert_eq!(
        read.map(drop).map_err(|it| it.kind),
        Err(FaultKind::Unfinished)
    );
}

/// A text that never ends does not make the page wait, and one that is no Rust is refused.
#[test]
fn a_text_without_an_end_is_answered_at_once() {
    const LINE: &str = "let oc = center - ray.origin;";
    let wrongs = [
        "loop {}",
        "while true {}",
        "hit_sphere(center, radius, ray)",
        r"'\é'",
        "\u{202e}\u{0} <script>alert(1)</script>",
    ];
    for wrong in wrongs {
        let start = Instant::now();
        let read = with(Chapter::Normals, LINE, &format!("{wrong}; {LINE}"));
        let is_drawn = read.is_ok_and(|it| it.draw(40).is_ok());
        assert!(!is_drawn, "{wrong} is drawn");
        assert!(
            start.elapsed() < Duration::from_secs(2),
            "{wrong} takes too long"
        );
    }
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
    0.1 + 0.2,
    0.1 + 0.2 + x,
    x + 1e16 - 1e16,
    f64::from(n / 2),
    f64::from(i / 2),
    f64::from(n) / 2.0,
    (n as f64) / 2.0,
    f64::from(-i / 2 * 2),
    f64::from(x as u8),
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
};

#[test]
fn expressions_come_to_what_the_compiler_makes_of_them() {
    let (x, n, i, v) = (2.5, 7, -7, Vec3::new(1.0, 2.0, 3.0));
    for (expression, compiled) in EXPRESSIONS {
        let function = format!(
            "use common::rtweekend::*;\n\n\
             pub fn hit_sphere(v: Point3, x: f64, _ray: &Ray) -> Option<f64> {{\n    \
             let n = (x * 2.8) as u32;\n    let i = -(n as i32);\n    let _ = i;\n    \
             Some({expression})\n}}\n"
        );
        let program = read(&[("src/lib.rs", &function)])
            .unwrap_or_else(|fault| panic!("{expression}: {fault}"));
        let own = program
            .hit_sphere(v, x, &Ray::new(Vec3::ZERO, Vec3::X))
            .expect("it gives a number");
        let compiled = compiled(x, n, i, v);
        let is_same = own.to_bits() == compiled.to_bits() || own.is_nan() && compiled.is_nan();
        assert!(is_same, "{expression} is {compiled:?}, and here {own:?}");
    }
}

/// Returns the rows of a table without its head, split at ` ¦ `.
fn rows<const N: usize>(table: &str) -> Vec<[String; N]> {
    let rows = table.lines().skip(1);
    let parts = rows.map(|row| row.splitn(N, " ¦ ").map(|it| it.replace('⏎', "\n")));
    let parts = parts.map(Iterator::collect::<Vec<_>>);
    parts
        .map(|it| it.try_into().expect("all its parts"))
        .collect()
}

/// A table of mistakes that the compiler finds: the chapter, a text of it, the text typed in its
/// place, and the line and message of the fault.
const REFUSED: &str = include_str!("texts/refused.txt");

/// Returns the files of a row's chapter, one of them changed as the row says.
fn changed(row: &[String]) -> Vec<(&'static str, String)> {
    let [name, right, wrong, ..] = row else {
        panic!("{row:?} is no row");
    };
    replaced(Chapter::find(name).expect("a chapter"), right, wrong)
}

/// Returns the file, the line and the message of the first fault, or of the first lines that were
/// not checked.
fn said_here(files: &[(&'static str, String)]) -> Option<(String, usize, String)> {
    let there = |file: usize, line, said: &str| Some((files[file].0.to_owned(), line, said.into()));
    let drawn = read(files).and_then(|program| program.draw(16).map(|_| program));
    let fault = match drawn {
        Err(fault) => fault,
        Ok(program) => {
            let it = program.unchecked().into_iter().next()?;
            return there(it.file, *it.lines.start(), "unchecked");
        }
    };
    let place = fault.place.unwrap_or_default();
    let stops = if fault.kind == FaultKind::Stopped {
        "stops: "
    } else {
        ""
    };
    let said = format!("{stops}{}: {}", fault.message, fault.label);
    there(place.file, place.line, said.trim_end_matches(": "))
}

#[test]
fn what_the_compiler_refuses_or_is_not_known_is_refused() {
    let mut other = String::new();
    let unknown = rows::<4>(include_str!("texts/unknown.txt"));
    for row in rows::<4>(REFUSED).into_iter().chain(unknown) {
        let files = changed(&row);
        let said = said_here(&files).map_or("accepted".to_owned(), |(_, line, said)| {
            format!("{line}: {said}")
        });
        if said != row[3] {
            other += &row[..3].join(" ¦ ").replace('\n', "⏎");
            other += &format!(" ¦ {said}\n");
        }
    }
    assert!(other.is_empty(), "otherwise is said\n{other}");
}

#[test]
fn a_reference_where_a_value_is_wanted_has_the_help_of_the_compiler() {
    let typed = with(Chapter::Normals, "direction.dot(oc)", "direction.dot(&oc)");
    let drawn = typed.expect("types are seen when it runs").draw(16);
    let said = drawn.expect_err("rustc refuses it").to_string();
    assert!(said.ends_with("; consider removing the borrow"), "{said}");
}

#[test]
#[ignore = "asks the compiler of a hundred texts"]
fn most_faults_are_in_the_line_and_the_words_of_the_compiler() {
    let folder = crate_of_ones_own("refused");
    let (mut lines, mut words, mut all) = (0, 0, 0);
    for row in rows::<4>(REFUSED) {
        let files = changed(&row);
        let compiled = said_of(&folder, &files);
        assert!(compiled.contains(": error"), "{row:?} compiles");
        let (file, line, said) = said_here(&files).unwrap_or_default();
        let place = format!("{file}:{line}:");
        let there: Vec<&str> = compiled
            .lines()
            .filter(|it| it.starts_with(&place))
            .collect();
        let message = said.split(':').next().unwrap_or_default();
        let is_same = there
            .iter()
            .any(|it| it.contains(message) && !message.is_empty());
        all += 1;
        lines += usize::from(!there.is_empty());
        words += usize::from(is_same);
        if !is_same {
            println!("{row:?}: here {place} {said}\n{compiled}");
        }
    }
    println!("{all} texts: {lines} in the same line, {words} in the same words");
    assert!(
        10 * lines > 9 * all,
        "only {lines} of {all} are in the same line"
    );
}

#[test]
#[ignore = "asks the compiler of a hundred texts"]
fn what_is_read_or_is_not_known_compiles() {
    let folder = crate_of_ones_own("read");
    let unknown = rows::<4>(include_str!("texts/unknown.txt"));
    let unknown = unknown.iter().map(|row| changed(row));
    let read = rows::<3>(include_str!("texts/read.txt"));
    let read = read.iter().map(|row| changed(row));
    let refused = unknown.chain(read).filter_map(|files| {
        let compiled = said_of(&folder, &files);
        compiled.contains(": error").then_some(compiled)
    });
    let refused: Vec<String> = refused.collect();
    assert!(refused.is_empty(), "{}", refused.join("\n"));
}

/// Makes a folder with the manifest of a crate, and returns its path.
fn crate_of_ones_own(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let common = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../common");
    fs::create_dir_all(folder.join("src")).expect("a folder");
    let manifest = format!(
        "[package]\nname = \"{name}\"\nedition = \"2024\"\n\n[dependencies]\n\
         common = {{ path = {common:?} }}\n\n[workspace]\n"
    );
    fs::write(folder.join("Cargo.toml"), manifest).expect("a file");
    folder
}

/// Returns the compiler's messages for the crate with these files.
fn said_of(folder: &Path, files: &[(&'static str, String)]) -> String {
    for (name, text) in files {
        fs::write(folder.join(name), text).expect("a file");
    }
    let check = ["check", "--quiet", "--offline", "--message-format", "short"];
    let cargo = Command::new(env!("CARGO"))
        .args(check)
        .current_dir(folder)
        .output();
    String::from_utf8_lossy(&cargo.expect("cargo starts").stderr).into_owned()
}
