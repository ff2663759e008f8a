//! `check`: judges a reader's own picture, and names the mistake.

mod input;

use std::error::Error;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use check::attempt::Attempt;
use check::context::Context;
use check::names::{self, companion_command};
use check::reading::{self, Reading};
use check::task::Task;
use check::verdict::Verdict;
use check::{guess, judge, judge_guessed};
use clap::Args;
use clap::builder::TypedValueParser;
use common::engine::output;
use slips::{Chapter, Edition, PROBES, Probe};

use input::PictureInput;

use crate::chapter::{ChapterOrPicture, ChapterOrPictureParser, parser_of_names};
use crate::misuse::complain;
use crate::wrap::lay_out;

/// The arguments of `cargo rtrace check`.
#[derive(Args)]
pub(crate) struct Arguments {
    /// The chapter whose picture it should be; without one, the chapter that comes nearest
    #[arg(value_name = "CHAPTER", value_parser = ChapterOrPictureParser, required_unless_present = "program")]
    first: Option<ChapterOrPicture>,

    /// Your picture: a .ppm (P3 or P6) or .png file, or - for standard input
    #[arg(value_name = "PICTURE")]
    picture: Option<PathBuf>,

    /// Your own program, which prints the picture to standard output
    #[arg(last = true, value_name = "PROGRAM", conflicts_with = "picture")]
    program: Vec<OsString>,

    /// The picture shows the scene of this probe: `probes` lists them
    #[arg(long, value_name = "NAME", value_parser = probe_parser())]
    probe: Option<Probe>,

    /// The picture follows this version of the book; without this option, any version will do
    #[arg(long, value_name = "VERSION", value_parser = edition_parser())]
    edition: Option<Edition>,

    /// Accept components that are up to N levels off
    #[arg(long, value_name = "N", default_value_t = 0)]
    tolerance: u8,

    /// How long your program may take
    #[arg(long, value_name = "SECONDS", default_value = "60", value_parser = parse_seconds, allow_hyphen_values = true, requires = "program")]
    timeout: Duration,
}

/// Judges a picture and prints the answer. Returns 0 if the picture is right, 1 if it is wrong, and
/// 2 if the input is no picture or can't be judged.
pub(crate) fn check(arguments: &Arguments) -> ExitCode {
    match try_check(arguments) {
        Ok(code) => ExitCode::from(code),
        Err(error) => {
            complain(&format!("rtrace: {error}"));
            ExitCode::from(2)
        }
    }
}

fn try_check(arguments: &Arguments) -> Result<u8, Box<dyn Error>> {
    let (chapter, source) = arguments.chapter_and_source()?;
    let task = chapter.map(|chapter| arguments.task(chapter)).transpose()?;
    let context = Context::default();
    let (attempt, verdict) = arguments.judged(task, &source, &context)?;
    let code = verdict.exit_code();
    let answer = attempt.answer(verdict);
    let said = lay_out(&answer);
    output::to_stdout(|out| out.write_all(said.as_bytes()))?;
    Ok(code)
}

impl Arguments {
    /// Returns the chapter that the arguments name, if any, and the place that the picture is read
    /// from.
    fn chapter_and_source(&self) -> Result<(Option<Chapter>, PictureInput<'_>), Box<dyn Error>> {
        let program = PictureInput::Program(&self.program);
        match (&self.first, &self.picture) {
            (Some(ChapterOrPicture::Chapter(chapter)), Some(path)) => {
                Ok((Some(*chapter), PictureInput::of(path)))
            }
            (Some(ChapterOrPicture::Chapter(_)), None) if self.program.is_empty() => {
                Err("name your picture, or your program after --".into())
            }
            (Some(ChapterOrPicture::Chapter(chapter)), None) => Ok((Some(*chapter), program)),
            (Some(ChapterOrPicture::Picture(path)), None) if self.program.is_empty() => {
                Ok((None, PictureInput::of(path)))
            }
            (Some(ChapterOrPicture::Picture(path)), _) => Err(format!(
                "{} is not a chapter, and only one picture can be checked",
                names::escaped_name(path)
            )
            .into()),
            (None, _) => Ok((None, program)),
        }
    }

    /// Reads the picture and judges it: by the `task` if a chapter is named, and else by the task
    /// whose picture comes nearest.
    fn judged<'a>(
        &self,
        task: Option<Task>,
        source: &PictureInput,
        context: &'a Context<'a>,
    ) -> Result<(Attempt<'a>, Verdict), Box<dyn Error>> {
        let (is_guessed, tolerance) = (task.is_none(), self.tolerance);
        let bytes = source.read(self.timeout);
        let (task, verdict, flaw) = match (bytes.and_then(|it| reading::read(&it)), task) {
            (Ok(reading), Some(task)) => {
                let verdict = judge(&task, &reading, tolerance, context);
                (task, verdict, reading.flaw)
            }
            (Ok(reading), None) => {
                let guessed = self.guessed(&reading)?;
                let (task, verdict) = judge_guessed(&guessed, &reading, tolerance, context);
                (task, verdict, reading.flaw)
            }
            (Err(cause), task) => {
                let task = task.map_or_else(|| self.task(Chapter::BuildTest), Ok)?;
                let finding = None;
                (task, Verdict::NotAPicture { cause, finding }, None)
            }
        };
        let attempt = Attempt {
            is_guessed,
            name: source.to_string(),
            flaw,
            ..Attempt::new(task, context)
        };
        Ok((attempt, verdict))
    }

    fn task(&self, chapter: Chapter) -> Result<Task, Box<dyn Error>> {
        let task = Task::new(chapter, self.probe).ok_or_else(|| {
            format!(
                "this chapter has no place for the spheres of that probe; `{} probes CHAPTER` lists those it has",
                companion_command()
            )
        })?;
        Ok(match self.edition {
            Some(edition) => task.only_by_edition(edition),
            None => task,
        })
    }

    /// Finds the task whose picture comes nearest, with the probe and the edition that the
    /// arguments name.
    fn guessed(&self, reading: &Reading) -> Result<Task, Box<dyn Error>> {
        let guessed = guess::guess_task(reading);
        let task = self.task(guessed.chapter)?;
        Ok(match (self.probe, guessed.probe) {
            (None, Some(probe)) => task.with_probe(probe).unwrap_or(task),
            _ => task,
        })
    }
}

/// Parses a number of seconds above 0, such as `60` or `0.5`.
///
/// # Errors
/// If the text is no such number; the message names one.
pub(crate) fn parse_seconds(text: &str) -> Result<Duration, String> {
    let seconds = text.parse::<f64>().ok().filter(|&seconds| seconds > 0.0);
    seconds
        .and_then(|seconds| Duration::try_from_secs_f64(seconds).ok())
        .ok_or("choose a number of seconds, such as 60".to_owned())
}

fn edition_parser() -> impl TypedValueParser<Value = Edition> {
    parser_of_names(Edition::ALL.map(|edition| (edition.name(), edition)))
}

/// Makes a parser of an argument that names a probe: a small scene that shows what a chapter's own
/// picture hides.
pub(crate) fn probe_parser() -> impl TypedValueParser<Value = Probe> {
    parser_of_names(PROBES.map(|probe| (probe.name, probe)))
}
