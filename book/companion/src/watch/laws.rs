//! The laws, which the reader's crate puts its own functions under.

use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::Duration;

use ::laws::answers::{ANSWERS, Answers};
use check::whole::Laws;
use slips::Chapter;

use crate::subprocess::{self, End};

/// What came of the test of a reader's crate.
pub(super) struct Asked {
    /// What the functions answered.
    pub(super) answers: Answers,
    /// Whether the laws hold.
    pub(super) outcome: Laws,
}

/// Runs the test of a reader's crate.
pub(super) fn ask(test: &OsStr, chapter: Chapter, folder: &Path, limit: Duration) -> Asked {
    let Ok(kept) = tempfile::tempdir() else {
        return Asked {
            answers: Answers::read(chapter, ""),
            outcome: Laws::Unknown("there is no room for a folder of answers".to_owned()),
        };
    };
    let file = kept.path().join("answers");
    let mut command = Command::new(test);
    command.arg("--nocapture").current_dir(folder);
    command.env(ANSWERS, &file);
    let answers = || Answers::read(chapter, &fs::read_to_string(&file).unwrap_or_default());
    let outcome = match subprocess::run(command, limit, &mut || false) {
        Ok((End::Itself(status, _), _)) if status.success() => Laws::Obeyed,
        Ok((End::Itself(..), errors)) => match Laws::reported(&errors) {
            Some(lines) if answers().has_wrong_prelude() => Laws::BrokenPrelude(lines),
            Some(lines) => Laws::Broken(lines),
            None => Laws::Unknown(errors),
        },
        Ok(_) => Laws::Unknown(format!("the laws were not done within {limit:?}")),
        Err(cause) => Laws::Unknown(cause.to_string()),
    };
    Asked {
        answers: answers(),
        outcome,
    }
}
