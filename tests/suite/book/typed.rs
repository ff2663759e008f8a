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
    assert_nothing_is_left_out(&typed);
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

/// Chapter 5 has several files: whoever types them may stop after each listing.
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

/// What nobody types: the engine, and what cargo is told.
fn given() -> BTreeMap<PathBuf, String> {
    let manifests = packages().map(|package| package.join("Cargo.toml"));
    let engine = sources_in(Path::new("common/src/engine"));
    let read = |file: PathBuf| {
        let text = fs::read_to_string(Path::new(WORKSPACE).join(&file)).expect("a source");
        (file, text)
    };
    let mut given: BTreeMap<PathBuf, String> = manifests.chain(engine).map(read).collect();
    // An answer of chapter 4 compares its picture with that of chapter 1.
    let half_b = folder_of(Chapter::HalfBSphere).join("Cargo.toml");
    let half_b = given.get_mut(&half_b).expect("a manifest");
    *half_b += "\n[dev-dependencies]\ngradient.workspace = true\n";
    given
}

/// Each source of the chapters, and of what they share, is listed somewhere.
fn assert_nothing_is_left_out(typed: &BTreeMap<PathBuf, String>) {
    let given = given();
    for file in packages().flat_map(|package| sources_in(&package.join("src"))) {
        let is_there = typed.contains_key(&file) || given.contains_key(&file);
        assert!(is_there, "no page lists anything of {}", file.display());
    }
}

fn packages() -> impl Iterator<Item = PathBuf> {
    let chapters = Chapter::OF_THE_BOOK.map(folder_of);
    chapters.into_iter().chain([PathBuf::from("common")])
}

/// The files of a folder of the workspace, as seen from there.
fn sources_in(folder: &Path) -> Vec<PathBuf> {
    let workspace = Path::new(WORKSPACE);
    let from_there = |file: PathBuf| file.strip_prefix(workspace).map(Path::to_owned);
    let files = files(&workspace.join(folder)).into_iter().map(from_there);
    files.collect::<Result<_, _>>().expect("they are ours")
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
    let ours =
        |file: &str| fs::read_to_string(Path::new(WORKSPACE).join(file)).expect("it is ours");
    let manifest = ours("Cargo.toml");
    let lines = manifest.lines().filter(|line| !line.contains("members ="));
    let manifest = lines.collect::<Vec<_>>().join("\n");
    let only = "[workspace]\nmembers = [\"common\", \"chapters/*\"]";
    write(
        &folder.join("Cargo.toml"),
        &manifest.replacen("[workspace]", only, 1),
    );
    // The same versions, which are there already.
    write(&folder.join("Cargo.lock"), &ours("Cargo.lock"));
    for (file, text) in given().into_iter().chain(typed) {
        write(&folder.join(file), &text);
    }
    folder
}

fn write(path: &Path, text: &str) {
    fs::create_dir_all(path.parent().expect("a file is in a folder")).expect("a folder");
    fs::write(path, text).expect("the target folder takes it");
}
