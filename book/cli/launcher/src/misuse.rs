//! Complaints: what is said on standard error, and the exit code, which tells a wrong
//! command line from a failure.

use std::error::Error;
use std::fmt;
use std::io::{self, Write};
use std::process::{ExitCode, exit};

use clap::Parser;
use course::names;

/// Parses the command line. Ends the program with help, if that is asked for, or with a complaint
/// about a word that can't be understood.
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

/// Writes to standard error. Characters that the terminal would obey, from the name of a file
/// perhaps, are spelled out.
pub fn complain(about: &str) {
    for line in about.lines() {
        // If even this can't be written, no more can be done.
        let _ = writeln!(io::stderr(), "{}", names::escape_for_terminal(line));
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

/// Makes an error that says why a command line can't be followed.
pub fn misuse(what: &str) -> Box<dyn Error> {
    Misuse(what.to_owned()).into()
}

/// Returns the exit code of a program that has `done` its work, and complains of an error.
pub fn exit_code(done: Result<(), Box<dyn Error>>) -> ExitCode {
    exit_code_of(done.map(|()| ExitCode::SUCCESS))
}

/// Returns the exit code of work that has one of its own, and complains of an error: 2 is for a
/// misuse, and 1 for a failure on the way.
pub fn exit_code_of(done: Result<ExitCode, Box<dyn Error>>) -> ExitCode {
    done.unwrap_or_else(|error| {
        complain(&format!("rtrace: {error}"));
        ExitCode::from(if error.is::<Misuse>() { 2 } else { 1 })
    })
}
