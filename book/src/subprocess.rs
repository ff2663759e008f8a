//! A subprocess in a process group of its own, with limits on time and bytes.
//!
//! Whoever it starts belongs to the group and ends with it: a server that keeps the
//! pipe open, a loop that never ends. A signal that ends us, such as Ctrl-C, does not
//! reach the group, so we end it first.

use std::ffi::OsString;
use std::io::{self, IsTerminal, PipeReader, Read};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, sync_channel};
use std::thread;
use std::time::{Duration, Instant};

use check::names;
use check::reading::{Cause, MOST_BYTES};

#[cfg(unix)]
use crate::signals;

/// All that the program prints, or one byte more than a picture may have, so that
/// the reading of pictures can say so.
///
/// # Errors
/// If the program does not start, fails, or takes longer than `limit`.
pub(crate) fn output_of(words: &[OsString], limit: Duration) -> Result<Vec<u8>, Cause> {
    let name = names::spelled(&words[0]);
    let mut group = Group::start(command(words), Stdio::inherit()).map_err(|cause| {
        failed(
            format!("{name} does not start: {cause}"),
            "Is it built, and is its path right? A program in this folder is ./NAME.",
        )
    })?;
    match group.finish(limit, &mut |_| false) {
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

/// Runs the program, unless `is_old`, which is shown what is printed so far, says that this
/// is no longer wanted. How it ended, and the last of what it wrote to standard error.
///
/// # Errors
/// If the program does not start, or can't be read from.
pub(crate) fn run(
    command: Command,
    limit: Duration,
    is_old: &mut dyn FnMut(&[u8]) -> bool,
) -> io::Result<(End, String)> {
    let (errors, its_end) = io::pipe()?;
    let errors = last_words(errors)?;
    let mut group = Group::start(command, its_end.into())?;
    let end = group.finish(limit, is_old)?;
    drop(group);
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

/// A program and all that it starts; it ends when this is dropped, and then we do, if a
/// signal has asked for it meanwhile.
struct Group {
    child: Child,
    printed: Receiver<io::Result<Vec<u8>>>,
    #[cfg(unix)]
    _until_it_has_ended: signals::Deferral,
}

/// How long to wait for what a program has printed before it ended, and how often to
/// look at the clock.
const TICK: Duration = Duration::from_millis(50);

impl Group {
    fn start(mut command: Command, errors: Stdio) -> io::Result<Self> {
        #[cfg(unix)]
        let deferral = signals::Deferral::begin();
        // Where no thread can be started to read, nothing is started that prints.
        let (output, its_end) = io::pipe()?;
        let printed = pieces(output)?;
        command.stdout(its_end).stderr(errors);
        // A group in the background is stopped when it reads from the terminal.
        if io::stdin().is_terminal() {
            command.stdin(Stdio::null());
        }
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        Ok(Self {
            child: command.spawn()?,
            printed,
            #[cfg(unix)]
            _until_it_has_ended: deferral,
        })
    }

    /// Collects what is printed until the program ends, or has to.
    fn finish(
        &mut self,
        limit: Duration,
        is_old: &mut dyn FnMut(&[u8]) -> bool,
    ) -> io::Result<End> {
        let start = Instant::now();
        let mut bytes = Vec::new();
        let mut ended = None;
        loop {
            stop_here_if_asked_to()?;
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
            if is_old(&bytes) {
                return Ok(End::Interrupted);
            }
        }
    }
}

fn stop_here_if_asked_to() -> io::Result<()> {
    #[cfg(unix)]
    signals::check()?;
    Ok(())
}

impl Drop for Group {
    fn drop(&mut self) {
        // Who has ended already can't be ended once more.
        #[cfg(unix)]
        let _ = rustix::process::kill_process_group(
            rustix::process::Pid::from_child(&self.child),
            rustix::process::Signal::KILL,
        );
        // Windows has no groups; this program of it knows who was started by whom.
        #[cfg(windows)]
        if matches!(self.child.try_wait(), Ok(None)) {
            let id = self.child.id().to_string();
            let _ = command(&["taskkill", "/f", "/t", "/pid", &id].map(OsString::from)).output();
        }
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Reads on a thread of its own: a read can't be told to give up.
fn pieces(mut output: PipeReader) -> io::Result<Receiver<io::Result<Vec<u8>>>> {
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
fn last_words(mut errors: PipeReader) -> io::Result<Receiver<String>> {
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
