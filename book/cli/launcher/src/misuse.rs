//! Complaints: what is said on standard error, and the exit code, which tells a wrong
//! command line from a failure.

use std::error::Error;
use std::fmt;
use std::io::{self, Write};
use std::process::{ExitCode, exit};

use clap::Parser;
use course::names;

/// The command line, or the end of the program: with help, if that is asked for, or with what
/// can't be understood.
pub fn command_line<Cli: Parser>() -> Cli {
    Cli::try_parse().unwrap_or_else(|error| {
        if !error.use_stderr() {
            error.exit();
        }
        // It repeats what was typed.
        complain(&error.to_string());
        exit(error.exit_code())
    })
}

/// Says on standard error what went wrong. What the terminal would obey in it, from
/// the name of a file perhaps, is spelled out.
pub fn complain(about: &str) {
    for line in about.lines() {
        // If even this can't be written, no more can be done.
        let _ = writeln!(io::stderr(), "{}", names::visible(line));
    }
}

/// A command line that can't be followed, as opposed to a failure on the way.
#[derive(Debug)]
pub struct Misuse(pub String);

impl fmt::Display for Misuse {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl Error for Misuse {}

/// An error that says why a command line can't be followed.
pub fn misuse(what: &str) -> Box<dyn Error> {
    Misuse(what.to_owned()).into()
}

/// The exit code of a program that has done this, and on standard error why it is not 0.
pub fn exit_code(done: Result<(), Box<dyn Error>>) -> ExitCode {
    exit_code_of(done.map(|()| ExitCode::SUCCESS))
}

/// The same, where what was done has an exit code of its own: 2 is for a misuse, and 1 for
/// what failed on the way.
pub fn exit_code_of(done: Result<ExitCode, Box<dyn Error>>) -> ExitCode {
    done.unwrap_or_else(|error| {
        complain(&format!("rtrace: {error}"));
        ExitCode::from(if error.is::<Misuse>() { 2 } else { 1 })
    })
}
