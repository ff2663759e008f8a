//! What is typed in a page gets the answer that `watch` has for the same text in a crate, and
//! can be taken home as one.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use check::whole::Line;
use page::home::archive;
use page::typed::Text;
use slips::Chapter;
use suite::command::files;
use suite::left_out::left_out;
use suite::mine::Mine;

#[test]
#[ignore = "builds a reader's crate a dozen times"]
fn the_page_says_what_watch_says_of_the_same_text() {
    let mine = Mine::empty();
    for (chapter, old, new) in TYPED {
        let mut text = Text::full(chapter);
        let found = text.files.iter_mut().find(|(_, text)| text.contains(old));
        let (_, file) = found.expect("the chapter has the line");
        *file = file.replace(old, new);
        let folder = mine.path().join(chapter.name());
        if !folder.exists() {
            mine.make(chapter.name(), &[]);
        }
        for (name, text) in &text.files {
            fs::write(folder.join(name), text).expect("it is typed");
        }
        let watch = squeezed(&mine.watch_once(chapter.name()));
        for line in said(&text) {
            assert!(
                watch.contains(&line),
                "{new}: watch says\n{watch}\nand not\n{line}"
            );
        }
    }
}

/// In each chapter something that is wrong, right in other words, or wrong where no picture
/// shows it.
const TYPED: [(Chapter, &str, &str); 12] = [
    (Chapter::Gradient, "0.5 * (", "0.5 + ("),
    (
        Chapter::RedSphere,
        "discriminant >= 0.0",
        "discriminant > 0.0",
    ),
    (Chapter::RedSphere, "- radius * radius", "- radius"),
    (Chapter::Normals, "let b = -2.0", "let b = 2.0"),
    (Chapter::Normals, "(2.0 * a)", "2.0 * a"),
    (Chapter::Normals, "ray.at(t) - center", "center - ray.at(t)"),
    (
        Chapter::Normals,
        "let c = oc.dot(oc) - radius * radius",
        "let c = oc.length_squared() - radius.powi(2)",
    ),
    (Chapter::HalfBSphere, "Some((h - ", "Some((-h - "),
    (
        Chapter::HalfBSphere,
        "discriminant < 0.0",
        "discriminant <= 0.0",
    ),
    (Chapter::HittableList, "-100.5", "-100.0"),
    (
        Chapter::HittableList,
        "* (1.0 / self.radius)",
        "* self.radius",
    ),
    (
        Chapter::HittableList,
        "0.0, f64::INFINITY",
        "0.001, f64::INFINITY",
    ),
];

/// The headline and the rows, but for what to do next, which names commands.
fn said(text: &Text) -> Vec<String> {
    let program = text.read().expect("it is a program");
    let picture = text
        .draw(&program, text.chapter.book_width())
        .expect("it draws");
    let verdict = text.verdict(Box::leak(Box::new(program)), &picture);
    let row = |line: &Line| match line {
        Line::Labeled(label, _) if label == "to see it" => None,
        Line::Labeled(label, text) => Some(squeezed(&format!("{label} {text}"))),
        Line::Printed(text) => Some(squeezed(text)),
    };
    let rows = verdict.cause.iter().filter_map(row);
    [squeezed(&verdict.headline)]
        .into_iter()
        .chain(rows)
        .collect()
}

fn squeezed(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn what_is_taken_home_from_a_page_is_the_crate_that_start_makes() {
    for chapter in &Chapter::OF_THE_BOOK[1..] {
        let mine = Mine::empty();
        let name = chapter.name();
        let skeleton = Text::skeleton(*chapter);
        let home = tempfile::tempdir().expect("a folder");
        let tar = Command::new("tar")
            .args(["-x", "-f", "-"])
            .current_dir(&home)
            .stdin(Stdio::piped())
            .spawn();
        let Ok(mut tar) = tar else {
            left_out("there is no tar here to unpack what is taken home");
            return;
        };
        let mut given = tar.stdin.take().expect("its input");
        given.write_all(&archive(&skeleton, 7)).expect("it reads");
        drop(given);
        assert!(tar.wait().expect("it ends").success());
        mine.make(name, &[]);
        let started = mine.path().join(name);
        let is_typed = |file: &Path| ["src", "tests"].iter().any(|it| file.starts_with(it));
        for file in files(&started) {
            let below = file.strip_prefix(&started).expect("it is inside");
            if is_typed(below) {
                let taken = home.path().join("mine").join(name).join(below);
                let taken = fs::read_to_string(taken).expect("it is there");
                let started = fs::read_to_string(&file).expect("a source");
                assert_eq!(code(&taken), code(&started), "{name}: {}", below.display());
            }
        }
    }
}

/// Without the steps, which a page has beside the text, and without what was typed before.
fn code(text: &str) -> Vec<&str> {
    let is_code = |line: &&str| !line.trim_start().starts_with("//") && !line.is_empty();
    text.lines().filter(is_code).collect()
}
