//! Advice: why a program can't be asked any more, and what its author can do.

use std::process::ExitStatus;

use check::any_language::NoAnswer;
use check::names;
use slips::Chapter;

use super::Arguments;
use super::dialogue::DialogueFailure;

/// How a program prints a line at once, in several languages.
const AT_ONCE: &str = "print(…, flush=True) in Python, std::endl in C++, the event 'line' of \
    node:readline in JavaScript, fflush() in awk, with -W interactive in mawk";

/// Returns the end of a sentence about the program that tells the failure, after so many answers,
/// and the advice to its author.
pub(super) fn explain(
    failure: &DialogueFailure,
    arguments: &Arguments,
    answers: usize,
) -> (String, String) {
    let (limit, wanted) = (arguments.timeout, wanted(arguments.chapter));
    let shown = |said: &str| format!("`{}`", names::escape_for_terminal(said));
    match failure {
        DialogueFailure::Tardy => (
            format!("did not answer within {limit:?}, but later"),
            "give the program more time, if it is slow to start: --timeout SECONDS".to_owned(),
        ),
        DialogueFailure::Late => (
            format!("did not answer within {limit:?}, but when its input ended"),
            format!("answer before the next line comes: {AT_ONCE}"),
        ),
        DialogueFailure::Silent => (
            format!("did not answer within {limit:?}"),
            format!("print {wanted}. Does every loop end? --timeout SECONDS gives more time"),
        ),
        DialogueFailure::Slow(limit) => (
            format!("gave only {answers} of some two thousand answers within {limit:?}"),
            "make it faster, or give it more time: --timeout SECONDS".to_owned(),
        ),
        DialogueFailure::Ended(status) => (
            ended(*status),
            "answer line by line, until the input ends".to_owned(),
        ),
        DialogueFailure::TooMuch(said) => (
            format!(
                "prints more than one line for one question: {}",
                shown(said)
            ),
            format!("print nothing but {wanted}; the rest can go to standard error"),
        ),
        DialogueFailure::NoAnswer(said, NoAnswer::DecimalComma) => (
            format!("answers {}", shown(said)),
            "print numbers with a decimal point: 0.5, not 0,5".to_owned(),
        ),
        DialogueFailure::NoAnswer(said, _) if said.is_empty() => (
            "answers with an empty line".to_owned(),
            format!("print {wanted}"),
        ),
        DialogueFailure::NoAnswer(said, _) => (
            format!("answers {}", shown(said)),
            format!("print nothing but {wanted}"),
        ),
    }
}

/// Tells the end of a program without an answer; of one that still runs, no status is known.
fn ended(status: Option<ExitStatus>) -> String {
    status.map_or("closed its output".to_owned(), |status| {
        format!("ended with {status}, without an answer")
    })
}

/// Describes an answer as the program should print it.
fn wanted(chapter: Chapter) -> &'static str {
    match chapter {
        Chapter::RedSphere => "hit or miss",
        Chapter::HittableList => "t, and perhaps the normal and front or back; or miss",
        _ => "t, as a number, or miss",
    }
}
