//! The reader's companion as `cargo install` leaves it: copied, and run in a folder that
//! has nothing to do with the workspace.

use std::path::PathBuf;
use std::process::Command;
use std::{env, fs};

use fixtures::command::{assert_success, path_of, run, text};
use fixtures::desk::Desk;
use slips::{Chapter, ChapterCode};

#[test]
fn messages_use_the_name_that_it_was_called_by() {
    let desk = with_a_copy();
    desk.write_slip("mine.ppm", "minus-h", Chapter::HalfBSphere);
    desk.write_picture("right.ppm", &Chapter::HalfBSphere.picture(100));
    for line in [
        "check half_b_sphere mine.ppm",
        "check half_b_sphere right.ppm",
        "check half_b_sphere right.ppm --probe behind",
        "check --help",
        "watch normals",
        "start gradient",
    ] {
        let output = run(rtrace(&desk).args(line.split(' ')));
        let said = text(&output.stdout) + &text(&output.stderr);
        assert!(
            said.contains("rtrace ") && !said.contains("cargo rtrace"),
            "{said}"
        );
    }
}

#[test]
fn the_workspace_is_the_one_that_the_reader_is_in() {
    let desk = with_a_copy();
    desk.write("clone/common/Cargo.toml", "");
    desk.write("clone/tests/laws/Cargo.toml", "");
    desk.write("clone/book/notes/page.md", "");
    let mut start = rtrace(&desk);
    start.args(["start", "gradient"]);
    assert_success(&run(start.current_dir(desk.path("clone/book"))));
    let manifest = desk.read("clone/mine/gradient/Cargo.toml");
    assert!(
        manifest.contains("common = { path = \"../../common\""),
        "{manifest}"
    );
}

/// A folder outside of the workspace, with a copy of the program.
fn with_a_copy() -> Desk {
    let desk = Desk::default();
    fs::copy(path_of("rtrace"), copy_in(&desk)).expect("a copy");
    desk
}

fn copy_in(desk: &Desk) -> PathBuf {
    desk.path("rtrace")
        .with_extension(env::consts::EXE_EXTENSION)
}

/// As from a shell, not from the cargo that runs the tests.
fn rtrace(desk: &Desk) -> Command {
    let mut command = Command::new(copy_in(desk));
    command.current_dir(desk.path(""));
    for name in ["CARGO", "CARGO_MANIFEST_DIR"] {
        command.env_remove(name);
    }
    command
}
