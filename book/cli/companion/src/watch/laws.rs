//! The laws, which the reader's crate puts its own functions under, in a process of its own.

use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::time::Duration;

use ::laws::answers::{ANSWERS_VARIABLE, AnswerFile, Answers, FunctionOutcome};
use ::laws::{Complaint, Outcome};
use check::attempt::LawsStatus;
use check::lawful;
use slips::{Chapter, Languages};

use crate::limited;
use crate::subprocess::{self, ProgramEnd};

/// The result of the test that puts the functions of a reader's crate under the laws.
pub(super) struct LawsResult {
    /// All answers that the functions gave.
    pub(super) answers: Answers,
    /// The most important complaint, or that all laws hold.
    pub(super) outcome: LawsStatus,
    /// The names of the functions that obey all laws.
    pub(super) obeyed: Vec<String>,
    /// The place of each `todo!()` that a test came upon, as `file:line:column`.
    pub(super) unwritten: Vec<String>,
}

/// Reads the file of answers that the test has written, and removes it.
fn answered(file: &Path) -> String {
    const MOST_BYTES: u64 = 1 << 26;
    let bytes = limited::read_bytes(file, MOST_BYTES).unwrap_or_default();
    let _ = fs::remove_file(file);
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Runs the program `test` of a reader's crate in `folder`, for at most `limit`. A test that can't
/// be run gives an unknown outcome.
pub(super) fn run_laws_test(
    test: &OsStr,
    chapter: Chapter,
    folder: &Path,
    limit: Duration,
) -> LawsResult {
    let unknown = |why| LawsResult {
        answers: Answers::default(),
        outcome: LawsStatus::Unknown(why),
        obeyed: Vec::new(),
        unwritten: Vec::new(),
    };
    // Among what cargo builds: what an interrupted run leaves there is written over by the next.
    let file = Path::new(test).with_extension("answers");
    let _ = fs::remove_file(&file);
    let mut command = subprocess::reader_command(&[test.to_owned()]);
    // One after the other: all add to one file.
    command.args(["--nocapture", "--test-threads=1"]);
    command.current_dir(folder).env(ANSWERS_VARIABLE, &file);
    let (status, errors) =
        match subprocess::run(command, limit, subprocess::last_errors, &mut || false) {
            Ok((ProgramEnd::Itself(status, _), errors)) => (status, errors),
            Ok(_) => return unknown(format!("the laws were not done within {limit:?}")),
            Err(cause) => return unknown(cause.to_string()),
        };
    let AnswerFile { answers, outcomes } = AnswerFile::read(&answered(&file));
    let (obeyed, complaints): (Vec<_>, Vec<_>) =
        outcomes.into_iter().partition(|it| it.outcome.is_ok());
    let unwritten = complaints.iter().filter_map(|it| match &it.outcome {
        Err(Complaint::NotWritten(place)) => Some(place.clone()),
        _ => None,
    });
    LawsResult {
        answers,
        obeyed: obeyed.into_iter().map(|it| it.function).collect(),
        unwritten: unwritten.collect(),
        outcome: match worst(complaints) {
            Some(it) => of_first(
                &it.function,
                lawful::explained(it.outcome, chapter, Languages::Rust),
            ),
            None if status.success() => LawsStatus::Obeyed,
            None => LawsStatus::Unknown(errors),
        },
    }
}

/// Returns the complaint to tell first: a broken law before a `todo!()`, and the prelude before the
/// rest.
fn worst(complaints: Vec<FunctionOutcome>) -> Option<FunctionOutcome> {
    complaints.into_iter().min_by_key(|it| {
        let is_broken = matches!(it.outcome, Err(Complaint::Broken(_)));
        (!is_broken, it.function != PRELUDE)
    })
}

/// The name of the prelude in the outcomes of a test.
const PRELUDE: &str = "prelude";

fn of_first(of: &str, outcome: Outcome) -> LawsStatus {
    match outcome {
        Ok(()) => LawsStatus::Obeyed,
        Err(Complaint::Broken(report)) if of == PRELUDE => LawsStatus::BrokenPrelude(report),
        Err(Complaint::Broken(report)) => LawsStatus::Broken(report),
        Err(Complaint::NotWritten(place)) if of == PRELUDE => LawsStatus::UnwrittenPrelude(place),
        Err(Complaint::NotWritten(place)) => LawsStatus::NotWritten(place),
    }
}
