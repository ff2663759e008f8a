//! The reader's companion as `cargo install` leaves it: copied, and run in a folder that
//! has nothing to do with the workspace.

use std::path::PathBuf;
use std::process::Command;
use std::{env, fs};

use slips::Chapter;
use suite::command::{assert_success, path_of, run, text};
use suite::drawn::p3;
use tempfile::TempDir;

#[test]
fn messages_use_the_name_that_it_was_called_by() {
    let home = Home::new();
    let wrong = suite::slip("minus-h").program(Chapter::HalfBSphere);
    home.write("mine.ppm", &p3(&wrong.run(100).picture()));
    home.write("right.ppm", &p3(&half_b_sphere::picture(100)));
    for words in [
        &["check", "half_b_sphere", "mine.ppm"][..],
        &["check", "half_b_sphere", "right.ppm"],
        &["check", "half_b_sphere", "right.ppm", "--probe", "behind"],
        &["check", "gradient", "right.ppm", "--probe", "behind"],
        &["check", "--help"],
        &["probes", "normals"],
        &["slips", "normals"],
        &["start", "gradient"],
        &["watch", "normals"],
    ] {
        let output = run(home.rtrace().args(words));
        let said = text(&output.stdout) + &text(&output.stderr);
        assert!(
            said.contains("rtrace ") && !said.contains("cargo rtrace"),
            "{said}"
        );
        let _ = fs::remove_dir_all(home.0.path().join("mine"));
    }
}

/// A clone that was moved, and programs that were built before.
#[test]
fn the_workspace_is_the_one_that_the_reader_is_in() {
    let home = Home::new();
    for part in [
        "common/Cargo.toml",
        "tests/laws/Cargo.toml",
        "book/notes/page.md",
    ] {
        home.write(&format!("clone/{part}"), b"");
    }
    let mut start = home.rtrace();
    start.args(["start", "gradient"]);
    assert_success(&run(start.current_dir(home.0.path().join("clone/book"))));
    fs::rename(home.0.path().join("clone"), home.0.path().join("moved")).expect("it is moved");
    let made = home.0.path().join("moved/mine/gradient");
    let manifest = fs::read_to_string(made.join("Cargo.toml")).expect("the crate moves with it");
    let (_, path) = manifest.split_once("common = { path = \"").expect("a path");
    let (path, _) = path.split_once('"').expect("its end");
    assert!(made.join(path).join("Cargo.toml").is_file(), "{path}");
    let mut watch = home.rtrace();
    watch.args(["watch", "gradient", "--once"]);
    run(watch.current_dir(&made));
    let settings = fs::read_to_string(made.join(".cargo/config.toml")).expect("the settings");
    assert!(settings.contains("/moved/Cargo.toml"), "{settings}");
}

/// A folder outside of the workspace, with a copy of the program.
struct Home(TempDir);

impl Home {
    fn new() -> Self {
        let home = Self(TempDir::new().expect("a folder"));
        fs::copy(path_of("rtrace"), home.program()).expect("a copy");
        home
    }

    fn program(&self) -> PathBuf {
        let program = self.0.path().join("rtrace");
        program.with_extension(env::consts::EXE_EXTENSION)
    }

    fn write(&self, name: &str, bytes: &[u8]) {
        let path = self.0.path().join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, bytes).expect("a file");
    }

    /// As from a shell, not from the cargo that runs the tests.
    fn rtrace(&self) -> Command {
        let mut command = Command::new(self.program());
        command.current_dir(self.0.path());
        for name in ["CARGO", "CARGO_MANIFEST_DIR"] {
            command.env_remove(name);
        }
        command
    }
}
