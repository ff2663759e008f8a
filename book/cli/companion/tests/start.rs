//! A crate of the reader's own: made, typed, carried on, and put under the laws.

use std::fs;

use common::rtweekend::Picture;
use fixtures::command::{assert_success, cargo, names_in, run, text};
use fixtures::desk::Desk;
use fixtures::reader::TestReader;
use fixtures::typing::typings;
use fixtures::workspace;
use insta::assert_snapshot;
use slips::Chapter;
use tempfile::TempDir;

/// The chapters that a reader types in crates.
const TYPED: &[Chapter] = {
    let [_, typed @ ..] = &Chapter::OF_THE_BOOK;
    typed
};

const OWN_PRELUDE: [&[&str]; 2] = [&[], &["--own-prelude"]];

/// With our prelude, and with vectors, rays, the camera and the text of a picture typed too.
#[test]
#[ignore = "builds ten crates of a reader"]
fn every_chapter_can_be_typed_and_begins_with_the_one_before() {
    for prelude in OWN_PRELUDE {
        let reader = TestReader::empty();
        for &chapter in TYPED {
            if chapter == Chapter::HittableList {
                reader.make(chapter.name(), prelude);
                type_the_files_in_order(&reader);
            } else {
                start_and_type(&reader, chapter, prelude);
                go_through_the_steps(&reader, chapter.name());
            }
            let said = reader.watch_once(chapter.name());
            assert!(said.contains("to the last bit."), "{chapter:?}:\n{said}");
            let is_judged = chapter != Chapter::Gradient || !prelude.is_empty();
            assert_eq!(said.contains("The laws hold."), is_judged, "{said}");
        }
        // What was typed in chapter 1 is still what the sky is.
        let last = fs::read_to_string(reader.lib("hittable_list")).expect("the chapter");
        assert!(last.contains("pub fn sky(ray: &Ray) -> Color {\n    let white"));
        paste_the_tests_of_reports(&reader, prelude);
    }
}

/// Types each step of the chapter but the last, as its page shows it, and looks at the answer.
fn go_through_the_steps(reader: &TestReader, chapter: &str) {
    for step in typings(include_str!("programs/steps.txt")) {
        let Some(number) = step.title.strip_prefix(&format!("{chapter} ")) else {
            continue;
        };
        let (file, source) = reader.source_with(chapter, &step.changes[0].old);
        reader.make_changes(chapter, &step);
        let said = reader.watch_once(chapter);
        let right = ["Step", "This is what step"].map(|it| format!("{it} {number} of"));
        let is_right = right.iter().any(|right| said.contains(right));
        assert!(is_right, "{step:?}:\n{said}");
        fs::write(&file, source).expect("the chapter is saved");
    }
}

/// Types one file after the other: each is judged as soon as it is full, and the next one is named.
fn type_the_files_in_order(reader: &TestReader) {
    let chapter = Chapter::HittableList;
    let order = ["hittable", "sphere", "hittable_list", "lib"].map(|it| format!("src/{it}.rs"));
    let obeyed = ["set_face_normal", "sphere", "list"];
    for (at, file) in order.iter().enumerate() {
        let said = reader.watch_once(chapter.name());
        assert!(said.contains(&format!("todo!() at {file}:")), "{said}");
        for (before, name) in obeyed.iter().enumerate() {
            let laws = said.lines().find(|line| line.contains("hold so far for"));
            let is_said = laws.is_some_and(|line| line.contains(name));
            assert_eq!(is_said, before < at, "{name}:\n{said}");
        }
        reader.type_file(chapter, file);
    }
    let said = reader.watch_once(chapter.name());
    assert!(said.contains("Step 1 of 2 is right."), "{said}");
    reader.add_the_ground();
}

#[test]
fn a_crate_is_made_once_and_nothing_that_was_typed_is_written_over() {
    let reader = TestReader::empty();
    reader.desk.write("mine/file", "");
    let said = reader.desk.transcript(
        "rtrace start normals
         rtrace start 3
         rtrace start chapters/3_normals/ --into mine/file/deeper",
    );
    assert_snapshot!(said);
}

/// To cargo two crates are one if they have the same name and version, in whatever folders.
#[test]
#[ignore = "builds two crates of a reader"]
fn crates_of_one_name_in_two_folders_do_not_take_the_place_of_each_other() {
    let reader = TestReader::empty();
    reader.make("gradient", &[]);
    reader.make("gradient", &["--into", "other"]);
    reader.type_all(Chapter::Gradient);
    let other = run(&mut reader.rtrace(&["watch", "gradient", "--in", "other", "--once"]));
    assert!(text(&other.stdout).contains("Not written yet"));
    let said = reader.watch_once("gradient");
    assert!(said.contains("to the last bit."), "{said}");
}

#[test]
fn what_cannot_be_read_is_not_carried_over_and_that_is_said() {
    let reader = TestReader::empty();
    reader.make("gradient", &[]);
    fs::write(reader.lib("gradient"), "pub fn ray_color(").expect("a file");
    // An editor has it open, and a note is no text.
    reader.desk.write("mine/gradient/src/.lib.rs.swp", b"\xff");
    reader.desk.write("mine/gradient/src/note.bin", b"\xff");
    let said = text(&reader.desk.run("rtrace start red_sphere").stdout);
    assert!(
        said.contains("Nothing is carried over from gradient"),
        "{said}"
    );
    let names = names_in(&reader.path().join("red_sphere/src"));
    assert_eq!(names, ["lib.rs", "main.rs", "note.bin"]);
}

