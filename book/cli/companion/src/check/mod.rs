//! `check`: judges a reader's own picture, and names the mistake.

mod input;

use std::error::Error;
use std::path::Path;
use std::time::Duration;

use check::attempt::Attempt;
use check::context::Context;
use check::names;
use check::reading::{self, Reading};
use check::task::Task;
use check::text::MOST_LINES;
use check::verdict::Verdict;
use check::{guess, judge, judge_guessed};
use slips::{Chapter, PROBES, Probe};

use input::PictureInput;

use crate::command_line::{Words, choose_one_of};
use crate::misuse::misuse;
use crate::reader_crates::chapter_here;
use crate::wrap::lay_out;

/// Judges a picture and returns the answer, after the exit code: 0 if the picture is right, 1 if it
/// is wrong, and 2 if the input is no picture.
///
/// # Errors
/// If a word is not what it should be, or contradicts another: each is a misuse, with exit code 2.
pub(crate) fn check(words: &Words) -> Result<(u8, String), Box<dyn Error>> {
    try_check(words).map_err(|error| misuse(&error.to_string()))
}

fn try_check(words: &Words) -> Result<(u8, String), Box<dyn Error>> {
    const PATIENCE: Duration = Duration::from_secs(60);
    let levels = |typed: &str| {
        let levels = typed.parse::<u8>();
        levels.map_err(|_| "choose a whole number of levels from 0 to 255".to_owned())
    };
    let (chapter, source) = chapter_and_source(words)?;
    let probe = words.option("--probe", probe)?;
    let tolerance = words.option("--tolerance", levels)?.unwrap_or(0);
    let limit = words.option("--timeout", seconds)?.unwrap_or(PATIENCE);
    let named = chapter
        .map(|chapter| find_task(chapter, probe))
        .transpose()?;
    let read = source.read(limit).and_then(|bytes| reading::read(&bytes));
    let is_guessed = named.is_none() && read.is_ok();
    let context = Context::default();
    let (task, verdict, flaw) = match (named, read) {
        (Some(task), Ok(reading)) => {
            let verdict = judge(&task, &reading, tolerance, &context);
            (task, verdict, reading.flaw)
        }
        (None, Ok(reading)) => {
            let guessed = guessed(&reading, probe)?;
            let (task, verdict) = judge_guessed(&guessed, &reading, tolerance, &context);
            (task, verdict, reading.flaw)
        }
        (named, Err(cause)) => {
            let task = named.map_or_else(|| find_task(Chapter::BuildTest, None), Ok)?;
            (task, Verdict::not_a_picture(cause), None)
        }
    };
    let code = verdict.exit_code();
    let attempt = Attempt {
        is_guessed,
        name: source.to_string(),
        flaw,
        ..Attempt::new(task, &context)
    };
    Ok((code, lay_out(&attempt.answer(verdict), MOST_LINES)))
}

/// Returns the chapter that is named, or whose crate the reader is in, and the place that the
/// picture is read from. A first word that names no chapter is a picture if it is an existing file,
/// has an extension, or is `-`.
fn chapter_and_source(
    words: &Words,
) -> Result<(Option<Chapter>, PictureInput<'_>), Box<dyn Error>> {
    let named = words.chapter();
    let is_picture = |path: &Path| path == "-" || path.extension().is_some() || path.is_file();
    let first = words.values.first().map(Path::new);
    let (chapter, pictures) = match (named, first) {
        (Err(_), Some(path)) if is_picture(path) => (None, &words.values[..]),
        (named, _) => (named?, words.values.get(1..).unwrap_or_default()),
    };
    let chapter = chapter.or_else(chapter_here);
    let refused = |what: &str| Err(words.command.misuse(what));
    match (pictures, words.program.is_empty()) {
        ([], true) => refused("name your picture, or your program after --"),
        ([], false) => Ok((chapter, PictureInput::Program(&words.program))),
        ([_], true) if words.has("--timeout") => refused("--timeout is for a program after --"),
        ([path], true) => Ok((chapter, PictureInput::of(Path::new(path)))),
        ([_], false) => refused("name a picture or a program, not both"),
        ([first, ..], _) => refused(&format!(
            "{} is not a chapter, and only one picture can be checked",
            names::escaped_name(first)
        )),
    }
}

/// Finds the task whose picture comes nearest, with the `probe` that is named.
fn guessed(reading: &Reading, probe: Option<Probe>) -> Result<Task, Box<dyn Error>> {
    let guessed = guess::guess_task(reading);
    let task = find_task(guessed.chapter, probe)?;
    Ok(match (probe, guessed.probe) {
        (None, probe) => Task::new(task.chapter, probe).unwrap_or(task),
        _ => task,
    })
}

/// Returns the task of a chapter, with a probe or without.
pub(crate) fn find_task(chapter: Chapter, probe: Option<Probe>) -> Result<Task, Box<dyn Error>> {
    Task::new(chapter, probe).ok_or_else(|| {
        let fitting = PROBES.iter().filter(|probe| probe.fits(chapter));
        let fitting: Vec<&str> = fitting.map(|probe| probe.name).collect();
        misuse(&format!(
            "this chapter has no place for the spheres of that probe; those it has: {}",
            fitting.join(", ")
        ))
    })
}

/// Parses a number of seconds above 0, such as `60` or `0.5`.
pub(crate) fn seconds(text: &str) -> Result<Duration, String> {
    let seconds = text.parse::<f64>().ok().filter(|&seconds| seconds > 0.0);
    seconds
        .and_then(|seconds| Duration::try_from_secs_f64(seconds).ok())
        .ok_or("choose a number of seconds, such as 60".to_owned())
}

/// Finds the probe of this name: a small scene that shows what a chapter's own picture hides.
pub(crate) fn probe(name: &str) -> Result<Probe, String> {
    let found = slips::find_probe(name);
    found.ok_or_else(|| choose_one_of(name, PROBES.iter().map(|probe| probe.name)))
}
