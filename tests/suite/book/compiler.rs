//! What the compiler says to those who type: the errors that the pages show are its own.
//!
//! Each is a slip of the hand, made in the chapter in which it is likely.

use std::path::Path;
use std::process::Command;
use std::{env, fs};

use insta::assert_snapshot;
use serde_json::Value;
use slips::Chapter;

use crate::book::{WORKSPACE, folder_of};
use suite::command::{assert_success, cargo, run, text};
use suite::drawn::shown_in;
use suite::left_out::left_out;
use suite::mine::Mine;

/// Where the pages find them.
const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/notes/compiler");

/// One wrong piece in a file of a chapter.
struct Mistake {
    name: &'static str,
    chapter: Chapter,
    file: &'static str,
    right: &'static str,
    wrong: &'static str,
}

const MISTAKES: [Mistake; 6] = [
    Mistake {
        name: "one_minus_a",
        chapter: Chapter::Gradient,
        file: "lib.rs",
        right: "(1.0 - a)",
        wrong: "(1 - a)",
    },
    Mistake {
        name: "dot_as_in_cpp",
        chapter: Chapter::RedSphere,
        file: "lib.rs",
        right: "ray.direction.dot(ray.direction)",
        wrong: "dot(ray.direction, ray.direction)",
    },
    Mistake {
        name: "last_semicolon",
        chapter: Chapter::RedSphere,
        file: "lib.rs",
        right: "discriminant >= 0.0",
        wrong: "discriminant >= 0.0;",
    },
    Mistake {
        name: "t_of_an_option",
        chapter: Chapter::Normals,
        file: "lib.rs",
        right: "    if let Some(t) = hit_sphere(center, 0.5, ray)\n        && t > 0.0\n    {",
        wrong: "    let t = hit_sphere(center, 0.5, ray);\n    if t > 0.0 {",
    },
    Mistake {
        name: "import_forgotten",
        chapter: Chapter::HittableList,
        file: "sphere.rs",
        right: "use crate::hittable::{HitRecord, Hittable};\n",
        wrong: "",
    },
    Mistake {
        name: "closure_without_move",
        chapter: Chapter::HittableList,
        file: "lib.rs",
        right: "move |ray|",
        wrong: "|ray|",
    },
];

#[test]
#[ignore = "builds chapters with mistakes in them"]
fn the_pages_show_what_the_compiler_says() {
    let mine = Mine::empty();
    for mistake in &MISTAKES {
        let shown = Path::new(FOLDER).join(mistake.name).with_extension("snap");
        let shown = fs::read_to_string(shown).unwrap_or_default();
        let source = mistake.make(&mine);
        if !is_typed_as_shown(&source, &shown) && env::var_os("INSTA_UPDATE").is_none() {
            left_out(&format!(
                "{} is typed in other words than the page shows: the mistake {}",
                mistake.chapter.name(),
                mistake.name
            ));
            continue;
        }
        let said = page_of(&first_error(&mine, mistake.chapter.name()));
        if !is_the_version_shown() && !shown.is_empty() {
            assert_means_the_same(&shown, &said);
            continue;
        }
        shown_in("compiler").bind(|| assert_snapshot!(mistake.name, said));
    }
    if !is_the_version_shown() {
        left_out(&format!(
            "the words of the compiler's errors, which are those of Rust {}: only what they \
             are about was compared",
            env!("CARGO_PKG_RUST_VERSION")
        ));
    }
}

impl Mistake {
    /// Types the chapter with the mistake in it. Its file, as it is now.
    fn make(&self, mine: &Mine) -> String {
        let name = self.chapter.name();
        if !mine.path().join(name).exists() {
            assert_success(&run(&mut mine.start(name, &[])));
        }
        let ours = Path::new(WORKSPACE)
            .join(folder_of(self.chapter))
            .join("src");
        let typed = mine.path().join(name).join("src");
        for file in fs::read_dir(&ours).expect("the chapter") {
            let file = file.expect("a file").file_name();
            if file != "main.rs" {
                fs::copy(ours.join(&file), typed.join(&file)).expect("it is copied");
            }
        }
        let source = fs::read_to_string(typed.join(self.file)).expect("a source");
        let mistaken = source.replacen(self.right, self.wrong, 1);
        fs::write(typed.join(self.file), &mistaken).expect("it is saved");
        mistaken
    }
}

/// Whether the line that the error is about is the one that the page shows; a chapter may
/// be typed in other words.
fn is_typed_as_shown(source: &str, shown: &str) -> bool {
    let number = shown
        .split("--> ")
        .nth(1)
        .and_then(|place| place.split(':').nth(1));
    let Some(number) = number.and_then(|number| number.parse::<usize>().ok()) else {
        // Nothing is shown yet.
        return true;
    };
    let quoted = shown.lines().find_map(|line| {
        let (of, code) = line.split_once(" | ")?;
        (of.trim() == number.to_string()).then_some(code)
    });
    source.lines().nth(number - 1) == quoted
}

/// What cargo prints of the first error in the crate of that chapter.
fn first_error(mine: &Mine, chapter: &str) -> String {
    let mut cargo = cargo();
    cargo.args(["check", "--offline", "--quiet", "--message-format", "json"]);
    let output = run(cargo.current_dir(mine.path().join(chapter)));
    let said = text(&output.stdout);
    let messages = said.lines().filter_map(|line| {
        let message: Value = serde_json::from_str(line).ok()?;
        let message = &message["message"];
        (message["level"] == "error").then(|| message["rendered"].as_str().map(str::to_owned))?
    });
    let mut errors: Vec<String> = messages.collect();
    assert!(
        !errors.is_empty(),
        "{chapter} compiles, or:\n{}",
        text(&output.stderr)
    );
    errors.remove(0)
}

/// The error as Markdown. A list of the types that would have done is left out: it is long,
/// and what is in it depends on the libraries.
fn page_of(error: &str) -> String {
    let (error, _) = error
        .split_once("   = help: the following other types")
        .unwrap_or((error, ""));
    format!("```text\n{}\n```\n", error.trim_end())
}

/// Whether this is the compiler whose words the pages show.
fn is_the_version_shown() -> bool {
    let version = run(Command::new("rustc").arg("--version"));
    text(&version.stdout).starts_with(concat!("rustc ", env!("CARGO_PKG_RUST_VERSION"), "."))
}

/// Another version may say it in other words, but not of another place.
fn assert_means_the_same(shown: &str, said: &str) {
    let place = |text: &str| {
        let code = text.lines().find(|line| line.starts_with("error"));
        let place = text.lines().find(|line| line.contains("--> "));
        (
            code.and_then(|line| line.split(':').next())
                .map(str::to_owned),
            place.map(|line| line.trim().to_owned()),
        )
    };
    assert_eq!(
        place(shown),
        place(said),
        "the page shows\n{shown}\nand the compiler says\n{said}"
    );
}
