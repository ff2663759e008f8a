//! Listings can be typed: each into the file that it names, in the
//! order of the pages, and the pictures come out.

use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use scraper::ElementRef;
use slips::{Chapter, ChapterCode};

use crate::book::whole::{self, WORKSPACE, folder_of, page_of, text_of};
use fixtures::command::{cargo, files, run, text};
use fixtures::drawn::p3;

#[test]
#[ignore = "builds what the pages list"]
fn what_the_pages_list_is_all_that_must_be_typed_to_get_their_pictures() {
    let folder = empty_workspace();
    for chapter in Chapter::OF_THE_BOOK {
        let listings = listings_of(chapter).into_iter();
        for (file, code) in listings.filter(|(file, _)| !is_given(file)) {
            type_below(&folder.join(&file), &code);
            // It has several files: a reader may stop after each listing.
            if file.starts_with(folder_of(Chapter::HittableList).join("src")) {
                let words = ["check", "--package", "hittable_list", "--lib"];
                let complaint = format!("after\n{code}\nof {}", file.display());
                assert_built(&cargo_in(&folder, &words), &complaint);
            }
        }
        // "Every chapter has these lines", but for its name and its width.
        let main = |chapter| folder.join(folder_of(chapter)).join("src/main.rs");
        let first = fs::read_to_string(main(Chapter::BuildTest)).expect("it is listed");
        let width = chapter.book_width().to_string();
        let own = first.replace("build_test", chapter.name());
        write(&main(chapter), &own.replace("256", &width));
    }
    let tested = cargo_in(&folder, &["test", "--tests"]);
    assert_built(&tested, "what the pages list is wrong, or an answer is");
    for chapter in Chapter::OF_THE_BOOK {
        let program = folder.join("target/debug").join(chapter.name());
        let output = run(&mut Command::new(program));
        assert!(
            output.stdout == p3(&chapter.picture(chapter.book_width())),
            "typed from {}, the program draws something else",
            page_of(chapter)
        );
    }
}

/// Lists the listings of a page in its order: the file of each, and its text. The answers to
/// exercises are tests of their chapter. Chapter 5 is typed in two stairs: what comes out is below
/// them, file by file.
fn listings_of(chapter: Chapter) -> Vec<(PathBuf, String)> {
    let pages = whole::pages();
    let page = pages.iter().find(|page| page.name == page_of(chapter));
    let shown = match chapter {
        Chapter::HittableList => "details .listing",
        _ => ".listing",
    };
    let listings = page.expect("a chapter has a page").all(shown);
    let listing = |listing: ElementRef| {
        let part = |part: &str| {
            let part = listing.select(&whole::select(part)).next();
            text_of(part.expect("a listing has its file and its code"))
        };
        let file = PathBuf::from(part(".file"));
        let answer = file.strip_prefix("tests/suite/book/exercises");
        let tests = folder_of(chapter).join("tests");
        let file = answer.map_or(file.clone(), |name| tests.join(name));
        (file, part("code"))
    };
    listings.into_iter().map(listing).collect()
}

/// Types a listing below what is in its file already.
fn type_below(file: &Path, code: &str) {
    let is_a_test = file
        .parent()
        .is_some_and(|folder| folder.ends_with("tests"));
    let file = OpenOptions::new().append(true).create(is_a_test).open(file);
    let mut file = file.unwrap_or_else(|cause| panic!("{cause}: there is no file for\n{code}"));
    writeln!(file, "{code}").expect("the target folder takes it");
}

/// Returns true for a file that a reader does not type: the engine's, and cargo's.
fn is_given(file: &Path) -> bool {
    file.starts_with("common/src/engine") || file.ends_with("Cargo.toml")
}

/// A workspace like ours, but only with `common` and the chapters, and with nothing in what a
/// reader types.
fn empty_workspace() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("typed");
    let ours = Path::new(WORKSPACE);
    let read = |file: &Path| fs::read_to_string(ours.join(file)).expect("it is ours");
    let manifest = read(Path::new("Cargo.toml"));
    let lines = manifest.lines().filter(|line| !line.contains("members ="));
    let manifest = lines.collect::<Vec<_>>().join("\n");
    let only = "[workspace]\nmembers = [\"common\", \"chapters/*\"]";
    let manifest = manifest.replacen("[workspace]", only, 1);
    write(&folder.join("Cargo.toml"), &manifest);
    // The same versions, which are there already.
    write(&folder.join("Cargo.lock"), &read(Path::new("Cargo.lock")));
    for tests in Chapter::OF_THE_BOOK.map(|it| folder.join(folder_of(it)).join("tests")) {
        let _ = fs::remove_dir_all(&tests);
        fs::create_dir_all(tests).expect("a folder");
    }
    let packages = Chapter::OF_THE_BOOK.map(folder_of).into_iter();
    for package in packages.chain([PathBuf::from("common")]) {
        for file in files(&ours.join(package)) {
            let file = file.strip_prefix(ours).expect("it is ours");
            let text = if is_given(file) {
                read(file)
            } else {
                String::new()
            };
            write(&folder.join(file), &text);
        }
    }
    // An answer of chapter 4 compares its picture with that of chapter 1.
    let half_b = folder_of(Chapter::HalfBSphere).join("Cargo.toml");
    let more = "\n[dev-dependencies]\ngradient.workspace = true\n";
    write(&folder.join(&half_b), &(read(&half_b) + more));
    folder
}

fn cargo_in(folder: &Path, words: &[&str]) -> Output {
    let mut cargo = cargo();
    cargo.args(words).arg("--offline").current_dir(folder);
    cargo.env("CARGO_TARGET_DIR", folder.join("target"));
    cargo.env("CARGO_PROFILE_DEV_OPT_LEVEL", "0");
    run(&mut cargo)
}

fn assert_built(output: &Output, complaint: &str) {
    let (errors, said) = (text(&output.stderr), text(&output.stdout));
    assert!(output.status.success(), "{complaint}:\n{errors}{said}");
}

fn write(path: &Path, text: &str) {
    fs::create_dir_all(path.parent().expect("a file is in a folder")).expect("a folder");
    fs::write(path, text).expect("the target folder takes it");
}
