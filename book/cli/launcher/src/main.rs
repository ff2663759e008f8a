//! `cargo rtrace`: has the chapters draw, shows, and hands on every other command.

use std::process::ExitCode;

fn main() -> ExitCode {
    launcher::main(launcher::cargo::hand_on)
}
