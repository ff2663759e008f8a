//! A verdict: what to say after a save, with one cause and one thing to do next.

use std::ffi::OsStr;
use std::io;
use std::process::ExitStatus;
use std::time::Duration;

use check::names;
use check::scene::Scene;
use common::rtweekend::Picture;
use slips::{Chapter, steps};

use super::build::Problem;

/// What a save has come to.
#[derive(Default)]
pub(super) struct Verdict {
    /// Whether nothing is left to do here.
    pub(super) is_right: bool,
    /// Whether it is about something that was saved over meanwhile.
    pub(super) is_stale: bool,
    /// The reader's picture and the one that it should be, if there is one.
    pub(super) pictures: Option<(Picture, Picture)>,
    /// What it is, in a line.
    pub(super) headline: String,
    /// The first cause, or what is known of it.
    pub(super) cause: Vec<Line>,
    /// What to do now.
    pub(super) next: String,
    /// What came out right.
    pub(super) done: Vec<String>,
}

/// A line below the headline.
pub(super) enum Line {
    /// A label, and text that may be long.
    Labeled(String, String),
    /// As a compiler or a program has printed it.
    Printed(String),
}

impl Verdict {
    pub(super) fn stale() -> Self {
        Self {
            is_stale: true,
            ..Self::default()
        }
    }

    pub(super) fn not_built(problem: &Problem) -> Self {
        let more = match problem.more {
            0 => String::new(),
            more => format!(" This is the first of {}.", more + 1),
        };
        Self {
            headline: format!("It does not compile.{more}"),
            cause: problem
                .first
                .lines()
                .map(|line| Line::Printed(line.to_owned()))
                .collect(),
            next: "put this right; rustc --explain tells more of an error with a number".to_owned(),
            ..Self::default()
        }
    }

    pub(super) fn and_obeys_the_laws(mut self, chapter: Chapter) -> Self {
        self.headline += " The laws hold.";
        self.done.push(format!("{}: the laws hold", chapter.name()));
        self
    }

    pub(super) fn not_started(program: &OsStr, cause: &io::Error) -> Self {
        let name = program.to_string_lossy();
        Self {
            headline: format!("{name} does not start: {cause}."),
            next: "is it built, and is its path right? In this folder it is ./NAME".to_owned(),
            ..Self::default()
        }
    }

    pub(super) fn too_slow(limit: Duration, errors: &str) -> Self {
        Self {
            headline: format!("It did not end within {limit:?}."),
            cause: printed(errors),
            next: "does a loop end? If it is only slow: a smaller picture, or --timeout SECONDS"
                .to_owned(),
            ..Self::default()
        }
    }

    /// It ended with another code than 0, and these were its last words.
    pub(super) fn failed(scene: &Scene, status: &ExitStatus, errors: &str) -> Self {
        match not_written_yet(errors) {
            Some(place) => Self {
                headline: format!("Not written yet: todo!() at {place}."),
                next: first_step(scene.chapter),
                ..Self::default()
            },
            None => Self {
                headline: format!("It ended with {status}."),
                cause: printed(errors),
                next: "a program that draws a picture ends with 0".to_owned(),
                ..Self::default()
            },
        }
    }
}

pub(super) fn labeled(label: &str, text: String) -> Line {
    Line::Labeled(label.to_owned(), text)
}

pub(super) fn printed(text: &str) -> Vec<Line> {
    let visible = |line| Line::Printed(names::visible(line).into_owned());
    text.lines().map(visible).collect()
}

/// Where a panic says that nothing has been written yet.
fn not_written_yet(errors: &str) -> Option<&str> {
    let (before, _) = errors.split_once(":\nnot yet implemented")?;
    let (_, place) = before.lines().next_back()?.split_once("panicked at ")?;
    Some(place)
}

fn first_step(chapter: Chapter) -> String {
    let steps = steps::of(chapter);
    steps
        .first()
        .map_or(String::new(), |step| step_says(0, step))
}

pub(super) fn step_says(at: usize, step: &steps::Step) -> String {
    format!("step {}: {}", at + 1, step.says)
}
