//! Cargo as a subprocess: what most readers need later is built when it is asked for.

use std::error::Error;
use std::ffi::OsString;
use std::io::{self, BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, ExitStatus, Stdio};
use std::{env, thread};

use crate::draw;
use crate::misuse::complain;

/// A package of this workspace that is built when it is asked for.
pub struct Package {
    name: &'static str,
    /// The name of its program.
    program: &'static str,
    /// The line to show before it is built: its purpose, and about how long it takes on two cores.
    says: &'static str,
}

/// The companion, which judges, watches and measures.
pub const COMPANION: Package = Package {
    name: "companion",
    program: "rtrace",
    says: "Building the companion, which judges, watches and measures: the first time, about a minute",
};

/// The weaver of the book.
pub const WEAVER: Package = Package {
    name: "weave",
    program: "weave",
    says: "Building mdBook and the weaver: the first time, about a minute",
};

impl Package {
    /// Returns the command that runs its program. Cargo builds that before, if need be.
    ///
    /// # Errors
    /// If the workspace or cargo is missing, or it can't be built.
    pub fn built_program(&self) -> Result<Command, Box<dyn Error>> {
        let workspace = draw::find_workspace()?;
        let (target, programs) = build_folders(workspace);
        let mut build = Command::new(program_name());
        build
            .args(["build", "--package", self.name, "--bin", self.program])
            // What the tests stand on has the features that they ask for: it is built once.
            .args(["--package", "suite", "--profile"])
            .arg(match programs.file_name() {
                Some(profile) if profile != "debug" => profile,
                _ => "dev".as_ref(),
            })
            .arg("--manifest-path")
            .arg(workspace.join("Cargo.toml"))
            .arg("--target-dir")
            .arg(target);
        let name = self.name;
        let built = run_cargo(build, self.says)
            .map_err(|cause| format!("cargo, which builds `{name}`, does not start: {cause}"))?;
        if !built.status.success() {
            return Err(format!("cargo has not built `{name}`: {}", built.said.trim_end()).into());
        }
        let program = programs.join(self.program);
        Ok(Command::new(
            program.with_extension(env::consts::EXE_EXTENSION),
        ))
    }
}

/// Where cargo puts all that it builds, and where this program is among that; or else, if it
/// is installed, the usual places.
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

/// Returns the name of cargo: of the one that runs this program, if it does.
pub fn program_name() -> OsString {
    env::var_os("CARGO").unwrap_or_else(|| "cargo".into())
}

/// A run of cargo that has ended.
pub struct CargoRun {
    /// Its exit status.
    pub status: ExitStatus,
    /// Its standard output.
    pub printed: Vec<u8>,
    /// Its standard error.
    pub said: String,
}

/// Runs cargo. If it builds more than a reader's own crate, what it says is seen as it comes,
/// and `first` before it.
///
/// # Errors
/// If it does not start, or can't be read from.
pub fn run_cargo(mut cargo: Command, first: &str) -> io::Result<CargoRun> {
    cargo.env("CARGO_TERM_COLOR", "never").stdin(Stdio::null());
    let mut child = cargo
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()?;
    let errors = child.stderr.take();
    thread::scope(|scope| {
        let said = scope.spawn(|| errors.map(|errors| show_work(BufReader::new(errors), first)));
        let output = child.wait_with_output()?;
        Ok(CargoRun {
            status: output.status,
            printed: output.stdout,
            said: said.join().ok().flatten().unwrap_or_default(),
        })
    })
}

/// Reads to the end what cargo says, and shows it from the first line on that tells of work.
pub fn show_work(errors: impl BufRead, first: &str) -> String {
    listen_for_work(errors, |line, is_first| {
        if is_first {
            complain(first);
        }
        complain(line);
    })
}

/// Reads to the end what cargo says. From the first line on that tells of work, each is heard,
/// with whether it is the first.
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

/// Returns true if the line tells of work, but for that on a reader's own crate, which takes no
/// time.
fn is_work(line: &str) -> bool {
    const WORK: [&str; 3] = ["Compiling", "Downloading", "Updating"];
    !line.contains(" my_") && WORK.iter().any(|work| line.trim_start().starts_with(work))
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
