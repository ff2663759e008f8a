//! What to say after a save, where there is no picture to judge.

use std::ffi::OsStr;
use std::io;
use std::process::ExitStatus;
use std::time::Duration;

use check::whole::{Laws, Line, Verdict, law, printed};
use slips::Chapter;

use super::build::Problem;
use super::laws::Asked;

pub(super) fn not_built(problem: &Problem) -> Verdict {
    let printed = problem.first.lines();
    let printed = printed.map(|line| Line::Printed(line.to_owned())).collect();
    let number = problem.first.split_once("[E").and_then(|it| it.1.get(..4));
    let more = number.map(|number| format!("; rustc --explain E{number} tells more"));
    Verdict {
        next: format!("put this right{}", more.unwrap_or_default()),
        ..Verdict::not_compiled(problem.more + 1, printed)
    }
}

pub(super) fn not_started(program: &OsStr, cause: &io::Error) -> Verdict {
    let name = program.to_string_lossy();
    Verdict {
        headline: format!("{name} does not start: {cause}."),
        next: "is it built, and is its path right? In this folder it is ./NAME".to_owned(),
        ..Verdict::default()
    }
}

pub(super) fn too_slow(limit: Duration, errors: &str) -> Verdict {
    Verdict {
        headline: format!("It did not end within {limit:?}."),
        cause: printed(errors),
        next: "does a loop end? If it is only slow: a smaller picture, or --timeout SECONDS"
            .to_owned(),
        ..Verdict::default()
    }
}

/// It ended with another code than 0, and these were its last words.
pub(super) fn failed(status: &ExitStatus, errors: &str) -> Verdict {
    Verdict {
        headline: format!("It ended with {status}."),
        cause: printed(errors),
        next: "a program that draws a picture ends with 0".to_owned(),
        ..Verdict::default()
    }
}

/// The program stopped at `place`, where nothing has been written yet. The laws judge what is
/// written already, and the first file that waits is the next one.
pub(super) fn not_written(chapter: Chapter, place: &str, asked: Option<Asked>) -> Verdict {
    let Some(asked) = asked else {
        return Verdict::not_written(chapter, place);
    };
    let files = skeletons::plain(chapter);
    let is_there = |place: &&str, name: &str| place.starts_with(&format!("{name}:"));
    let places = || asked.unwritten.iter().map(String::as_str).chain([place]);
    let mut first = files
        .iter()
        .filter_map(|(name, _)| places().find(|place| is_there(place, name)));
    let place = first.next().unwrap_or(place);
    if let Laws::Broken(report) | Laws::BrokenPrelude(report) = &asked.outcome {
        return Verdict {
            headline: "A law is broken in what is written so far.".to_owned(),
            cause: law(report),
            next: format!("put this right, and then go on at {place}"),
            ..Verdict::default()
        };
    }
    let obeyed = asked.obeyed.join(", ");
    let so_far = || Line::Labeled("so far".to_owned(), format!("the laws hold for {obeyed}"));
    Verdict {
        cause: (!obeyed.is_empty()).then(so_far).into_iter().collect(),
        ..Verdict::not_written(chapter, place)
    }
}

/// Where panics say that nothing has been written yet.
pub(super) fn not_written_yet(errors: &str) -> impl Iterator<Item = &str> {
    let panics = errors.split(":\nnot yet implemented");
    panics.filter_map(|before| Some(before.lines().next_back()?.split_once("panicked at ")?.1))
}
