//! Complaints: messages on standard error, and the exit code, which tells a wrong
//! command line from a failure.

use std::error::Error;
use std::fmt;
use std::io::{self, Write};
use std::process::ExitCode;

use course::names;

/// Prints `about`, one line or several, to standard error, with a line break at its end; prints
/// nothing if it is empty. Each character that a terminal would obey, perhaps from the name of a
/// file, becomes its escape, such as `\u{1b}`.
pub fn complain(about: &str) {
    for line in about.lines() {
        // If even this can't be written, no more can be done.
        let _ = writeln!(io::stderr(), "{}", names::escape_for_terminal(line));
    }
}

/// An error for a command line that is malformed or contradicts itself, with the message to print.
/// Any other error is a failure while the command runs.
#[derive(Debug)]
pub struct Misuse(pub String);

impl fmt::Display for Misuse {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl Error for Misuse {}

/// Makes a [`Misuse`] with this message, of one line or several, to be returned as an error.
pub fn misuse(what: &str) -> Box<dyn Error> {
    Misuse(what.to_owned()).into()
}

/// Returns the exit code that the work `done` ended with. For an error, prints it to standard error
/// and returns 2 for a [`Misuse`], and else 1.
pub fn exit_code(done: Result<ExitCode, Box<dyn Error>>) -> ExitCode {
    done.unwrap_or_else(|error| {
        complain(&format!("rtrace: {error}"));
        ExitCode::from(if error.is::<Misuse>() { 2 } else { 1 })
    })
}
