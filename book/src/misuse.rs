//! Exit codes: what tells a wrong command line from a failure.

use std::error::Error;
use std::fmt;
use std::process::ExitCode;

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
