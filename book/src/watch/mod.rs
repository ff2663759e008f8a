//! `watch`: a loop from each save to a verdict, one screen long.

mod build;
mod changes;
mod evidence;
mod laws;
mod screen;
mod verdict;

use std::error::Error;
use std::ffi::OsString;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant, SystemTime};
use std::{env, fs};

use check::names::{companion, from_here};
use check::scene::Scene;
use clap::Args;
use common::engine::output;
use slips::Chapter;
use slips::Probe;

use crate::check::{chapter_parser, probe_parser, seconds};
use crate::done::Done;
use crate::mine::{Mine, TYPED};
use crate::misuse::misuse;
use crate::subprocess::{self, End};
use changes::Changes;
use evidence::Evidence;
use verdict::Verdict;

/// What `cargo rtrace watch` is told.
#[derive(Args)]
pub(crate) struct Arguments {
    /// Which picture it should be
    #[arg(value_name = "CHAPTER", value_parser = chapter_parser())]
    chapter: Chapter,

    /// Your own program, which prints the picture; the current folder is watched
    /// [default: the crate that `start` made, whose folder is watched]
    #[arg(last = true, value_name = "PROGRAM", conflicts_with = "in_folder")]
    program: Vec<OsString>,

    /// Where your crates are, if not in mine
    #[arg(long = "in", value_name = "FOLDER")]
    in_folder: Option<PathBuf>,

    /// Your program draws the scene of this probe (see `cargo rtrace probes`)
    #[arg(long, value_name = "NAME", value_parser = probe_parser())]
    probe: Option<Probe>,

    /// How long your program may take
    #[arg(long, value_name = "SECONDS", default_value = "10", value_parser = seconds, allow_hyphen_values = true)]
    timeout: Duration,

    /// Say it once, and end with 0 if it is right
    #[arg(long)]
    once: bool,
}

/// Says how far the reader is, now and whenever something is saved.
pub(crate) fn watch(arguments: &Arguments) -> Result<ExitCode, Box<dyn Error>> {
    let subject = Subject::of(arguments)?;
    let mut changes = Changes::below(&subject.folder, subject.program.is_empty())?;
    let mut was_stale = false;
    if subject.is_built_for_the_first_time() {
        let said = "Building what your crate stands on. The first time, that takes a minute.\n";
        output::to_stdout(|out| out.write_all(said.as_bytes()))?;
    }
    loop {
        let start = Instant::now();
        if screen::replaces_the_last() {
            output::to_stdout(|out| out.write_all("judging …".as_bytes()))?;
        }
        // Twice in a row would be for ever, if the program itself writes what changes.
        let may_be_old = !arguments.once && !was_stale;
        let verdict = subject.judge(&mut || may_be_old && changes.has_a_save());
        let end = SystemTime::now();
        was_stale = verdict.is_stale;
        if !was_stale {
            let news = subject.done.add_all(&verdict.done);
            let news = news.unwrap_or_else(|problem| vec![problem.to_string()]);
            let screen = screen::compose(&subject.title(), &verdict, &news, start.elapsed());
            output::to_stdout(|out| out.write_all(screen.as_bytes()))?;
        }
        if arguments.once {
            return Ok(ExitCode::from(u8::from(!verdict.is_right)));
        }
        if !changes.wait(end)? {
            return Err(format!("{} is not there any more", from_here(&subject.folder)).into());
        }
    }
}

/// What is watched and judged.
struct Subject {
    scene: Scene,
    /// The reader's program with its arguments, or none for the crate in `folder`.
    program: Vec<OsString>,
    folder: PathBuf,
    limit: Duration,
    done: Done,
}

impl Subject {
    fn of(arguments: &Arguments) -> Result<Self, Box<dyn Error>> {
        let chapter = arguments.chapter;
        let scene = Scene::new(chapter, arguments.probe)
            .ok_or_else(|| misuse("this chapter has no place for the spheres of that probe"))?;
        let mine = Mine::find(arguments.in_folder.as_deref());
        let (folder, done) = match arguments.program.is_empty() {
            true => (mine.of(chapter), Done::in_folder(mine.folder())),
            false => {
                let here = env::current_dir()?;
                let done = Done::in_folder(&here);
                (here, done)
            }
        };
        if !folder.is_dir() {
            let (companion, name) = (companion(), chapter.name());
            let make = match TYPED.contains(&chapter) {
                true => format!(
                    "Make it with {companion} start {name}{}, or name",
                    mine.option()
                ),
                false => "Name".to_owned(),
            };
            return Err(misuse(&format!(
                "there is no {} yet\n{make} your program: {companion} watch {name} -- PROGRAM",
                from_here(&folder)
            )));
        }
        let (program, limit) = (arguments.program.clone(), arguments.timeout);
        Ok(Self {
            scene,
            program,
            folder,
            limit,
            done,
        })
    }

    fn is_built_for_the_first_time(&self) -> bool {
        let target = env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
        let target = target.unwrap_or(self.folder.with_file_name("target"));
        let has_laws = self.folder.join("tests/laws.rs").is_file();
        let needed = if has_laws { "liblaws-" } else { "libcommon-" };
        let mut built = fs::read_dir(target.join("debug/deps"))
            .into_iter()
            .flatten()
            .flatten();
        let is_built = built.any(|file| file.file_name().to_string_lossy().starts_with(needed));
        self.program.is_empty() && !is_built
    }

    fn title(&self) -> String {
        let name = self.scene.chapter.name();
        match self.scene.probe {
            Some(probe) => format!("{name}, probe {}", probe.name),
            None => name.to_owned(),
        }
    }

    /// Builds, draws and compares, unless `is_old` says meanwhile that there is
    /// something newer to judge.
    fn judge(&self, is_old: &mut dyn FnMut() -> bool) -> Verdict {
        let built = match self.program.is_empty() {
            true => match build::build(&self.folder, is_old) {
                Ok(Some(built)) => Some(built),
                Ok(None) => return Verdict::stale(),
                Err(problem) => return Verdict::not_built(&problem),
            },
            false => None,
        };
        let words = match &built {
            Some(built) => vec![built.program.clone(), "-".into()],
            None => self.program.clone(),
        };
        let ran = subprocess::run(&words, &self.folder, self.limit, is_old);
        let laws = built.and_then(|built| built.laws);
        let ask_laws = || laws::ask(laws.as_deref()?, &self.folder, self.limit);
        let evidence = Evidence {
            scene: &self.scene,
            is_crate: self.program.is_empty(),
            is_chapter_only: self.program.is_empty()
                && !self.folder.join("src/rtweekend.rs").exists(),
            is_done: &|thing| self.done.has(thing),
            ask_laws: &ask_laws,
        };
        match ran {
            Ok((End::Interrupted, _)) => Verdict::stale(),
            Ok((End::Itself(status, bytes), _)) if status.success() => evidence.of_picture(&bytes),
            Ok((End::Full(bytes), _)) => evidence.of_picture(&bytes),
            Ok((End::Itself(status, _), errors)) => Verdict::failed(&self.scene, &status, &errors),
            Ok((End::TooSlow, errors)) => Verdict::too_slow(self.limit, &errors),
            Err(cause) => Verdict::not_started(&words[0], &cause),
        }
    }
}
