//! The reader's companion as `cargo install` leaves it: copied, and run in a folder that
//! has nothing to do with the workspace.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use common::rtweekend::Picture;
use slips::Chapter;
use tempfile::TempDir;

use suite::command::woven;
use suite::command::{assert_success, path_of, run, text};
use suite::drawn::p3;
use suite::slip;

#[test]
fn messages_use_the_name_that_it_was_called_by() {
    let home = Home::new();
    home.draw("mine.ppm", &wrong_picture());
    home.draw("right.ppm", &half_b_sphere::picture(100));
    for (arguments, words) in [
        (
            &["check", "half_b_sphere", "mine.ppm"][..],
            "rtrace check half_b_sphere --probe behind",
        ),
        (
            &["check", "half_b_sphere", "right.ppm"],
            "rtrace check half_b_sphere --probe behind",
        ),
        (
            &["check", "half_b_sphere", "right.ppm", "--probe", "behind"],
            "and then: rtrace check",
        ),
        (
            &["check", "gradient", "right.ppm", "--probe", "behind"],
            "`rtrace probes",
        ),
        (&["check", "--help"], "Usage: rtrace check"),
        (&["probes", "normals"], "  rtrace check normals --probe"),
        (&["slips", "normals"], "rtrace slips draw"),
        (
            &[
                "slips",
                "draw",
                "minus-h",
                "--chapter",
                "gradient",
                "-o",
                "a.png",
            ],
            "`rtrace slips",
        ),
    ] {
        let output = run(home.rtrace().args(arguments));
        let said = text(&output.stdout) + &text(&output.stderr);
        assert!(said.contains(words), "{words} is missing in\n{said}");
        assert!(!said.contains("cargo rtrace"), "{said}");
        // The same through cargo, which finds `cargo-rtrace` on the path.
        let output = run(home.cargo_rtrace().args(arguments));
        let said_by_cargo = text(&output.stdout) + &text(&output.stderr);
        let names_cargo = words.replace("rtrace ", "cargo rtrace ");
        assert!(said_by_cargo.contains(&names_cargo), "{said_by_cargo}");
    }
}

#[test]
fn what_needs_no_workspace_works_in_any_folder() {
    let home = Home::new();
    for arguments in [
        &["show", "normals", "--width", "20", "-o", "mine.ppm"][..],
        &["check", "normals", "mine.ppm"],
        &["slips"],
        &["probes"],
        &[
            "hit",
            "--origin",
            "0,0,0",
            "--direction",
            "0,0,-1",
            "--center",
            "0,0,-1",
            "--radius",
            "0.5",
        ],
    ] {
        assert_success(&run(home.rtrace().args(arguments)));
        assert_success(&run(home.cargo_rtrace().args(arguments)));
    }
}

#[test]
fn what_there_is_to_read_is_a_path_that_exists() {
    woven();
    let home = Home::new();
    home.draw("mine.ppm", &wrong_picture());
    let output = run(home.rtrace().args(["check", "half_b_sphere", "mine.ppm"]));
    let said = text(&output.stdout);
    let places = |label| {
        said.lines()
            .filter_map(move |line| line.trim().strip_prefix(label))
    };
    for place in places("read ").chain(places("code ")) {
        let file = place.trim().split('#').next().expect("a path");
        assert!(home.folder().join(file).is_file(), "{place} in\n{said}");
    }
    assert_eq!(places("read ").count(), places("code ").count());
}

#[test]
fn a_page_that_is_out_of_reach_is_named_in_words() {
    let gone = TempDir::new().expect("a folder");
    for slip in slips::all() {
        assert_eq!(slip.page_in(gone.path()), None);
        assert_eq!(slip.source_in(gone.path()), None);
    }
    assert_eq!(
        slip("minus-h").page_in_words(),
        "\"the sign that got lost\", on the page half_b_sphere of the book"
    );
}

#[test]
fn cargo_rtrace_without_its_companion_says_so() {
    let home = Home::new();
    fs::remove_file(home.program("rtrace")).expect("it is there");
    let output = run(&mut home.command(&home.program("cargo-rtrace")));
    assert_eq!(output.status.code(), Some(1));
    let said = text(&output.stderr);
    assert!(
        said.contains("the rtrace beside it does not start"),
        "{said}"
    );
}

/// What someone draws in chapter 4 who has one minus too many.
fn wrong_picture() -> Picture {
    let program = slip("minus-h").program(Chapter::HalfBSphere);
    program.run(100).picture()
}

/// A folder outside of the workspace, with copies of both programs.
struct Home(TempDir);

impl Home {
    fn new() -> Self {
        let home = Self(TempDir::new().expect("a folder"));
        for name in ["rtrace", "cargo-rtrace"] {
            fs::copy(path_of(name), home.program(name)).expect("a copy");
        }
        home
    }

    fn folder(&self) -> &Path {
        self.0.path()
    }

    fn program(&self, name: &str) -> PathBuf {
        self.folder()
            .join(name)
            .with_extension(env::consts::EXE_EXTENSION)
    }

    fn draw(&self, name: &str, picture: &Picture) {
        fs::write(self.folder().join(name), p3(picture)).expect("a file");
    }

    fn rtrace(&self) -> Command {
        self.command(&self.program("rtrace"))
    }

    fn cargo_rtrace(&self) -> Command {
        let path = env::var_os("PATH").unwrap_or_default();
        let path = [self.folder().to_owned()]
            .into_iter()
            .chain(env::split_paths(&path));
        let mut command = self.command(Path::new(env!("CARGO")));
        command.arg("rtrace");
        command.env("PATH", env::join_paths(path).expect("a PATH"));
        command
    }

    /// As from a shell, not from the cargo that runs the tests.
    fn command(&self, program: &Path) -> Command {
        let mut command = Command::new(program);
        command.current_dir(self.folder()).env_remove("CARGO");
        command
    }
}
