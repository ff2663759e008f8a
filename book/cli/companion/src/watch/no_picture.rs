//! Answers without a picture: the crate is not built, the program stopped, or nothing is typed yet.

use check::answer::{Answer, Row, RowKind};
use check::attempt::LawsStatus;
use check::reading::Cause;
use check::sentences::{self, printed_rows};
use slips::Chapter;

use super::build::BuildFailure;
use super::laws::LawsResult;

/// Makes the answer to a crate that can't be built: the compiler's first error, and advice.
pub(super) fn not_built(problem: &BuildFailure) -> Answer {
    let number = problem.first.split_once("[E").and_then(|it| it.1.get(..4));
    let more = number.map(|number| format!("; rustc --explain E{number} tells more"));
    let lines = problem
        .first
        .lines()
        .map(|line| Row::new(RowKind::Printed, line));
    let next = format!("{}{}", problem.advice, more.unwrap_or_default());
    sentences::not_compiled(problem.more + 1, lines.collect()).then(next)
}

/// Makes the answer to a program that printed no picture, with its last words on standard error.
pub(super) fn stopped(cause: &Cause, errors: &str) -> Answer {
    let next = if errors.contains("has overflowed its stack") {
        "a function calls itself without an end: look for one whose own name is in its body"
    } else if errors.contains("panicked at ") {
        "the panic names its place above: put that line right"
    } else {
        &cause.fix
    };
    let refused = sentences::refused("", "not a picture", cause);
    refused.with(printed_rows(errors)).then(next)
}

/// Makes the answer to a program that stopped at `place`, a `todo!()`. The laws judge what is
/// written already; the first file in the order of typing with a `todo!()` is the next to type.
pub(super) fn not_written(chapter: Chapter, place: &str, asked: Option<LawsResult>) -> Answer {
    let Some(asked) = asked else {
        return sentences::not_written(chapter, place, &[]);
    };
    let files = skeletons::files(chapter, false);
    let is_there = |place: &&str, name: &str| place.starts_with(&format!("{name}:"));
    let places = || asked.unwritten.iter().map(String::as_str).chain([place]);
    let mut first = files
        .iter()
        .filter_map(|file| places().find(|place| is_there(place, &file.name)));
    let place = first.next().unwrap_or(place);
    match &asked.outcome {
        LawsStatus::Broken(report) | LawsStatus::BrokenPrelude(report) => {
            sentences::broken_so_far(report, place)
        }
        _ => sentences::not_written(chapter, place, &asked.obeyed),
    }
}

/// Lists the places of panics of a `todo!()`, as `file:line:column`.
pub(super) fn unwritten_places(errors: &str) -> impl Iterator<Item = &str> {
    let panics = errors.split(":\nnot yet implemented");
    panics.filter_map(|before| Some(before.lines().next_back()?.split_once("panicked at ")?.1))
}
