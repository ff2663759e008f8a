//! What the pages list can be typed: each listing into the file that it names, in the
//! order of the pages, and the pictures come out.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use scraper::ElementRef;
use slips::Chapter;

use crate::book::{self, WORKSPACE, folder_of, page_of, text_of};
use suite::command::{cargo, files, run, text};
use suite::drawn::p3;

#[test]
#[ignore = "builds what the pages list"]
fn what_the_pages_list_is_all_that_must_be_typed_to_get_their_pictures() {
    let typed = listed();
    let folder = workspace_with("typed", typed);
    let programs = build(&folder);
    for chapter in Chapter::OF_THE_BOOK {
        let output = run(&mut Command::new(programs.join(chapter.name())));
        assert!(
            output.stdout == p3(&chapter.picture(chapter.book_width())),
            "typed from {}, the program draws something else",
            page_of(chapter)
        );
    }
}

/// Chapter 5 has several files: a reader may stop after each listing.
#[test]
#[ignore = "builds what the pages list"]
fn chapter_5_compiles_after_each_listing_of_its_page() {
    let chapter = folder_of(Chapter::HittableList);
    let own = |(file, _): &(PathBuf, String)| file.starts_with(chapter.join("src"));
    let mut typed = listed();
    for (file, text) in &mut typed {
        if file.starts_with(chapter.join("src")) {
            text.clear();
        }
    }
    let folder = workspace_with("listing_by_listing", typed.clone());
    for (file, code) in listings_of(Chapter::HittableList).into_iter().filter(own) {
        add(&mut typed, file.clone(), &code);
        write(&folder.join(&file), &typed[&file]);
        let mut cargo = cargo();
        cargo.args(["check", "--offline", "--package", "hittable_list", "--lib"]);
        let output = run(cargo.current_dir(&folder));
        let said = text(&output.stderr);
        assert!(
            output.status.success(),
            "after\n{code}\nof {}:\n{said}",
            file.display()
        );
    }
}

/// The listings of all chapters, put together by the files that they name. The answers to
/// exercises are a test of their chapter.
fn listed() -> BTreeMap<PathBuf, String> {
    let mut typed: BTreeMap<PathBuf, String> = BTreeMap::new();
    for chapter in Chapter::OF_THE_BOOK {
        for (file, code) in listings_of(chapter) {
            add(&mut typed, file, &code);
        }
    }
    for chapter in &Chapter::OF_THE_BOOK[1..] {
        // "Every chapter has these lines", but for its name and its width.
        let main = typed[&folder_of(Chapter::BuildTest).join("src/main.rs")]
            .replace("build_test", chapter.name())
            .replace("256", &chapter.book_width().to_string());
        typed.insert(folder_of(*chapter).join("src/main.rs"), main);
    }
    typed
}

/// What a page lists, in its order: the file of each listing, and its text.
fn listings_of(chapter: Chapter) -> Vec<(PathBuf, String)> {
    let pages = book::pages();
    let page = pages.iter().find(|page| page.name == page_of(chapter));
    let listings = page.expect("a chapter has a page").all(".listing");
    let listing = |listing: ElementRef| {
        let part = |part: &str| {
            let part = listing.select(&book::select(part)).next();
            text_of(part.expect("a listing has its file and its code"))
        };
        let file = part(".file");
        let file = if file.starts_with("tests/suite/book/exercises/") {
            folder_of(chapter).join("tests/exercises.rs")
        } else {
            PathBuf::from(file)
        };
        (file, part("code"))
    };
    listings.into_iter().map(listing).collect()
}

/// Types a listing below what is in its file already.
fn add(typed: &mut BTreeMap<PathBuf, String>, file: PathBuf, code: &str) {
    let text = typed.entry(file).or_default();
    if !text.is_empty() {
        text.push('\n');
    }
    *text += code;
}

/// Whether a reader types the file: all but the engine, and what cargo reads.
fn is_typed(file: &Path) -> bool {
    let is_in = |folder: &str| file.components().any(|it| it.as_os_str() == folder);
    is_in("src") && !is_in("engine")
}

/// The files of `common` and of the chapters, as seen from the workspace.
fn ours() -> impl Iterator<Item = (PathBuf, String)> {
    let workspace = Path::new(WORKSPACE);
    let packages = Chapter::OF_THE_BOOK.map(folder_of).into_iter();
    let packages = packages.chain([PathBuf::from("common")]);
    let files = packages.flat_map(|package| files(&workspace.join(package)));
    files.map(move |file| {
        let text = fs::read_to_string(&file).expect("it is text");
        let below = file.strip_prefix(workspace).expect("it is ours");
        (below.to_owned(), text)
    })
}

/// Builds the programs, and asks the answers to the exercises what they promise.
fn build(folder: &Path) -> PathBuf {
    let target = folder.join("target");
    let mut cargo = cargo();
    cargo.args(["test", "--offline", "--test", "exercises"]);
    cargo
        .env("CARGO_TARGET_DIR", &target)
        .env("CARGO_PROFILE_DEV_OPT_LEVEL", "0")
        .current_dir(folder);
    let output = run(&mut cargo);
    assert!(
        output.status.success(),
        "what the pages list does not compile, or an answer is wrong:\n{}{}",
        text(&output.stderr),
        text(&output.stdout)
    );
    target.join("debug")
}

/// A workspace like ours, but only with `common` and the chapters, and with these files in
/// place of their sources.
fn workspace_with(name: &str, typed: BTreeMap<PathBuf, String>) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let read = |file| fs::read_to_string(Path::new(WORKSPACE).join(file)).expect("it is ours");
    let manifest = read("Cargo.toml");
    let lines = manifest.lines().filter(|line| !line.contains("members ="));
    let manifest = lines.collect::<Vec<_>>().join("\n");
    let only = "[workspace]\nmembers = [\"common\", \"chapters/*\"]";
    write(
        &folder.join("Cargo.toml"),
        &manifest.replacen("[workspace]", only, 1),
    );
    // The same versions, which are there already.
    write(&folder.join("Cargo.lock"), &read("Cargo.lock"));
    let given = ours().filter(|(file, _)| !is_typed(file));
    for (file, text) in given.chain(typed) {
        write(&folder.join(file), &text);
    }
    // An answer of chapter 4 compares its picture with that of chapter 1.
    let half_b = folder
        .join(folder_of(Chapter::HalfBSphere))
        .join("Cargo.toml");
    let manifest = fs::read_to_string(&half_b).expect("a manifest");
    write(
        &half_b,
        &(manifest + "\n[dev-dependencies]\ngradient.workspace = true\n"),
    );
    folder
}

fn write(path: &Path, text: &str) {
    fs::create_dir_all(path.parent().expect("a file is in a folder")).expect("a folder");
    fs::write(path, text).expect("the target folder takes it");
}
