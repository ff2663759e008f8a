//! A subprocess, with limits on time and bytes.
//!
//! It stays in our group of the terminal, so that Ctrl-C ends both.

use std::ffi::OsString;
use std::io::{self, IsTerminal, Read};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, sync_channel};
use std::thread;
use std::time::{Duration, Instant};

use check::names;
use check::reading::{Cause, MOST_BYTES};

/// All that the program prints, or one byte more than a picture may have, so that
/// the reading of pictures can say so.
///
/// # Errors
/// If the program does not start, fails, or takes longer than `limit`.
pub(crate) fn output_of(words: &[OsString], limit: Duration) -> Result<Vec<u8>, Cause> {
    let name = names::spelled(&words[0]);
    let mut program = Running::start(&mut command(words)).map_err(|cause| {
        failed(
            format!("{name} does not start: {cause}"),
            "Is it built, and is its path right? A program in this folder is ./NAME.",
        )
    })?;
    match program.finish(limit, &mut || false) {
        Ok(End::Itself(status, bytes)) if status.success() => Ok(bytes),
        Ok(End::Full(bytes)) => Ok(bytes),
        Ok(End::Itself(status, _)) => Err(failed(
            format!("{name} ended with {status}"),
            "A program that draws a picture should end with 0. Read what it says above.",
        )),
        Ok(End::TooSlow) => Err(failed(
            format!("{name} did not end within {limit:?}"),
            "Draw a smaller picture, or give it more time with --timeout SECONDS.",
        )),
        Ok(End::Interrupted) => unreachable!("nothing is newer"),
        Err(cause) => Err(failed(
            format!("the output of {name} can't be read: {cause}"),
            "Let it write a file, and check that.",
        )),
    }
}

fn failed(problem: String, fix: &str) -> Cause {
    Cause::new("program-failed", problem, fix)
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
/// If the program does not start, or can't be read from.
pub(crate) fn run(
    mut command: Command,
    limit: Duration,
    is_old: &mut dyn FnMut() -> bool,
) -> io::Result<(End, String)> {
    let mut program = Running::start(command.stderr(Stdio::piped()))?;
    let errors = program.child.stderr.take().expect("it is piped");
    let errors = last_words(errors)?;
    let end = program.finish(limit, is_old)?;
    drop(program);
    Ok((end, errors.recv_timeout(10 * TICK).unwrap_or_default()))
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

/// A program that ends when this is dropped.
struct Running {
    child: Child,
    printed: Receiver<io::Result<Vec<u8>>>,
}

/// How long to wait for what a program has printed before it ended, and how often to
/// look at the clock.
const TICK: Duration = Duration::from_millis(50);

impl Running {
    fn start(command: &mut Command) -> io::Result<Self> {
        // The terminal is ours: nobody types for a program that is run again and again.
        if io::stdin().is_terminal() {
            command.stdin(Stdio::null());
        }
        let mut child = command.stdout(Stdio::piped()).spawn()?;
        let output = child.stdout.take().expect("it is piped");
        let printed = pieces(output)?;
        Ok(Self { child, printed })
    }

    /// Collects what is printed until the program ends, or has to.
    fn finish(&mut self, limit: Duration, is_old: &mut dyn FnMut() -> bool) -> io::Result<End> {
        let start = Instant::now();
        let mut bytes = Vec::new();
        let mut ended = None;
        loop {
            match self.printed.recv_timeout(TICK) {
                Ok(piece) => bytes.append(&mut piece?),
                // One that has ended prints no more: another one may keep the pipe.
                Err(nothing) => {
                    if let Some(status) = ended {
                        return Ok(End::Itself(status, bytes));
                    }
                    ended = self.child.try_wait()?;
                    if nothing == RecvTimeoutError::Disconnected {
                        // It has closed its output, and may go on.
                        thread::sleep(Duration::from_millis(1));
                    }
                }
            }
            if bytes.len() > MOST_BYTES {
                return Ok(End::Full(bytes));
            }
            if start.elapsed() > limit {
                return Ok(End::TooSlow);
            }
            if is_old() {
                return Ok(End::Interrupted);
            }
        }
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        // What has ended already can't be ended once more.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Reads on a thread of its own: a read can't be told to give up.
fn pieces(mut output: impl Read + Send + 'static) -> io::Result<Receiver<io::Result<Vec<u8>>>> {
    let (full, printed) = sync_channel(16);
    let read = move || {
        loop {
            let mut piece = vec![0; 1 << 16];
            let read = output.read(&mut piece);
            let is_last = !matches!(read, Ok(1..));
            let piece = read.map(|length| {
                piece.truncate(length);
                piece
            });
            if full.send(piece).is_err() || is_last {
                return;
            }
        }
    };
    thread::Builder::new().spawn(read)?;
    Ok(printed)
}

/// Reads to the end on a thread of its own, and keeps the last of it.
fn last_words(mut errors: impl Read + Send + 'static) -> io::Result<Receiver<String>> {
    const KEPT: usize = 1 << 14;
    let (done, words) = sync_channel(1);
    let read = move || {
        let mut kept = Vec::new();
        let mut piece = vec![0; KEPT];
        while let Ok(length @ 1..) = errors.read(&mut piece) {
            kept.extend_from_slice(&piece[..length]);
            kept.drain(..kept.len().saturating_sub(KEPT));
        }
        let _ = done.send(String::from_utf8_lossy(&kept).into_owned());
    };
    thread::Builder::new().spawn(read)?;
    Ok(words)
}
