//! `cargo rtrace`: has the chapters draw, shows, and hands every other command to the companion.

use std::env;
use std::error::Error;
use std::process::ExitCode;

use launcher::cargo::{become_program, companion};
use launcher::command_line::Request;
use launcher::misuse;

fn main() -> ExitCode {
    misuse::exit_code_of(run())
}

fn run() -> Result<ExitCode, Box<dyn Error>> {
    match launcher::run_own(Request::read(env::args_os().skip(1))?) {
        Ok(done) => done,
        // The companion knows what the words mean.
        Err(_) => {
            let mut companion = companion()?;
            companion.args(env::args_os().skip(1));
            become_program(companion)
        }
    }
}
