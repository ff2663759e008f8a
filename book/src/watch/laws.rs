//! The laws, which the reader's crate puts its own functions under.

use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::Duration;

use ::laws::answers::{ANSWERS, Answers};

use crate::subprocess::{self, End};

/// What came of the test of a reader's crate.
pub(super) struct Asked {
    /// What the functions answered.
    pub(super) answers: Answers,
    /// Whether the laws hold.
    pub(super) outcome: Outcome,
}

/// Whether the laws hold.
pub(super) enum Outcome {
    /// All of them do.
    Obeyed,
    /// The first broken one: its report, line by line.
    Broken(Vec<String>),
    /// The same of the reader's own prelude, on which all else stands.
    BrokenPrelude(Vec<String>),
    /// The test did not come to an end, or says nothing of a law.
    Unknown(String),
}

/// Runs the test of a reader's crate.
pub(super) fn ask(test: &OsStr, folder: &Path, limit: Duration) -> Asked {
    let Ok(kept) = tempfile::tempdir() else {
        return Asked {
            answers: Answers::default(),
            outcome: Outcome::Unknown("there is no room for a folder of answers".to_owned()),
        };
    };
    let file = kept.path().join("answers");
    let mut command = Command::new(test);
    command.arg("--nocapture").current_dir(folder);
    command.env(ANSWERS, &file);
    let answers = || Answers::read(&fs::read_to_string(&file).unwrap_or_default());
    let outcome = match subprocess::run(command, limit, &mut |_| false) {
        Ok((End::Itself(status, _), _)) if status.success() => Outcome::Obeyed,
        Ok((End::Itself(..), errors)) => match report(&errors) {
            Some(lines) if answers().has_wrong_prelude() => Outcome::BrokenPrelude(lines),
            Some(lines) => Outcome::Broken(lines),
            None => Outcome::Unknown(errors),
        },
        Ok(_) => Outcome::Unknown(format!("the laws were not done within {limit:?}")),
        Err(cause) => Outcome::Unknown(cause.to_string()),
    };
    Asked {
        answers: answers(),
        outcome,
    }
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
