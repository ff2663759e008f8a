//! Mutation testing of the lesson: a panic is put first into each function that a
//! page lists, and the picture of that page breaks.
//!
//! The sources are copied, each function gets a panic that a variable of the
//! environment sets off, and the programs of the copy are built once.

use std::collections::BTreeSet;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process::Command;

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use slips::Chapter;

use crate::book::{self, page_of, text_of};
use suite::command::{cargo, files};
use suite::drawn::p3;

/// What a page lists though its picture does without: the page, the function, and why.
const DRAWS_NOTHING: [(&str, &str, &str); 2] = [
    (
        "gradient.html",
        "at",
        "nothing is hit yet, so no ray is asked for a point",
    ),
    (
        "gradient.html",
        "sky",
        "chapter 1 writes it out as its own ray_color; the later chapters draw with it",
    ),
];

#[test]
#[ignore = "builds the chapters with a panic in each function"]
fn a_panic_in_a_function_that_a_page_lists_breaks_the_picture_of_that_page() {
    let listed: Vec<(Chapter, Vec<Function>)> = Chapter::OF_THE_BOOK
        .into_iter()
        .map(|chapter| (chapter, listed_on_page_of(chapter)))
        .collect();
    let programs = build_copy(listed.iter().flat_map(|(_, functions)| functions).collect());
    for (chapter, functions) in &listed {
        let right = p3(&chapter.picture(WIDTH));
        let drawn = |broken: &str| {
            let mut program = Command::new(programs.join(chapter.name()));
            program.args(["--width", &WIDTH.to_string(), "-"]);
            let output = program.env(BROKEN, broken).output();
            output.expect("a program of the copy starts").stdout
        };
        assert!(
            drawn("") == right,
            "the copy of {chapter:?} draws something else"
        );
        assert!(
            !functions.is_empty(),
            "the page of {chapter:?} lists nothing"
        );
        for function in functions {
            let is_right = drawn(&function.key()) == right;
            assert_eq!(
                is_right,
                function.draws_nothing(*chapter),
                "{} on {}: {}",
                function.name,
                page_of(*chapter),
                if is_right {
                    "with a panic in it the picture is still right, so the page shows what does not run"
                } else {
                    "it is said to draw nothing there, and it does"
                }
            );
        }
    }
}

/// Wide enough for a ray to hit what there is, and small enough for a variable to be
/// read at every step.
const WIDTH: u32 = 16;

/// The variable that names the function to break.
const BROKEN: &str = "BROKEN_FUNCTION";

/// A function of the sources.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Function {
    /// Its file, as seen from the workspace.
    file: String,
    /// Its name, which no other function of the file has.
    name: String,
}

impl Function {
    fn key(&self) -> String {
        format!("{} {}", self.file, self.name)
    }

    fn draws_nothing(&self, chapter: Chapter) -> bool {
        DRAWS_NOTHING
            .iter()
            .any(|&(page, name, _)| page == page_of(chapter) && name == self.name)
    }

    /// Puts the panic first into its body, in the `text` of its file.
    fn break_in(&self, text: &mut String) {
        // What runs when it is compiled can't ask for a variable.
        let name = format!("fn {}(", self.name);
        *text = text.replace(&format!("const {name}"), &name);
        let mut bodies = Vec::new();
        find_bodies(parsed(text), &mut bodies);
        bodies.retain(|(name, _)| *name == self.name);
        let [(_, body)] = &bodies[..] else {
            panic!("{} is there {} times", self.key(), bodies.len());
        };
        let guard = format!(
            "if std::env::var_os({BROKEN:?}).is_some_and(|name| name == {:?}) {{ panic!() }}",
            self.key()
        );
        text.insert_str(body.start + 1, &guard);
    }
}

/// The functions of the chapter and of `common` that the chapter's page lists.
fn listed_on_page_of(chapter: Chapter) -> Vec<Function> {
    let pages = book::pages();
    let page = pages
        .iter()
        .find(|page| page.name == page_of(chapter))
        .expect("each chapter has a page");
    let listings = page.all(".listing").into_iter();
    let functions: BTreeSet<Function> = listings
        .flat_map(|listing| {
            let [file, code] = [".file", "code"].map(|part| {
                let part = listing.select(&book::select(part)).next();
                text_of(part.expect("a listing has its file and its code"))
            });
            functions_of(&file, &code)
        })
        .filter(|function| {
            ["common/", "chapters/"]
                .iter()
                .any(|at| function.file.starts_with(at))
        })
        .collect();
    functions.into_iter().collect()
}

