//! The reader's companion as `cargo install` leaves it: copied, and run in a folder that
//! has nothing to do with the workspace.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use insta::assert_snapshot;
use slips::Chapter;
use suite::command::{assert_success, cargo, path_of, run, text, transcript};
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
        let said = |command: &mut Command| {
            let output = run(command.args(words));
            text(&output.stdout) + &text(&output.stderr)
        };
        let alone = said(&mut home.rtrace());
        assert!(
            alone.contains("rtrace ") && !alone.contains("cargo rtrace"),
            "{alone}"
        );
        // The same through cargo, which finds `cargo-rtrace` on the path.
        let _ = fs::remove_dir_all(home.0.path().join("mine"));
        let by_cargo = said(&mut home.cargo_rtrace());
        assert!(by_cargo.contains("cargo rtrace "), "{by_cargo}");
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

#[test]
fn cargo_rtrace_without_its_companion_says_so() {
    let home = Home::new();
    fs::remove_file(home.program("rtrace")).expect("it is there");
    assert_snapshot!(transcript(&mut [
        home.command(&home.program("cargo-rtrace"))
    ]));
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

    fn program(&self, name: &str) -> PathBuf {
        let program = self.0.path().join(name);
        program.with_extension(env::consts::EXE_EXTENSION)
    }

    fn write(&self, name: &str, bytes: &[u8]) {
        let path = self.0.path().join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, bytes).expect("a file");
    }

    fn rtrace(&self) -> Command {
        self.command(&self.program("rtrace"))
    }

    fn cargo_rtrace(&self) -> Command {
        let path = env::var_os("PATH").unwrap_or_default();
        let folders = [self.0.path().to_owned()].into_iter();
        let path = env::join_paths(folders.chain(env::split_paths(&path)));
        let mut command = self.command(Path::new(cargo().get_program()));
        command.arg("rtrace").env("PATH", path.expect("a PATH"));
        command
    }

    /// As from a shell, not from the cargo that runs the tests.
    fn command(&self, program: &Path) -> Command {
        let mut command = Command::new(program);
        command.current_dir(self.0.path());
        for name in ["CARGO", "CARGO_MANIFEST_DIR"] {
            command.env_remove(name);
        }
        command
    }
}
