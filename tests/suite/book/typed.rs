//! What the pages list can be typed: each listing into the file that it names, in the
//! order of the pages, and the pictures come out.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use scraper::ElementRef;
use slips::Chapter;

use crate::book::{self, folder_of, page_of, text_of};
use crate::lesson::{write_if_changed, write_manifest};
use suite::command::files;
use suite::command::{assert_success, cargo, run, text};
use suite::drawn::p3;
use suite::mine::Mine;

#[test]
#[ignore = "builds what the pages list"]
fn what_the_pages_list_is_all_that_must_be_typed_to_get_their_pictures() {
    let typed = listed();
    assert_nothing_is_left_out(&typed);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("typed");
    write_manifest(&folder);
    for (file, text) in given().into_iter().chain(typed) {
        write_if_changed(&folder.join(file), &text);
    }
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
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("listing_by_listing");
    let chapter = folder_of(Chapter::HittableList);
    let own = |(file, _): &(PathBuf, String)| file.starts_with(chapter.join("src"));
    let (listings, others): (Vec<_>, Vec<_>) = listed().into_iter().partition(own);
    write_manifest(&folder);
    for (file, text) in given().into_iter().chain(others) {
        write_if_changed(&folder.join(file), &text);
    }
    let mut typed: BTreeMap<_, _> = listings
        .into_iter()
        .map(|(file, _)| (file, String::new()))
        .collect();
    for (file, code) in listings_of(Chapter::HittableList).into_iter().filter(own) {
        add(&mut typed, file.clone(), &code);
        for (file, text) in &typed {
            write_if_changed(&folder.join(file), text);
        }
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

/// So that a listing can be typed into the crate that was made for it.
#[test]
#[ignore = "builds what the pages list"]
fn the_crates_that_start_makes_have_the_files_and_the_names_of_the_pages() {
    let mine = Mine::empty();
    let typed = listed();
    for chapter in &Chapter::OF_THE_BOOK[1..] {
        assert_success(&run(&mut mine.start(chapter.name(), &[])));
        let folder = mine.path().join(chapter.name());
        let made = files(&folder.join("src"));
        let page = folder_of(*chapter);
        let of_page = typed
            .keys()
            .filter(|file| file.starts_with(page.join("src")));
        assert_eq!(made.len(), of_page.count(), "{made:?}");
        for file in made.iter().filter(|file| !file.ends_with("main.rs")) {
            let listed = &typed[&page.join(file.strip_prefix(&folder).expect("it is inside"))];
            let made = fs::read_to_string(file).expect("a source");
            for name in made.lines().filter_map(named) {
                assert!(
                    listed.contains(name),
                    "no page lists `{name}` of {}",
                    file.display()
                );
            }
        }
    }
}

/// What the line begins, if it begins something with a name: a chapter may be typed in other
/// words, but not by other names.
fn named(line: &str) -> Option<&str> {
    let line = line.trim_start();
    let line = line.strip_prefix("pub ").unwrap_or(line);
    let is_named = ["fn ", "struct ", "trait ", "impl "]
        .iter()
        .any(|it| line.starts_with(it));
    // The sky was typed in chapter 1.
    let name = line.split(['(', '{']).next().unwrap_or(line).trim_end();
    (is_named && name != "fn sky").then_some(name)
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
        let file = match file.starts_with("tests/suite/book/exercises/") {
            true => folder_of(chapter).join("tests/exercises.rs"),
            false => PathBuf::from(file),
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
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let chapters = Chapter::OF_THE_BOOK.map(folder_of);
    let packages = chapters.into_iter().chain([PathBuf::from("common")]);
    let manifests = packages.map(|package| package.join("Cargo.toml"));
    let engine = files(&workspace.join("common/src/engine")).into_iter();
    let engine = engine.map(|file| {
        file.strip_prefix(&workspace)
            .expect("it is ours")
            .to_owned()
    });
    let read = |file: PathBuf| {
        let text = fs::read_to_string(workspace.join(&file)).expect("a source");
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
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let given = given();
    for package in Chapter::OF_THE_BOOK
        .map(folder_of)
        .into_iter()
        .chain([PathBuf::from("common")])
    {
        for file in files(&workspace.join(package).join("src")) {
            let file = file.strip_prefix(&workspace).expect("it is ours");
            assert!(
                typed.contains_key(file) || given.contains_key(file),
                "no page lists anything of {}",
                file.display()
            );
        }
    }
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
