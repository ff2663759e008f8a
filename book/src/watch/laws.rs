//! The laws, which the reader's crate puts its own function under.

use std::ffi::{OsStr, OsString};
use std::path::Path;
use std::time::Duration;

use ::laws::trial::Trial;
use slips::Program;

use crate::subprocess::{self, End};

/// What the laws say of a reader's function.
pub(super) enum Answer {
    /// All of them hold.
    Obeyed,
    /// The first broken one: its report, line by line.
    Broken(Vec<String>),
    /// The test did not come to an end, or says nothing of a law.
    Unknown(String),
}

/// Runs the test of a reader's crate; `None` if it has none.
pub(super) fn ask(test: &OsStr, folder: &Path, limit: Duration) -> Option<Answer> {
    let words: [OsString; 2] = [test.into(), "--nocapture".into()];
    Some(
        match subprocess::run(&words, folder, limit, &mut || false) {
            Ok((End::Itself(status, _), _)) if status.success() => Answer::Obeyed,
            Ok((End::Itself(..), errors)) => match report(&errors) {
                Some(lines) => Answer::Broken(lines),
                None => Answer::Unknown(errors),
            },
            Ok(_) => Answer::Unknown(format!("the laws were not done within {limit:?}")),
            Err(cause) => Answer::Unknown(cause.to_string()),
        },
    )
}

/// Whether the laws that the test of a chapter asks would find a mistake in the program.
pub(super) fn find(program: &Program) -> bool {
    Trial::default().intersection(program).is_err()
}

/// From the law to the page that tells of it.
fn report(errors: &str) -> Option<Vec<String>> {
    let from_law = errors
        .lines()
        .skip_while(|line| !line.starts_with("the law:"));
    let lines: Vec<String> = from_law
        .take_while(|line| !line.is_empty())
        .map(str::to_owned)
        .collect();
    (!lines.is_empty()).then_some(lines)
}
