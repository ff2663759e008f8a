//! Cargo as a subprocess: what most readers need later is built when it is asked for.

use std::error::Error;
use std::ffi::OsString;
use std::io::{self, IsTerminal, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, ExitStatus, Stdio};
use std::{env, thread};

use course::names;

use crate::draw;

/// A package of this workspace that is built when it is asked for.
pub struct Package {
    name: &'static str,
    /// The name of its program.
    program: &'static str,
    /// What to say before it is built: what it is for, and about how long that takes on two
    /// cores.
    says: &'static str,
}

/// What judges, watches and measures.
pub const COMPANION: Package = Package {
    name: "companion",
    program: "rtrace",
    says: "Building the companion, which judges, watches and measures: the first time, about a minute",
};

/// What weaves the book.
pub const WEAVER: Package = Package {
    name: "weave",
    program: "weave",
    says: "Building mdBook and the weaver: the first time, about a minute",
};

impl Package {
    /// Its program as the sources are now: cargo builds it, if need be.
    ///
    /// # Errors
    /// If the workspace or cargo is missing, or it can't be built.
    pub fn built(&self) -> Result<Command, Box<dyn Error>> {
        let workspace = draw::workspace()?;
        let Place {
            target,
            profile,
            programs,
        } = Place::of_this_program(workspace);
        let mut build = Command::new(cargo());
        build
            .args(["build", "--package", self.name, "--bin", self.program])
            // What the tests stand on has the features that they ask for: it is built once.
            .args(["--package", "suite", "--profile", &profile])
            .arg("--manifest-path")
            .arg(workspace.join("Cargo.toml"))
            .arg("--target-dir")
            .arg(target);
        let name = self.name;
        let built = run(build, self.says)
            .map_err(|cause| format!("cargo, which builds `{name}`, does not start: {cause}"))?;
        if !built.status.success() {
            let why = if built.is_shown {
                "see above"
            } else {
                built.said.trim_end()
            };
            return Err(format!("cargo has not built `{name}`: {why}").into());
        }
        let program = programs.join(self.program);
        Ok(Command::new(
            program.with_extension(env::consts::EXE_EXTENSION),
        ))
    }
}

/// Where cargo puts programs.
struct Place {
    target: PathBuf,
    profile: String,
    programs: PathBuf,
}

impl Place {
    /// Where cargo has put this program; or else, if it is installed, the usual place.
    fn of_this_program(workspace: &Path) -> Self {
        let beside = || {
            let programs = env::current_exe().ok()?.parent()?.to_owned();
            // Cargo keeps there what it knows of its compiler.
            let is_target = |folder: &&Path| folder.join(".rustc_info.json").is_file();
            let target = programs.ancestors().find(is_target)?.to_owned();
            let folder = programs.file_name()?.to_str()?;
            let profile = if folder == "debug" { "dev" } else { folder };
            Some(Self {
                target,
                profile: profile.to_owned(),
                programs,
            })
        };
        beside().unwrap_or_else(|| {
            let target = workspace.join("target");
            Self {
                profile: "dev".to_owned(),
                programs: target.join("debug"),
                target,
            }
        })
    }
}

/// The program that builds crates.
pub fn cargo() -> OsString {
    env::var_os("CARGO").unwrap_or_else(|| "cargo".into())
}

/// What came of a run of cargo.
pub struct Run {
    /// How it ended.
    pub status: ExitStatus,
    /// What it printed.
    pub printed: Vec<u8>,
    /// What it said besides.
    pub said: String,
    /// Whether the reader has seen that.
    pub is_shown: bool,
}

/// Runs cargo. If it builds more than a reader's own crate, what it says is seen, and `first`
/// before it.
///
/// # Errors
/// If it does not start, or can't be read from.
pub fn run(mut cargo: Command, first: &str) -> io::Result<Run> {
    cargo.env("CARGO_TERM_COLOR", "never");
    if io::stderr().is_terminal() {
        // It sees no terminal, and is told that there is one, and how wide.
        let columns = terminal_size::terminal_size().map_or(80, |(width, _)| width.0);
        cargo.env("CARGO_TERM_PROGRESS_WHEN", "always");
        cargo.env("CARGO_TERM_PROGRESS_WIDTH", columns.to_string());
    }
    cargo
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    let mut child = cargo.spawn()?;
    let mut output = child.stdout.take().expect("it is piped");
    let errors = child.stderr.take().expect("it is piped");
    let (printed, said) = thread::scope(|scope| {
        let said = scope.spawn(|| show(errors, first));
        let mut printed = Vec::new();
        output.read_to_end(&mut printed)?;
        io::Result::Ok((printed, said.join().expect("it only reads")))
    })?;
    let (said, is_shown) = said?;
    Ok(Run {
        status: child.wait()?,
        printed,
        said,
        is_shown,
    })
}

/// Reads to the end what cargo says, and shows it meanwhile: whether it has.
fn show(mut errors: impl Read, first: &str) -> io::Result<(String, bool)> {
    let mut said = Vec::new();
    let mut shown = None;
    let mut piece = [0; 4096];
    loop {
        let length = errors.read(&mut piece)?;
        said.extend_from_slice(&piece[..length]);
        if shown.is_none() && has_work(&said) {
            tell(&format!("{first}\n"));
            shown = Some(0);
        }
        // A letter may have more bytes than one, and an end of a line has not.
        let end = said.iter().rposition(|byte| b"\r\n".contains(byte));
        if let (Some(shown), Some(end)) = (&mut shown, end) {
            tell(&String::from_utf8_lossy(&said[*shown..=end]));
            *shown = end + 1;
        }
        if length == 0 {
            let said = String::from_utf8_lossy(&said).into_owned();
            return Ok((said, shown.is_some()));
        }
    }
}

/// Whether a line tells of work, but for that on a reader's own crate, which takes no time.
fn has_work(said: &[u8]) -> bool {
    const WORK: [&str; 3] = ["Compiling", "Downloading", "Updating"];
    let said = String::from_utf8_lossy(said);
    let is_work = |line: &str| {
        line.ends_with('\n') && !line.contains(" my_") && WORK.iter().any(|it| line.contains(it))
    };
    said.split_inclusive('\n').any(is_work)
}

/// Says it on standard error, where each line takes the place of what was there. What a
/// terminal would obey in it, from the script of a package perhaps, is spelled out.
fn tell(text: &str) {
    const ERASE: &str = "\x1b[K";
    let erase = if io::stderr().is_terminal() {
        ERASE
    } else {
        ""
    };
    for line in text.replace(ERASE, "").split_inclusive(['\r', '\n']) {
        let said = line.trim_end_matches(['\r', '\n']);
        let end = &line[said.len()..];
        // If it can't be written, nobody looks.
        let _ = write!(io::stderr(), "{}{erase}{end}", names::visible(said));
    }
}

/// Becomes that program, whose input, signals and exit code are its own.
///
/// # Errors
/// If it does not start.
#[cfg(unix)]
pub fn become_program(mut program: Command) -> Result<ExitCode, Box<dyn Error>> {
    Err(std::os::unix::process::CommandExt::exec(&mut program).into())
}

/// Runs that program, and ends as it does.
///
/// # Errors
/// If it does not start.
#[cfg(not(unix))]
pub fn become_program(mut program: Command) -> Result<ExitCode, Box<dyn Error>> {
    let code = program.status()?.code();
    let code = code.and_then(|code| u8::try_from(code).ok());
    Ok(code.map_or(ExitCode::FAILURE, ExitCode::from))
}