/// The functions in `code` that have a body.
fn functions_of(file: &str, code: &str) -> Vec<Function> {
    let mut bodies = Vec::new();
    find_bodies(parsed(code), &mut bodies);
    let function = |(name, _)| Function {
        file: file.to_owned(),
        name,
    };
    bodies.into_iter().map(function).collect()
}

/// As tokens, because a reader may break lines wherever they like.
fn parsed(code: &str) -> TokenStream {
    code.parse().expect("a source consists of tokens")
}

/// Finds the name and the body of each function: the first braces after `fn`, unless a
/// semicolon comes before.
fn find_bodies(code: TokenStream, bodies: &mut Vec<(String, Range<usize>)>) {
    let mut name = None;
    let mut is_named = false;
    for token in code {
        match token {
            TokenTree::Ident(word) if is_named => name = Some(word.to_string()),
            TokenTree::Punct(mark) if mark.as_char() == ';' => name = None,
            TokenTree::Group(group) => {
                if group.delimiter() == Delimiter::Brace
                    && let Some(name) = name.take()
                {
                    bodies.push((name, group.span().byte_range()));
                }
                find_bodies(group.stream(), bodies);
                is_named = false;
                continue;
            }
            TokenTree::Ident(word) if word == "fn" => {
                is_named = true;
                continue;
            }
            _ => {}
        }
        is_named = false;
    }
}

/// Builds the chapters from a copy of their sources in which these functions can be
/// broken, and returns the folder of the programs.
fn build_copy(functions: BTreeSet<&Function>) -> PathBuf {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let copy = Path::new(env!("CARGO_TARGET_TMPDIR")).join("lesson");
    for folder in ["common", "chapters"] {
        for file in files(&workspace.join(folder)) {
            let place = file.strip_prefix(&workspace).expect("it is inside");
            let mut text = fs::read_to_string(&file).expect("a source");
            for function in &functions {
                if place == Path::new(&function.file) {
                    function.break_in(&mut text);
                }
            }
            write_if_changed(&copy.join(place), &text);
        }
    }
    write_manifest(&copy);
    build(&copy)
}

/// Makes a workspace of the folder: ours, but only `common` and the chapters.
pub(crate) fn write_manifest(copy: &Path) {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let manifest = fs::read_to_string(workspace.join("Cargo.toml")).expect("a manifest");
    let members = |line: &&str| !line.contains("members =");
    let manifest: Vec<&str> = manifest.lines().filter(members).collect();
    let only = "[workspace]\nmembers = [\"common\", \"chapters/*\"]";
    write_if_changed(
        &copy.join("Cargo.toml"),
        &manifest.join("\n").replacen("[workspace]", only, 1),
    );
    // The same versions, which are there already.
    let lock = fs::read_to_string(workspace.join("Cargo.lock")).expect("a lock file");
    write_if_changed(&copy.join("Cargo.lock"), &lock);
}

/// Builds the programs in a folder of their own, and as quickly as can be.
fn build(copy: &Path) -> PathBuf {
    let mut command = cargo();
    command.args(["build", "--offline"]).current_dir(copy);
    command.env("CARGO_TARGET_DIR", copy.join("target"));
    command.env("CARGO_PROFILE_DEV_OPT_LEVEL", "0");
    for chapter in Chapter::OF_THE_BOOK {
        command.args(["--package", chapter.name()]);
    }
    let output = command.output().expect("cargo starts");
    assert!(
        output.status.success(),
        "the copy does not compile:\n{}",
        String::from_utf8_lossy(&output.stderr)
    );
    copy.join("target/debug")
}

/// Leaves a file as it is that says so already: cargo builds what is newer.
pub(crate) fn write_if_changed(path: &Path, text: &str) {
    if fs::read_to_string(path).is_ok_and(|there| there == text) {
        return;
    }
    fs::create_dir_all(path.parent().expect("a file is in a folder")).expect("a folder");
    fs::write(path, text).expect("the target folder takes it");
}