#[test]
fn what_the_reader_added_is_carried_over_once() {
    let reader = TestReader::empty();
    reader.make("gradient", &[]);
    let lib = reader.lib("gradient");
    let source = fs::read_to_string(&lib).expect("the chapter");
    fs::write(&lib, source + "fn one() {} fn two() {}\n").expect("it is typed");
    reader.make("red_sphere", &[]);
    let carried = fs::read_to_string(reader.lib("red_sphere")).expect("the chapter");
    for item in ["fn one() {}", "fn two() {}"] {
        assert_eq!(carried.matches(item).count(), 1, "{item} in\n{carried}");
    }
}

#[test]
fn from_anywhere_below_the_same_crates_are_meant() {
    let reader = TestReader::empty();
    reader.make("gradient", &[]);
    let inside = reader.path().join("gradient/src");
    for words in [&["start", "red_sphere"][..], &["done", "-b was b"]] {
        assert_success(&run(reader.rtrace(words).current_dir(&inside)));
    }
    let names = names_in(&reader.path());
    assert_eq!(names, ["done.md", "gradient", "red_sphere"]);
}

#[cfg(unix)]
#[test]
fn the_list_of_done_things_has_what_came_out_right_once_and_the_readers_own_lines() {
    let desk = Desk::default();
    let white = Picture::from_rgb(32, 18, vec![255; 3 * 32 * 18]);
    desk.write_picture("white.ppm", &white.expect("three bytes a pixel"));
    for _twice in 0..2 {
        desk.run("rtrace watch gradient --once -- cat white.ppm");
    }
    desk.run("rtrace done red and green were swapped");
    let undated = |text: &str| {
        let lines = text.lines().map(|line| match line.split_once("- 20") {
            Some((before, date)) => format!("{before}- …{}\n", &date[8..]),
            None => format!("{line}\n"),
        });
        lines.collect::<String>()
    };
    let list = undated(&desk.read("done.md"));
    assert_snapshot!(list + "\n" + &undated(&desk.transcript("rtrace done")));
}

#[cfg(unix)]
#[test]
fn in_the_workspace_a_watched_program_adds_to_the_list_of_the_crates() {
    let desk = Desk::default();
    for part in ["common/Cargo.toml", "tests/laws/Cargo.toml", "book/notes/"] {
        desk.write(part, "");
    }
    let white = Picture::from_rgb(32, 18, vec![255; 3 * 32 * 18]);
    desk.write_picture("white.ppm", &white.expect("three bytes a pixel"));
    desk.run("rtrace watch gradient --once -- cat white.ppm");
    assert!(desk.read("mine/done.md").contains("gradient: step 1"));
    assert!(
        desk.transcript("rtrace done")
            .starts_with("$ rtrace done\nDone, in mine/done.md")
    );
    assert!(!desk.path("done.md").exists());
}

/// A report ends with a test to paste, which compiles there and fails.
fn paste_the_tests_of_reports(reader: &TestReader, prelude: &[&str]) {
    for mistake in typings(include_str!("programs/mistakes.txt")) {
        let chapter = &*mistake.title;
        // Of chapter 1 only a prelude is under laws.
        if chapter == "gradient" && prelude.is_empty() {
            continue;
        }
        let (mistyped, right_source) = reader.source_with(chapter, &mistake.changes[0].old);
        reader.make_changes(chapter, &mistake);
        let said = test_the_laws(reader, chapter, &[]);
        let pasted = said
            .split_once("#[test]\n")
            .and_then(|(_, it)| it.split_once("\n}\n"));
        let (pasted, _) = pasted.unwrap_or_else(|| panic!("{mistake:?}: {said}"));
        let law = reader.path().join(chapter).join("tests/laws.rs");
        let source = fs::read_to_string(&law).expect("the test");
        fs::write(&law, format!("{source}\n#[test]\n{pasted}\n}}\n")).expect("it is pasted");
        let said = test_the_laws(reader, chapter, &["this_case_is_right"]);
        assert!(
            said.contains("0 passed; 1 failed"),
            "{chapter}: {pasted}\n{said}"
        );
        fs::write(&law, source).expect("the test as it was");
        fs::write(&mistyped, right_source).expect("the chapter as it was");
    }
}

fn test_the_laws(reader: &TestReader, chapter: &str, words: &[&str]) -> String {
    let mut cargo = cargo();
    cargo
        .args(["test", "--quiet", "--test", "laws"])
        .args(words);
    cargo.env_remove("RUST_BACKTRACE");
    let output = run(cargo.current_dir(reader.path().join(chapter)));
    text(&output.stdout) + &text(&output.stderr)
}

/// Cargo puts the settings of all folders above together.
#[test]
#[ignore = "builds the companion again, if the settings differ"]
fn in_a_crate_inside_the_workspace_cargo_rtrace_is_the_same() {
    let crates = TempDir::new_in(workspace().join("target")).expect("a folder");
    let into = crates.path().to_str().expect("a name in UTF-8");
    TestReader::empty().make("normals", &["--into", into]);
    let mut cargo = cargo();
    cargo.args(["rtrace", "hit", "--help"]);
    let said = run(cargo.current_dir(crates.path().join("normals/src")));
    assert!(
        text(&said.stdout).starts_with("Look at one ray"),
        "{}",
        text(&said.stderr)
    );
}

fn start_and_type(reader: &TestReader, chapter: Chapter, prelude: &[&str]) {
    reader.make(chapter.name(), prelude);
    if chapter == Chapter::Gradient && !prelude.is_empty() {
        for typing in typings(include_str!("programs/own_prelude.txt")) {
            reader.make_changes(chapter.name(), &typing);
        }
    }
    reader.type_all(chapter);
}
