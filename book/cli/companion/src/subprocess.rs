//! A subprocess, with limits on time and bytes.
//!
//! It prints into a file without waiting for us, and nothing that it has started can keep us
//! waiting. It stays in our group of the terminal, so that Ctrl-C ends both.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, IsTerminal, Read};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use check::names;
use check::reading::{Cause, MOST_BYTES};
use tempfile::NamedTempFile;

/// All that the program prints, or one byte more than a picture may have, so that
/// the reading of pictures can say so.
///
/// # Errors
/// If the program does not start, fails, or takes longer than `limit`.
pub(crate) fn output_of(words: &[OsString], limit: Duration) -> Result<Vec<u8>, Cause> {
    let name = names::spelled(&words[0]);
    let failed = |problem, fix: &str| Err(Cause::new("program-failed", problem, fix));
    match finish(command(words), limit, &mut || false) {
        Ok(End::Itself(status, bytes)) if status.success() => Ok(bytes),
        Ok(End::Full(bytes)) => Ok(bytes),
        Ok(End::Itself(status, _)) => failed(
            format!("{name} ended with {status}"),
            "A program that draws a picture should end with 0. Read what it says above.",
        ),
        Ok(End::TooSlow) => failed(
            format!("{name} did not end within {limit:?}"),
            "Draw a smaller picture, or give it more time with --timeout SECONDS.",
        ),
        Ok(End::Interrupted) => unreachable!("nothing is newer"),
        Err(cause) => failed(
            format!("{name} does not start: {cause}"),
            "Is it built, and is its path right? A program in this folder is ./NAME.",
        ),
    }
}

/// A program with its arguments.
pub(crate) fn command(words: &[OsString]) -> Command {
    let mut command = Command::new(&words[0]);
    command.args(&words[1..]);
    command
}

/// Runs the program, unless `is_old` says that this is no longer wanted. How it ended, and the
/// last of what it wrote to standard error.
///
/// # Errors
/// If the program does not start.
pub(crate) fn run(
    mut command: Command,
    limit: Duration,
    is_old: &mut dyn FnMut() -> bool,
) -> io::Result<(End, String)> {
    const KEPT: usize = 1 << 14;
    let errors = NamedTempFile::new()?;
    command.stderr(errors.reopen()?);
    let end = finish(command, limit, is_old)?;
    let said = fs::read(errors.path())?;
    let last = &said[said.len().saturating_sub(KEPT)..];
    Ok((end, String::from_utf8_lossy(last).into_owned()))
}

/// How a program came to its end.
pub(crate) enum End {
    /// By itself, after it had printed this.
    Itself(ExitStatus, Vec<u8>),
    /// It printed more than any picture has.
    Full(Vec<u8>),
    /// It took too long.
    TooSlow,
    /// It is no longer wanted.
    Interrupted,
}

/// How often to look whether a program has ended.
const TICK: Duration = Duration::from_millis(5);

/// Waits until the program ends, or has to.
fn finish(
    mut command: Command,
    limit: Duration,
    is_old: &mut dyn FnMut() -> bool,
) -> io::Result<End> {
    // The terminal is ours: a program that is run again and again reads none of it.
    if io::stdin().is_terminal() {
        command.stdin(Stdio::null());
    }
    let printed = NamedTempFile::new()?;
    let mut running = Running(command.stdout(printed.reopen()?).spawn()?);
    let start = Instant::now();
    loop {
        let ended = running.0.try_wait()?;
        if printed.as_file().metadata()?.len() > MOST_BYTES as u64 {
            return Ok(End::Full(read(printed.path())?));
        }
        if let Some(status) = ended {
            return Ok(End::Itself(status, read(printed.path())?));
        }
        if start.elapsed() > limit {
            return Ok(End::TooSlow);
        }
        if is_old() {
            return Ok(End::Interrupted);
        }
        thread::sleep(TICK);
    }
}

/// A program that ends when this is dropped.
pub(crate) struct Running(pub(crate) Child);

impl Drop for Running {
    fn drop(&mut self) {
        // What has ended already can't be ended once more.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

fn read(path: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let most = MOST_BYTES as u64 + 1;
    File::open(path)?.take(most).read_to_end(&mut bytes)?;
    Ok(bytes)
}
