//! `cargo rtrace`: has the chapters draw, shows, and hands every other command to the companion.

use std::env;
use std::process::ExitCode;

use launcher::cargo::{become_program, companion};

fn main() -> ExitCode {
    launcher::main(|_| {
        let mut companion = companion()?;
        // The companion knows what the words mean.
        companion.args(env::args_os().skip(1));
        become_program(companion)
    })
}
