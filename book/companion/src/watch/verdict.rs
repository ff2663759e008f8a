//! What to say after a save, where there is no picture to judge.

use std::ffi::OsStr;
use std::io;
use std::process::ExitStatus;
use std::time::Duration;

use check::scene::Scene;
use check::whole::{Line, Verdict, printed};

use super::build::Problem;

pub(super) fn not_built(problem: &Problem) -> Verdict {
    let printed = problem.first.lines();
    let printed = printed.map(|line| Line::Printed(line.to_owned())).collect();
    Verdict {
        next: "put this right; rustc --explain tells more of an error with a number".to_owned(),
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
pub(super) fn failed(scene: &Scene, status: &ExitStatus, errors: &str) -> Verdict {
    match not_written_yet(errors) {
        Some(place) => Verdict::not_written(scene.chapter, place),
        None => Verdict {
            headline: format!("It ended with {status}."),
            cause: printed(errors),
            next: "a program that draws a picture ends with 0".to_owned(),
            ..Verdict::default()
        },
    }
}

/// Where a panic says that nothing has been written yet.
fn not_written_yet(errors: &str) -> Option<&str> {
    let (before, _) = errors.split_once(":\nnot yet implemented")?;
    let (_, place) = before.lines().next_back()?.split_once("panicked at ")?;
    Some(place)
}
