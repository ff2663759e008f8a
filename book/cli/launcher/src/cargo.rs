//! Cargo as a subprocess: what most readers need later is built when it is asked for.

use std::error::Error;
use std::ffi::OsString;
use std::io::{self, BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::{env, thread};

use course::chapter::Chapter;

use crate::command_line::Words;
use crate::draw;
use crate::misuse::complain;

/// A package of this workspace that cargo builds when a command needs its program.
#[derive(Clone, Copy)]
pub(crate) struct Package {
    name: &'static str,
    /// The name of the package's program.
    program: &'static str,
}

impl Package {
    /// Returns the package of a chapter, whose program draws its picture.
    pub(crate) fn of(chapter: Chapter) -> Self {
        Self {
            name: chapter.name(),
            program: chapter.name(),
        }
    }
}

/// The package of the companion, the program `rtrace`: it judges pictures and watches crates. No
/// chapter is part of it, so it is built while one does not compile.
const COMPANION: Package = Package {
    name: "companion",
    program: "rtrace",
};

/// The package of the weaver, the program that makes the pages of the book from the notes.
const WEAVER: Package = Package {
    name: "weave",
    program: "weave",
};

/// The package of the program that compares the methods of chapter 6.
const METHODS: Package = Package {
    name: "measure",
    program: "methods",
};

/// Has a program run a command that is not the launcher's own, with the words with which this
/// program was started: builds it if it is not up to date, and becomes it. Only the program knows
/// what the words mean.
///
/// # Errors
/// If the workspace is gone, or cargo does not start or fails.
pub fn hand_on(words: &Words) -> Result<ExitCode, Box<dyn Error>> {
    let (package, says) = match words.command.name() {
        "hit" | "needs" => (
            METHODS,
            "Building what compares methods: the first time, about a minute",
        ),
        _ => (
            COMPANION,
            "Building the companion, which judges and watches: the first time, about a minute",
        ),
    };
    let mut program = program(package, says)?;
    program.args(env::args_os().skip(1));
    become_program(program)
}

/// Builds the weaver, which makes the pages of the book from the notes, if it is not up to date.
/// Returns the command that starts it, still without arguments.
pub(crate) fn weaver() -> Result<Command, Box<dyn Error>> {
    const SAYS: &str = "Building mdBook and the weaver: the first time, about a minute";
    program(WEAVER, SAYS)
}

/// Builds a program like [`build`], and returns the command that starts it, still without arguments.
fn program(package: Package, says: &str) -> Result<Command, Box<dyn Error>> {
    let built = build(&[package], says)?;
    let program = built.program(package);
    program
        .map(Command::new)
        .ok_or_else(|| built.failure(package))
}

/// The programs that cargo has built.
pub(crate) struct Built {
    /// The folder of all programs, also of those that could not be built.
    folder: PathBuf,
    names: Vec<String>,
    said: String,
}

impl Built {
    /// Returns the path of a package's program; `None` if cargo could not build it.
    pub(crate) fn program(&self, package: Package) -> Option<PathBuf> {
        let is_built = self.names.iter().any(|name| name == package.program);
        is_built.then(|| self.path(package))
    }

    fn path(&self, package: Package) -> PathBuf {
        let path = self.folder.join(package.program);
        path.with_extension(env::consts::EXE_EXTENSION)
    }

    /// Makes the error for a program that cargo could not build, with what cargo has said unless
    /// that was shown as it came.
    pub(crate) fn failure(&self, package: Package) -> Box<dyn Error> {
        let said = match self.said.lines().any(is_work) {
            true => "see above",
            false => self.said.trim_end(),
        };
        format!("cargo has not built `{}`: {said}", package.name).into()
    }
}

/// Builds packages as far as they are not up to date, in the profile of the running program. One
/// that does not compile does not keep the others from being built. Prints the line `says`, and
/// what cargo says, if there is work to do.
pub(crate) fn build(packages: &[Package], says: &str) -> Result<Built, Box<dyn Error>> {
    let workspace = draw::find_workspace()?;
    let (target, folder) = build_folders(workspace);
    let mut build = Command::new(program_name());
    build.arg("build");
    for package in packages {
        build.args(["--package", package.name, "--bin", package.program]);
    }
    build
        // What the tests stand on has the features that they ask for: it is built once.
        .args(["--package", "suite", "--keep-going", "--profile"])
        .arg(match folder.file_name() {
            Some(profile) if profile != "debug" => profile,
            _ => "dev".as_ref(),
        })
        .arg("--manifest-path")
        .arg(workspace.join("Cargo.toml"))
        .arg("--target-dir")
        .arg(target)
        // Standard output then tells which programs are built.
        .args(["--message-format", "json-render-diagnostics"])
        .env("CARGO_TERM_COLOR", "never")
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    let first = packages[0].name;
    let does_not_start =
        |cause: io::Error| format!("cargo, which builds `{first}`, does not start: {cause}");
    let (printed, said) = run(&mut build, says).map_err(does_not_start)?;
    Ok(Built {
        folder,
        names: printed.lines().filter_map(program_built).collect(),
        said,
    })
}

/// Runs cargo to its end, and returns all that it printed, and all that it said on standard error,
/// which [`show_work`] shows.
fn run(cargo: &mut Command, first: &str) -> io::Result<(String, String)> {
    let mut cargo = cargo.spawn()?;
    let errors = cargo.stderr.take();
    thread::scope(|scope| {
        let said = scope.spawn(|| errors.map(|errors| show_work(BufReader::new(errors), first)));
        let printed = cargo.wait_with_output()?.stdout;
        let said = said.join().ok().flatten().unwrap_or_default();
        Ok((String::from_utf8_lossy(&printed).into_owned(), said))
    })
}

/// Returns the name of the program that a line of cargo, an object in JSON, says to be up to date.
fn program_built(line: &str) -> Option<String> {
    let (_, path) = line.split_once("\"executable\":\"")?;
    let (path, _) = path.split_once("\",")?;
    Some(Path::new(path).file_stem()?.to_str()?.to_owned())
}

/// Returns the folder of all that cargo builds, and the one of the programs in it: those that the
/// running program lies in, or `target` and `target/debug` of the workspace if it is installed
/// elsewhere.
fn build_folders(workspace: &Path) -> (PathBuf, PathBuf) {
    let beside = || {
        let programs = env::current_exe().ok()?.parent()?.to_owned();
        // Cargo keeps there what it knows of its compiler.
        let is_target = |folder: &&Path| folder.join(".rustc_info.json").is_file();
        let target = programs.ancestors().find(is_target)?.to_owned();
        Some((target, programs))
    };
    beside().unwrap_or_else(|| {
        let target = workspace.join("target");
        (target.clone(), target.join("debug"))
    })
}

/// Returns the path of the cargo that has started this program, or else `cargo`.
pub fn program_name() -> OsString {
    env::var_os("CARGO").unwrap_or_else(|| "cargo".into())
}

/// Reads `errors`, the standard error of cargo, to its end and returns it as text. From the first
/// line that reports work, such as `Compiling`, prints each line to standard error, and the line
/// `first` before them; prints nothing if no line does.
pub fn show_work(errors: impl BufRead, first: &str) -> String {
    listen_for_work(errors, |line, is_first| {
        if is_first {
            complain(first);
        }
        complain(line);
    })
}

/// Reads `errors`, the standard error of cargo, to its end and returns it as text. From the first
/// line that reports work, such as `Compiling`, calls `heard` with each line, without its end, and
/// with true for the first of them.
pub fn listen_for_work(errors: impl BufRead, mut heard: impl FnMut(&str, bool)) -> String {
    let mut said = String::new();
    let mut is_heard = false;
    for line in errors.split(b'\n').map_while(Result::ok) {
        let line = String::from_utf8_lossy(&line);
        if is_heard || is_work(&line) {
            heard(&line, !is_heard);
            is_heard = true;
        }
        said += &format!("{line}\n");
    }
    said
}

/// Returns true if the line reports that cargo compiles or downloads something, other than a
/// reader's own crate, which takes no time.
fn is_work(line: &str) -> bool {
    const WORK: [&str; 3] = ["Compiling", "Downloading", "Updating"];
    !line.contains(" my_") && WORK.iter().any(|work| line.trim_start().starts_with(work))
}

/// Replaces this process by `program`, which takes over its input, its signals and its exit code.
/// Returns only if that fails.
///
/// # Errors
/// If the program does not start.
#[cfg(unix)]
fn become_program(mut program: Command) -> Result<ExitCode, Box<dyn Error>> {
    Err(std::os::unix::process::CommandExt::exec(&mut program).into())
}

/// Runs `program` to its end, and returns its exit code, or a failure if it has none.
///
/// # Errors
/// If the program does not start.
#[cfg(not(unix))]
fn become_program(mut program: Command) -> Result<ExitCode, Box<dyn Error>> {
    let code = program.status()?.code();
    let code = code.and_then(|code| u8::try_from(code).ok());
    Ok(code.map_or(ExitCode::FAILURE, ExitCode::from))
}
