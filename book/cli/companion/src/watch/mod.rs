//! `watch`: a loop from each save to a verdict, one screen long.

mod background;
pub(crate) mod build;
mod changes;
mod laws;
mod no_picture;
mod screen;

use std::cell::Cell;
use std::env;
use std::error::Error;
use std::ffi::OsString;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use check::answer::{Answer, Grade, Row, RowKind};
use check::attempt::{Attempt, Commands, LawsStatus};
use check::context::Context;
use check::judge_file;
use check::lawful;
use check::names::{self, companion_command, name_from_here};
use check::reading::read;
use check::sentences::step_done_line;
use check::sources::Sources;
use check::task::Task;
use common::rtweekend::Picture;
use slips::{Chapter, ChapterCode, ChapterProgram, Languages, Probe, Slip, steps};

use crate::check::{find_task, probe, seconds};
use crate::command_line::Words;
use crate::done::Done;
use crate::misuse::misuse;
use crate::output;
use crate::reader_crates::{ReaderCrates, chapter_here, shell_word};
use crate::repair::{self, RightPictures, Search, WrongCrate};
use crate::sources;
use crate::subprocess::{self, ProgramEnd};
use background::BackgroundBuild;
use build::{BuiltCrate, NoVerdict};
use changes::{FolderChanges, Waited};
use laws::LawsResult;

/// The arguments of `cargo rtrace watch`.
struct Arguments {
    chapter: Chapter,
    /// The reader's program and its arguments; empty for the crate that `start` made.
    program: Vec<OsString>,
    /// Where the reader's crates are; `None` for the usual folder.
    in_folder: Option<PathBuf>,
    probe: Option<Probe>,
    /// How long the program may take.
    timeout: Duration,
    once: bool,
}

impl Arguments {
    /// Reads the arguments from a command line.
    ///
    /// # Errors
    /// If a word is missing, is not what it should be, or contradicts
    /// another.
    fn read(words: &Words) -> Result<Self, Box<dyn Error>> {
        let timeout = words.option("--timeout", seconds)?;
        let here = words.values.is_empty().then(chapter_here).flatten();
        let arguments = Self {
            chapter: here.map_or_else(|| words.required_chapter(), Ok)?,
            program: words.program.clone(),
            in_folder: words.path("--in"),
            probe: words.option("--probe", probe)?,
            timeout: timeout.unwrap_or(Duration::from_secs(10)),
            once: words.has("--once"),
        };
        if arguments.in_folder.is_some() && !arguments.program.is_empty() {
            let problem = "--in is for a crate that `start` made, not for a program after --";
            return Err(words.command.misuse(problem));
        }
        Ok(arguments)
    }
}

/// Judges the reader's crate or program at once and after each save, and prints each answer, until
/// the reader ends this or closes the terminal. With `once`, returns 0 if the picture is right,
/// else 1.
///
/// # Errors
/// If a word is not what it should be, if the crate or its folder is missing, or the folder
/// disappears.
pub(crate) fn watch(words: &Words) -> Result<ExitCode, Box<dyn Error>> {
    let arguments = &Arguments::read(words)?;
    let subject = WatchedProgram::of(arguments)?;
    let mut changes = FolderChanges::below(&subject.folder);
    let mut laws = BackgroundBuild::default();
    loop {
        laws.pause();
        let start = Instant::now();
        if screen::is_cleared() {
            output::to_stdout(|out| out.write_all("judging …".as_bytes()))?;
        }
        let waits = arguments.once || laws.is_done();
        let mut is_old = || !arguments.once && (changes.has_a_save() || screen::is_output_closed());
        let judged = match subject.judge(waits, &mut is_old) {
            Ok(judged) => Some(judged),
            Err(NoVerdict::NotBuilt(problem)) => Some(no_picture::not_built(&problem).into()),
            Err(NoVerdict::NewerSave) => None,
        };
        let mut shown = judged.map(|it| Shown::new(&subject, it, start.elapsed()));
        if arguments.once {
            let is_right = shown.as_ref().is_some_and(|it| it.answer.is_right());
            shown.iter_mut().try_for_each(Shown::show_whole)?;
            return Ok(ExitCode::from(u8::from(!is_right)));
        }
        shown.iter().try_for_each(Shown::show)?;
        if shown.is_some() && subject.program.is_empty() {
            laws.go_on(&subject.folder);
        }
        if !wait(&subject, &mut changes, &mut laws, &mut shown)? {
            return Ok(ExitCode::SUCCESS);
        }
    }
}

