//! A text that is typed in a page gets the answer that `watch` has for it in a crate, and can be
//! taken home as one.

use std::fs;
use std::path::Path;
use std::process::Command;

use check::answer::{Row, RowKind};
use fixtures::command::files;
use fixtures::left_out::left_out;
use fixtures::reader::TestReader;
use page::home::archive;
use page::typed::Draft;
use slips::Chapter;

#[test]
#[ignore = "builds a reader's crate a dozen times"]
fn the_page_says_what_watch_says_of_the_same_text() {
    let reader = TestReader::empty();
    for (chapter, old, new) in TYPED {
        let mut draft = Draft::complete(chapter);
        let found = draft.files.iter_mut().find(|it| it.text.contains(old));
        let file = &mut found.expect("the chapter has the line").text;
        *file = file.replace(old, new);
        let folder = reader.path().join(chapter.name());
        if !folder.exists() {
            reader.make(chapter.name(), &[]);
        }
        for file in &draft.files {
            fs::write(folder.join(&file.name), &file.text).expect("it is typed");
        }
        let watch = squeezed(&reader.watch_once(chapter.name()));
        for line in said(&draft) {
            assert!(
                watch.contains(&line),
                "{new}: watch says\n{watch}\nand not\n{line}"
            );
        }
    }
}

/// In each chapter something that is wrong, right in other words, or wrong where no picture
/// shows it.
const TYPED: [(Chapter, &str, &str); 7] = [
    (Chapter::Gradient, "0.5 * (", "0.5 + ("),
    (Chapter::RedSphere, "minant >= 0.0", "minant > 0.0"),
    (Chapter::Normals, "(2.0 * a)", "2.0 * a"),
    (Chapter::Normals, "oc.dot(oc)", "oc.length_squared()"),
    (Chapter::HalfBSphere, "minant < 0.0", "minant <= 0.0"),
    (Chapter::HittableList, "-100.5", "-100.0"),
    (Chapter::HittableList, "0.0, f64::INF", "0.001, f64::INF"),
];

/// Returns the headline and the rows of the answer, without the advice, which names commands.
fn said(draft: &Draft) -> Vec<String> {
    let program = draft.read().expect("it is a program");
    let picture = draft
        .draw(&program, draft.chapter.book_width())
        .expect("it draws");
    let answer = draft.answer(&program, &picture);
    let row = |row: &Row| match row.kind {
        RowKind::Probe(_) => None,
        kind => Some(squeezed(&format!("{} {}", kind.label(), row.text))),
    };
    let rows = answer.rows.iter().filter_map(row);
    [squeezed(&answer.headline.to_string())]
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
        let reader = TestReader::empty();
        let name = chapter.name();
        reader
            .desk
            .write("home.tar", archive(&Draft::skeleton(*chapter), 7));
        reader.desk.write("home/", "");
        let mut tar = Command::new("tar");
        tar.args(["-x", "-f", "home.tar", "-C", "home"]);
        let Ok(unpacked) = tar.current_dir(reader.desk.path("")).status() else {
            return left_out("there is no tar here to unpack what is taken home");
        };
        assert!(unpacked.success());
        reader.make(name, &[]);
        let started = reader.path().join(name);
        let is_typed = |file: &Path| file.starts_with("src") || file.starts_with("tests");
        for file in files(&started) {
            let below = file.strip_prefix(&started).expect("it is inside");
            if is_typed(below) {
                let taken = reader.desk.path("home/mine").join(name).join(below);
                let taken = fs::read_to_string(taken).expect("it is there");
                let started = fs::read_to_string(&file).expect("a source");
                assert_eq!(code(&taken), code(&started), "{name}: {}", below.display());
            }
        }
    }
}

/// Returns the lines of code, without the steps, which a page has beside the text, and empty lines.
fn code(text: &str) -> Vec<&str> {
    let is_code = |line: &&str| !line.trim_start().starts_with("//") && !line.is_empty();
    text.lines().filter(is_code).collect()
}
