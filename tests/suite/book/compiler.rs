//! Golden messages: the compiler's errors that the pages show are its own.
//!
//! Each is a slip of the hand, made in the chapter in which it is likely.

use std::fs;
use std::process::Command;

use insta::assert_snapshot;
use slips::Chapter;

use suite::command::{assert_success, cargo, run, text};
use suite::drawn::shown_in;
use suite::left_out::left_out;
use suite::mine::Mine;

/// One wrong piece in a chapter.
struct Mistake {
    name: &'static str,
    chapter: Chapter,
    right: &'static str,
    wrong: &'static str,
}

const MISTAKES: [Mistake; 6] = [
    Mistake {
        name: "one_minus_a",
        chapter: Chapter::Gradient,
        right: "(1.0 - a)",
        wrong: "(1 - a)",
    },
    Mistake {
        name: "dot_as_in_cpp",
        chapter: Chapter::RedSphere,
        right: "ray.direction.dot(ray.direction)",
        wrong: "dot(ray.direction, ray.direction)",
    },
    Mistake {
        name: "last_semicolon",
        chapter: Chapter::RedSphere,
        right: "discriminant >= 0.0",
        wrong: "discriminant >= 0.0;",
    },
    Mistake {
        name: "t_of_an_option",
        chapter: Chapter::Normals,
        right: "    if let Some(t) = hit_sphere(center, 0.5, ray)\n        && t > 0.0\n    {",
        wrong: "    let t = hit_sphere(center, 0.5, ray);\n    if t > 0.0 {",
    },
    Mistake {
        name: "import_forgotten",
        chapter: Chapter::HittableList,
        right: "use crate::hittable::{HitRecord, Hittable};\n\n/// All points",
        wrong: "\n/// All points",
    },
    Mistake {
        name: "closure_without_move",
        chapter: Chapter::HittableList,
        right: "move |ray|",
        wrong: "|ray|",
    },
];

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
    let mine = Mine::empty();
    for mistake in &MISTAKES {
        mistake.make(&mine);
        let said = page_of(&first_error(&mine, mistake.chapter.name()));
        shown_in("compiler").bind(|| assert_snapshot!(mistake.name, said));
    }
}

impl Mistake {
    /// Types the chapter with the mistake in it.
    fn make(&self, mine: &Mine) {
        let folder = mine.path().join(self.chapter.name());
        if !folder.exists() {
            assert_success(&run(&mut mine.start(self.chapter.name(), &[])));
        }
        let files = self.chapter.files();
        let with_it = files.iter().filter(|(_, text)| text.contains(self.right));
        assert_eq!(with_it.count(), 1, "files with {}", self.right);
        for (name, text) in files {
            let typed = text.replacen(self.right, self.wrong, 1);
            fs::write(folder.join(name), typed).expect("it is saved");
        }
    }
}

/// What cargo prints of the first error in the crate of that chapter.
fn first_error(mine: &Mine, chapter: &str) -> String {
    let mut cargo = cargo();
    cargo.args(["check", "--offline", "--quiet"]);
    let output = run(cargo.current_dir(mine.path().join(chapter)));
    let said = text(&output.stderr);
    let error = said.split("\n\n").find(|it| it.starts_with("error"));
    error.map_or_else(|| panic!("{chapter} compiles:\n{said}"), str::to_owned)
}

/// The error as Markdown. A list of the types that would have done is left out: it is long,
/// and what is in it depends on the libraries.
fn page_of(error: &str) -> String {
    let others = "   = help: the following other types";
    let error = error.split(others).next().unwrap_or(error);
    format!("```text\n{}\n```\n", error.trim_end())
}