/// Waits until the program has to be judged again: for a save, or for the laws if they were missed.
/// Shows a repair as soon as it is found. Returns false if nobody reads the answers any more.
fn wait(
    subject: &WatchedProgram,
    changes: &mut FolderChanges,
    laws: &mut BackgroundBuild,
    shown: &mut Option<Shown>,
) -> Result<bool, Box<dyn Error>> {
    loop {
        let mut is_repaired = false;
        // Once they are built, they are asked if they were missed.
        let mut has_ended = || {
            is_repaired = shown.as_mut().is_some_and(Shown::has_news);
            let asks = laws.has_ended() && subject.misses_laws.take();
            is_repaired || asks || screen::is_output_closed()
        };
        let waited = changes.wait_for_save(&mut has_ended);
        if let Waited::Gone = waited {
            let folder = name_from_here(&subject.folder);
            return Err(format!("{folder} is not there any more").into());
        }
        if screen::is_output_closed() {
            return Ok(false);
        }
        if !matches!(waited, Waited::Ended) || !is_repaired {
            return Ok(true);
        }
        shown.iter().try_for_each(Shown::show)?;
    }
}

/// An answer on the screen, and the search for a repair that may join it.
struct Shown {
    title: String,
    answer: Answer,
    news: Vec<String>,
    took: Duration,
    search: Option<Search>,
}

impl Shown {
    /// Takes an answer, adds what is done to the reader's list, and starts the search.
    fn new(subject: &WatchedProgram, judged: Judged, took: Duration) -> Self {
        let news = subject.done.add_all(&judged.answer.done);
        Self {
            title: subject.title(),
            news: news.unwrap_or_else(|problem| vec![problem.to_string()]),
            answer: judged.answer,
            took,
            search: judged.wrong.map(Search::start),
        }
    }

    /// Prints the screen.
    fn show(&self) -> Result<(), Box<dyn Error>> {
        let is_searched = self.search.is_some();
        let (answer, news) = (&self.answer, &self.news);
        let screen = screen::compose(&self.title, answer, is_searched, news, self.took);
        Ok(output::to_stdout(|out| out.write_all(screen.as_bytes()))?)
    }

    /// Prints the screen once the search has ended.
    fn show_whole(&mut self) -> Result<(), Box<dyn Error>> {
        if let Some(search) = self.search.take() {
            search.wait().join(&mut self.answer);
        }
        self.show()
    }

    /// Returns true if the search has ended since this was asked last; then the answer has what it
    /// found.
    fn has_news(&mut self) -> bool {
        let outcome = self.search.as_ref().and_then(Search::outcome);
        let has_news = outcome.is_some();
        if let Some(outcome) = outcome {
            outcome.join(&mut self.answer);
            self.search = None;
        }
        has_news
    }
}

/// An answer, and the crate to be searched for a repair.
struct Judged {
    answer: Answer,
    wrong: Option<WrongCrate>,
}

impl From<Answer> for Judged {
    fn from(answer: Answer) -> Self {
        Self {
            answer,
            wrong: None,
        }
    }
}

/// The number of differing answers of functions after which no more are counted.
const MOST_UNLIKE: usize = 60;

/// The crate or program that is watched and judged.
struct WatchedProgram {
    task: Task,
    /// The reader's program with its arguments, or empty for the crate in `folder`.
    program: Vec<OsString>,
    folder: PathBuf,
    limit: Duration,
    done: Done,
    crates: ReaderCrates,
    /// True if the last answer came before the laws were built.
    misses_laws: Cell<bool>,
}

impl WatchedProgram {
    fn of(arguments: &Arguments) -> Result<Self, Box<dyn Error>> {
        let chapter = arguments.chapter;
        let task = find_task(chapter, arguments.probe)?;
        let crates = ReaderCrates::find(arguments.in_folder.as_deref());
        let (folder, done) = if arguments.program.is_empty() {
            (crates.folder_of(chapter), Done::in_folder(crates.folder()))
        } else {
            (env::current_dir()?, Done::find(None))
        };
        if !folder.is_dir() {
            let make = if Chapter::TYPED.contains(&chapter) {
                format!("Make it with {}, or name", crates.start_command(chapter))
            } else {
                "Name".to_owned()
            };
            return Err(misuse(&format!(
                "there is no {} yet\n{make} your program: {} watch {} -- PROGRAM",
                name_from_here(&folder),
                companion_command(),
                chapter.name(),
            )));
        }
        let (program, limit) = (arguments.program.clone(), arguments.timeout);
        Ok(Self {
            task,
            program,
            folder,
            limit,
            done,
            crates,
            misses_laws: Cell::new(false),
        })
    }

