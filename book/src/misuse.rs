//! Complaints: what is said on standard error, and the exit code, which tells a wrong
//! command line from a failure.

use std::error::Error;
use std::io::{self, Write};
use std::process::{ExitCode, exit};
use std::{env, fmt};

use check::names;
use clap::Parser;
use serde_json::json;

/// What the command line says. Who asks for help is helped, and who can't be
/// understood is told why; that ends the program.
pub(crate) fn command_line<Cli: Parser>() -> Cli {
    Cli::try_parse().unwrap_or_else(|error| {
        if !error.use_stderr() {
            error.exit();
        }
        // It repeats what was typed.
        fail(&error.to_string());
        exit(error.exit_code())
    })
}

/// Says why there is no answer; to programs that have asked for JSON, in JSON as well.
pub(crate) fn fail(why: &str) {
    complain(why);
    let mut words = env::args_os().take_while(|word| word != "--");
    if words.any(|word| word == "--json") {
        // It was told already, if this can't be written.
        let _ = writeln!(io::stdout(), "{:#}", json!({ "error": why }));
    }
}

/// Says on standard error what went wrong. What the terminal would obey in it, from
/// the name of a file perhaps, is spelled out.
pub(crate) fn complain(about: &str) {
    for line in about.lines() {
        // If even this can't be written, there is nobody left to tell.
        let _ = writeln!(io::stderr(), "{}", names::visible(line));
    }
}

/// A command line that can't be followed, as opposed to a failure on the way.
#[derive(Debug)]
pub(crate) struct Misuse(pub(crate) String);

impl fmt::Display for Misuse {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl Error for Misuse {}

/// An error that says why a command line can't be followed.
pub(crate) fn misuse(what: &str) -> Box<dyn Error> {
    Misuse(what.to_owned()).into()
}

/// 2 for a misuse, and 1 for what failed on the way.
pub(crate) fn exit_code(error: &(dyn Error + 'static)) -> ExitCode {
    match error.downcast_ref::<Misuse>() {
        Some(_) => ExitCode::from(2),
        None => ExitCode::FAILURE,
    }
}
