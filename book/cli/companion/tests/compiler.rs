//! Golden messages: the compiler's errors that the pages show are its own.
//!
//! Each is a slip of the hand, made in the chapter in which it is likely.

use std::fs;
use std::process::Command;

use insta::assert_snapshot;
use slips::{Chapter, ChapterCode};

use fixtures::command::{cargo, run, text};
use fixtures::drawn::shown_in;
use fixtures::left_out::left_out;
use fixtures::reader::TestReader;
use fixtures::typing::{Typing, typings};
use fixtures::workspace;

#[test]
#[ignore = "builds chapters with mistakes in them"]
fn the_pages_show_what_the_compiler_says() {
    let version = env!("CARGO_PKG_RUST_VERSION");
    let rustc = text(&run(Command::new("rustc").arg("--version")).stdout);
    if !rustc.starts_with(&format!("rustc {version}.")) {
        left_out(&format!(
            "the errors that the pages show, which are those of Rust {version}"
        ));
        return;
    }
    let reader = TestReader::empty();
    for mistake in typings(include_str!("compiler.txt")) {
        let (name, chapter) = mistake.title.split_once(" in ").expect("a chapter");
        make(
            &reader,
            Chapter::find(chapter).expect("a chapter"),
            &mistake,
        );
        let said = page_of(&first_error(&reader, chapter));
        shown_in("compiler").bind(|| assert_snapshot!(name, said));
    }
}

/// Types the chapter as the pages show it into a reader's crate, with the mistake in it.
fn make(reader: &TestReader, chapter: Chapter, mistake: &Typing) {
    let folder = reader.path().join(chapter.name());
    if !folder.exists() {
        reader.make(chapter.name(), &[]);
    }
    let ours = format!("chapters/{}_{}", chapter as usize, chapter.name());
    for file in chapter.files() {
        let ours = workspace().join(&ours).join(file.name);
        fs::copy(ours, folder.join(file.name)).expect("it is saved");
    }
    reader.make_changes(chapter.name(), mistake);
}

/// Returns the first error that cargo prints in the crate of that chapter.
fn first_error(reader: &TestReader, chapter: &str) -> String {
    let mut cargo = cargo();
    cargo.args(["check", "--offline", "--quiet"]);
    let output = run(cargo.current_dir(reader.path().join(chapter)));
    let said = text(&output.stderr);
    let error = said.split("\n\n").find(|it| it.starts_with("error"));
    error.map_or_else(|| panic!("{chapter} compiles:\n{said}"), str::to_owned)
}

/// Writes the error as Markdown, without lists of types that would have done: they are long, and
/// depend on the libraries.
fn page_of(error: &str) -> String {
    let others = "   = help: the following other types";
    let error = error.split(others).next().unwrap_or(error);
    format!("```text\n{}\n```\n", error.trim_end())
}