    fn title(&self) -> String {
        let name = self.task.chapter.name();
        match self.task.probe {
            Some(probe) => format!("{name}, probe {}", probe.name),
            None => name.to_owned(),
        }
    }

    /// Builds and runs the program, and judges its picture. With `waits`, waits until the laws are
    /// built.
    ///
    /// # Errors
    /// If the crate can't be built, or if `is_old` returns true meanwhile: there is a newer save.
    fn judge(&self, waits: bool, is_old: &mut dyn FnMut() -> bool) -> Result<Judged, NoVerdict> {
        self.misses_laws.set(false);
        let is_crate = self.program.is_empty();
        let built = is_crate.then(|| build::build_crate(&self.folder, is_old));
        let built = built.transpose()?;
        let words = match &built {
            Some(built) => vec![built.program.clone(), "-".into()],
            None => self.program.clone(),
        };
        let mut command = subprocess::reader_command(&words);
        command.current_dir(&self.folder);
        let ran = subprocess::run(command, self.limit, subprocess::last_errors, is_old);
        let mut ask = || self.laws(waits, is_old);
        let (end, errors) = match ran {
            Ok((ProgramEnd::Interrupted, _)) => return Err(NoVerdict::NewerSave),
            Ok((end, errors)) => (Ok(end), errors),
            Err(cause) => (Err(cause), String::new()),
        };
        let place = no_picture::unwritten_places(&errors).next();
        let name = match is_crate {
            true => "your program".to_owned(),
            false => names::escaped_name(&words[0]),
        };
        match (subprocess::printed_or_cause(&name, end, self.limit), place) {
            (Ok(bytes), _) => self.of_picture(&bytes, built, &mut ask),
            (Err(_), Some(place)) => {
                let asks = is_crate && self.task.chapter != Chapter::RedSphere;
                let asked = if asks { ask()? } else { None };
                Ok(no_picture::not_written(self.task.chapter, place, asked).into())
            }
            (Err(cause), None) => Ok(no_picture::stopped(&cause, &errors).into()),
        }
    }

    /// Runs the test that puts the crate under the laws. Returns `None` if there is no such test,
    /// or if the laws are still to be built and this does not wait for them.
    fn laws(
        &self,
        waits: bool,
        is_old: &mut dyn FnMut() -> bool,
    ) -> Result<Option<LawsResult>, NoVerdict> {
        if !self.folder.join("tests/laws.rs").is_file() {
            return Ok(None);
        }
        let test = build::build_laws_test(&self.folder, waits, is_old)?;
        self.misses_laws.set(test.is_none());
        Ok(
            test.map(|test| {
                laws::run_laws_test(&test, self.task.chapter, &self.folder, self.limit)
            }),
        )
    }

    /// Returns true if the picture of chapter 2 is only the sky yet: there is nothing to ask, and
    /// no reader waits for the laws.
    fn is_before_the_laws(&self, bytes: &[u8]) -> bool {
        let chapter = self.task.chapter;
        let is_sky = |picture: Picture| picture == Chapter::Gradient.picture(picture.width());
        chapter == Chapter::RedSphere
            && !self.done.has(&step_done_line(chapter, 1))
            && read(bytes).is_ok_and(|reading| is_sky(reading.picture()))
    }

