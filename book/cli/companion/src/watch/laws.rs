//! The laws, which the reader's crate puts its own functions under.

use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::Duration;

use ::laws::answers::{ANSWERS, Answers};
use check::whole::Laws;
use slips::Chapter;

use super::verdict::not_written_yet;
use crate::subprocess::{self, End};

/// What came of the test of a reader's crate.
pub(super) struct Asked {
    /// What the functions answered.
    pub(super) answers: Answers,
    /// Whether the laws hold.
    pub(super) outcome: Laws,
    /// What was tested, and obeys the laws.
    pub(super) obeyed: Vec<String>,
    /// Where a test came upon something that is not written yet.
    pub(super) unwritten: Vec<String>,
}

/// Runs the test of a reader's crate.
pub(super) fn ask(test: &OsStr, chapter: Chapter, folder: &Path, limit: Duration) -> Asked {
    let unknown = |why| Asked {
        answers: Answers::read(chapter, ""),
        outcome: Laws::Unknown(why),
        obeyed: Vec::new(),
        unwritten: Vec::new(),
    };
    let Ok(kept) = tempfile::tempdir() else {
        return unknown("there is no room for a folder of answers".to_owned());
    };
    let file = kept.path().join("answers");
    let mut command = Command::new(test);
    // One after the other, by name: all add to one file.
    command.args(["--nocapture", "--test-threads=1"]);
    command.current_dir(folder).env(ANSWERS, &file);
    let (status, printed, errors) =
        match subprocess::run(command, limit, subprocess::last, &mut || false) {
            Ok((End::Itself(status, printed), errors)) => (status, printed, errors),
            Ok(_) => return unknown(format!("the laws were not done within {limit:?}")),
            Err(cause) => return unknown(cause.to_string()),
        };
    let answers = Answers::read(chapter, &fs::read_to_string(&file).unwrap_or_default());
    let printed = String::from_utf8_lossy(&printed);
    let passed = |line: &str| {
        let name = line.strip_prefix("test ")?;
        let name = name.strip_suffix("_obeys_the_laws ... ok")?;
        Some(name.trim_start_matches("a_").to_owned())
    };
    Asked {
        obeyed: printed.lines().filter_map(passed).collect(),
        unwritten: not_written_yet(&errors).map(str::to_owned).collect(),
        outcome: match Laws::reported(&errors) {
            _ if status.success() => Laws::Obeyed,
            Some(lines) if answers.has_wrong_prelude() => Laws::BrokenPrelude(lines),
            Some(lines) => Laws::Broken(lines),
            None => Laws::Unknown(errors),
        },
        answers,
    }
}
