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
use slips::{Chapter, PROBES, Probe};

use input::PictureInput;

use crate::chapter::{chapter, choose_one_of};
use crate::command_line::Words;
use crate::misuse::complain;
use crate::output;
use crate::wrap::lay_out;

/// The arguments of `cargo rtrace check`.
pub(crate) struct Arguments {
    first: Option<ChapterOrPicture>,
    picture: Option<PathBuf>,
    /// The reader's program and its arguments; empty if there is none.
    program: Vec<OsString>,
    probe: Option<Probe>,
    /// How many levels a component may be off.
    tolerance: u8,
    /// How long the program may take.
    timeout: Duration,
}

/// The first word: a chapter of the book, or a picture whose chapter is to be guessed.
enum ChapterOrPicture {
    Chapter(Chapter),
    /// The path of a picture file, which may be missing, or `-` for standard input.
    Picture(PathBuf),
}

impl ChapterOrPicture {
    /// Reads the first word, if there is one. A picture is an existing file, a name with an
    /// extension, or `-`.
    fn read(words: &Words) -> Result<Option<Self>, Box<dyn Error>> {
        let chapter = chapter(words);
        match words.values.first().map(Path::new) {
            Some(path)
                if chapter.is_err()
                    && (path == "-" || path.extension().is_some() || path.is_file()) =>
            {
                Ok(Some(Self::Picture(path.to_owned())))
            }
            _ => Ok(chapter?.map(Self::Chapter)),
        }
    }
}

impl Arguments {
    /// Reads the arguments from a command line.
    ///
    /// # Errors
    /// If a word is not what it should be, or contradicts another.
    pub(crate) fn read(words: &Words) -> Result<Self, Box<dyn Error>> {
        let picture = words.values.get(1).map(PathBuf::from);
        let levels = |typed: &str| {
            let levels = typed.parse();
            levels.map_err(|_| "choose a whole number of levels from 0 to 255".to_owned())
        };
        let arguments = Self {
            first: ChapterOrPicture::read(words)?,
            picture,
            program: words.program.clone(),
            probe: words.option(PROBE, probe)?,
            tolerance: words.option("--tolerance <N>", levels)?.unwrap_or(0),
            timeout: words.option(TIMEOUT, seconds)?.unwrap_or(PATIENCE),
        };
        let has_program = !arguments.program.is_empty();
        let problem = match (&arguments.first, has_program) {
            (None, false) => "name a chapter, your picture, or your program after --",
            (_, true) if arguments.picture.is_some() => "name a picture or a program, not both",
            (_, false) if words.has(TIMEOUT) => "--timeout is for a program after --",
            _ => return Ok(arguments),
        };
        Err(words.command.misuse(problem))
    }
}

/// The spelling of options that `watch` has, too.
pub(crate) const PROBE: &str = "--probe <NAME>";
pub(crate) const TIMEOUT: &str = "--timeout <SECONDS>";

/// How long a program may take unless the reader says so.
const PATIENCE: Duration = Duration::from_secs(60);

/// Judges a picture and prints the answer. Returns 0 if the picture is right, 1 if it is wrong, and
/// 2 if the input is no picture or can't be judged.
pub(crate) fn check(words: &Words) -> ExitCode {
    match Arguments::read(words).and_then(|arguments| try_check(&arguments)) {
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
        let bytes = source.read(self.timeout);
        let read = bytes.and_then(|it| reading::read(&it));
        let (is_guessed, tolerance) = (task.is_none() && read.is_ok(), self.tolerance);
        let (task, verdict, flaw) = match (read, task) {
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
        Ok(Task::new(chapter, self.probe).ok_or_else(|| {
            format!(
                "this chapter has no place for the spheres of that probe; `{} probes CHAPTER` lists those it has",
                companion_command()
            )
        })?)
    }

    /// Finds the task whose picture comes nearest, with the probe that the arguments name.
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
pub(crate) fn seconds(text: &str) -> Result<Duration, String> {
    let seconds = text.parse::<f64>().ok().filter(|&seconds| seconds > 0.0);
    seconds
        .and_then(|seconds| Duration::try_from_secs_f64(seconds).ok())
        .ok_or("choose a number of seconds, such as 60".to_owned())
}

/// Finds the probe of this name: a small scene that shows what a chapter's own picture hides.
///
/// # Errors
/// If there is none; the message lists all names.
pub(crate) fn probe(name: &str) -> Result<Probe, String> {
    let found = slips::find_probe(name);
    found.ok_or_else(|| choose_one_of(name, PROBES.iter().map(|probe| probe.name)))
}