    /// Judges a picture, with all that is known of the program: `built` is the crate that drew it,
    /// and `ask` runs the test of the laws.
    fn of_picture(
        &self,
        bytes: &[u8],
        built: Option<BuiltCrate>,
        ask: &mut dyn FnMut() -> Result<Option<LawsResult>, NoVerdict>,
    ) -> Result<Judged, NoVerdict> {
        let chapter = self.task.chapter;
        let is_crate = built.is_some();
        let program = built.as_ref().map(|it| it.program.clone());
        let has_own_prelude = self.folder.join("src/rtweekend.rs").exists();
        let can_be_made = |slip: &Slip| {
            let is_typed = has_own_prelude || slip.is_typed_in(chapter);
            !is_crate || slip.is_possible_in_rust() && is_typed
        };
        let warnings = built.map_or_else(Vec::new, |it| it.warnings);
        let asks = is_crate && !self.is_before_the_laws(bytes);
        let asked = asks.then(ask).transpose()?.flatten();
        let answers = asked.as_ref().map(|it| &it.answers);
        let compare = answers.map(|answers| {
            |program: &ChapterProgram| lawful::mismatch_with(answers, chapter, program, MOST_UNLIKE)
        });
        let context = Context {
            languages: match is_crate {
                true => Languages::Rust,
                false => Languages::Both,
            },
            can_be_made: Some(&can_be_made),
            sources: match is_crate {
                true => sources::of_crate(&self.folder, chapter),
                false => Sources::default(),
            },
            typed: None,
            answers: compare.as_ref().map(|compare| compare as _),
            warnings,
            steps: self.done_steps(),
        };
        let attempt = Attempt {
            laws: match &asked {
                None if self.misses_laws.get() => Some(&LawsStatus::Coming),
                asked => asked.as_ref().map(|it| &it.outcome),
            },
            commands: Commands {
                judge: Box::new(|probe| self.watch(probe)),
                start: Some(Box::new(|chapter| self.start(chapter))),
                test: "cargo test, in the folder of your crate, shows more",
            },
            ..Attempt::new(self.task, &context)
        };
        let mut answer = attempt.answer(judge_file(&self.task, bytes, 0, &context));
        if answer.is_right() && !is_crate && Chapter::WITH_SPHERES.contains(&chapter) {
            answer.rows.push(laws_hint(chapter));
        }
        let is_wrong = answer.headline.grade == Grade::Wrong && !self.misses_laws.get();
        let wrong = program.filter(|_| is_wrong).map(|program| WrongCrate {
            folder: self.folder.clone(),
            program,
            chapter,
            right: self.right_pictures(&answer),
        });
        Ok(Judged { answer, wrong })
    }

    /// Draws the pictures that a repaired crate may draw: that of the task, or that of the step
    /// after the last one that was done.
    ///
    /// Without a step done before, a step counts for nothing: to leave out all that was typed
    /// "repairs" many a program.
    fn right_pictures(&self, answer: &Answer) -> RightPictures {
        let chapter = self.task.chapter;
        let drawn = answer.pictures.as_ref();
        if let (Some(_), Some(it)) = (self.task.probe, drawn) {
            let whole = vec![repair::numbers(&it.right)];
            return RightPictures {
                whole,
                small: Vec::new(),
            };
        }
        let steps = steps::of_chapter(chapter);
        let done = self.done_steps().iter().rposition(|it| *it);
        let next = done.and_then(|it| steps[..steps.len() - 1].get(it + 1));
        let next = next.map(|it| it.applied_to(&ChapterProgram::right(chapter)));
        let at = |width| {
            let next = next.as_ref().map(|it| it.run(width).picture());
            let right = [chapter.picture(width)].into_iter().chain(next);
            right.map(|it| repair::numbers(&it)).collect()
        };
        RightPictures {
            whole: at(drawn.map_or(chapter.book_width(), |it| it.yours.width())),
            small: at(repair::SMALL),
        }
    }

    /// Returns for each step of the chapter true if it is on the list of done things; empty for a
    /// probe, which has no steps.
    fn done_steps(&self) -> Vec<bool> {
        let chapter = self.task.chapter;
        let is_done = |step| self.done.has(&step_done_line(chapter, step));
        let steps = (1..=steps::of_chapter(chapter).len()).filter(|_| self.task.probe.is_none());
        steps.map(is_done).collect()
    }

    /// Writes the command that watches this program, or a probe of it.
    fn watch(&self, probe: Option<Probe>) -> String {
        let chapter = self.task.chapter;
        let probe = probe.map_or(String::new(), |probe| format!(" --probe {}", probe.name));
        if self.program.is_empty() {
            self.crates.watch_command(chapter) + &probe
        } else {
            self.watch_program(chapter, &probe)
        }
    }

    /// Writes the command with which the reader goes on to another chapter.
    fn start(&self, chapter: Chapter) -> String {
        if self.program.is_empty() && self.crates.folder_of(chapter).is_dir() {
            self.crates.watch_command(chapter)
        } else if self.program.is_empty() {
            self.crates.start_command(chapter)
        } else {
            self.watch_program(chapter, "")
        }
    }

    fn watch_program(&self, chapter: Chapter, option: &str) -> String {
        let program: Vec<String> = self.program.iter().map(shell_word).collect();
        let (companion, name) = (companion_command(), chapter.name());
        format!("{companion} watch {name}{option} -- {}", program.join(" "))
    }
}

/// Names the command that asks a program in any language what no picture shows.
fn laws_hint(chapter: Chapter) -> Row {
    let (companion, name) = (companion_command(), chapter.name());
    let hint = format!(
        "{companion} laws {name} asks your function what no picture shows; lines on the page Check your picture"
    );
    Row::new(RowKind::Laws, hint)
}
