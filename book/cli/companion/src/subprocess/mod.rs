//! A subprocess, with limits on time and bytes.
//!
//! Threads read what it prints and says, no more than there is a use for. It takes with it all
//! that it has started, however it ends, and however this program ends.

pub(crate) mod guard;
mod running;
#[cfg_attr(windows, path = "tree_windows.rs")]
#[cfg_attr(not(windows), path = "tree_unix.rs")]
mod tree;

use std::ffi::OsString;
use std::io::{self, IsTerminal, Read};
use std::process::{ChildStderr, Command, ExitStatus, Stdio};
use std::sync::mpsc::{self, Receiver, TryRecvError};
use std::thread;
use std::time::{Duration, Instant};

use check::names;
use check::reading::{Cause, MOST_BYTES};

use crate::misuse::complain;

pub(crate) use running::RunningProgram;

/// Runs a program and returns all that it prints, [limited](read_picture_bytes).
///
/// # Errors
/// If the program does not start, fails, or takes longer than `limit`.
pub(crate) fn output_of(words: &[OsString], limit: Duration) -> Result<Vec<u8>, Cause> {
    let ran = run(reader_command(words), limit, show_errors, &mut || false);
    printed_or_cause(words, ran.map(|(end, _)| end), limit)
}

/// Returns what the program printed before it came to this end.
///
/// # Errors
/// If that is no good end, or the program did not start.
pub(crate) fn printed_or_cause(
    words: &[OsString],
    end: io::Result<ProgramEnd>,
    limit: Duration,
) -> Result<Vec<u8>, Cause> {
    let name = names::escaped_name(&words[0]);
    let (problem, fix) = match end {
        Ok(ProgramEnd::Itself(status, bytes)) if status.success() => return Ok(bytes),
        Ok(ProgramEnd::Full(bytes)) => return Ok(bytes),
        Ok(ProgramEnd::Itself(status, _)) => (
            format!("{name} ended with {status}"),
            "A program that draws a picture ends with 0. Read what it says above.",
        ),
        Ok(ProgramEnd::TooSlow) => (
            format!("{name} did not end within {limit:?}"),
            "Does a loop end? If the program is only slow: a smaller picture, or --timeout SECONDS.",
        ),
        Ok(ProgramEnd::Interrupted) => unreachable!("nothing is newer"),
        Err(cause) => (
            format!("{name} does not start: {cause}"),
            "Is it built, and is its path right? A program in this folder is ./NAME.",
        ),
    };
    Err(Cause::new("program-failed", problem, fix))
}

/// Makes the command of a reader's program, with the mark by which all that it starts is found.
pub(crate) fn reader_command(words: &[OsString]) -> Command {
    let mut command = Command::new(&words[0]);
    command.args(&words[1..]).env(guard::MARK, guard::mark());
    command
}

/// How a program came to its end.
pub(crate) enum ProgramEnd {
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

/// How long the last that a program has printed may be on its way.
const FAREWELL: Duration = Duration::from_secs(1);

/// Runs the program until it ends, has to, or `is_old` says that it is no longer wanted. Returns
/// how it ended, and what `listen` returned, which reads its standard error.
///
/// # Errors
/// If the program does not start.
pub(crate) fn run(
    mut command: Command,
    limit: Duration,
    listen: impl FnOnce(ChildStderr) -> String + Send + 'static,
    is_old: &mut dyn FnMut() -> bool,
) -> io::Result<(ProgramEnd, String)> {
    // The terminal is ours: a program that is run again and again reads none of it.
    if io::stdin().is_terminal() {
        command.stdin(Stdio::null());
    }
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut running = RunningProgram::start(&mut command)?;
    let piped = "it is piped";
    let printed = running.printed.take().expect(piped);
    let printed = in_a_thread(move || read_picture_bytes(printed));
    let errors = running.errors.take().expect(piped);
    let said = in_a_thread(move || listen(errors));
    let end = finish(&mut running, &printed, limit, is_old)?;
    drop(running);
    Ok((end, said.recv_timeout(FAREWELL).unwrap_or_default()))
}

/// Waits until the program ends, or has to.
fn finish(
    running: &mut RunningProgram,
    printed: &Receiver<io::Result<Vec<u8>>>,
    limit: Duration,
    is_old: &mut dyn FnMut() -> bool,
) -> io::Result<ProgramEnd> {
    let start = Instant::now();
    let mut whole = None;
    loop {
        let ended = running.exit_status()?;
        match printed.try_recv() {
            Ok(bytes) if bytes.as_ref().is_ok_and(|it| it.len() > MOST_BYTES) => {
                return Ok(ProgramEnd::Full(bytes?));
            }
            Ok(bytes) => whole = Some(bytes?),
            Err(TryRecvError::Empty | TryRecvError::Disconnected) => {}
        }
        if let Some(status) = ended {
            running.kill();
            let last = || printed.recv_timeout(FAREWELL);
            let open = |_| io::Error::other("what it has started keeps its output open");
            let bytes = whole.map_or_else(|| last().map_err(open)?, Ok)?;
            return Ok(ProgramEnd::Itself(status, bytes));
        }
        if start.elapsed() > limit {
            return Ok(ProgramEnd::TooSlow);
        }
        if is_old() {
            return Ok(ProgramEnd::Interrupted);
        }
        thread::sleep(TICK);
    }
}

/// Starts a thread, whose result can be received once.
pub(crate) fn in_a_thread<T: Send + 'static>(
    work: impl FnOnce() -> T + Send + 'static,
) -> Receiver<T> {
    let (sender, result) = mpsc::channel();
    // A receiver that is gone misses nothing.
    thread::spawn(move || drop(sender.send(work())));
    result
}

/// Reads to the end, or one byte more than a picture may have, so that the reading of pictures can
/// say so; a program that prints more can't go on.
///
/// # Errors
/// If it can't be read.
pub(crate) fn read_picture_bytes(input: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    input.take(MOST_BYTES as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Shows what a program says as it comes, up to a megabyte, and reads the rest.
pub(crate) fn show_errors(mut errors: ChildStderr) -> String {
    const MOST: u64 = 1 << 20;
    let copied = io::copy(&mut (&mut errors).take(MOST), &mut io::stderr());
    if copied.is_ok_and(|length| length == MOST) {
        complain("rtrace: … it says more, which is not shown");
    }
    // It need not notice that nothing is shown any more.
    let _ = io::copy(&mut errors, &mut io::sink());
    String::new()
}

/// Keeps the last of what a program says.
pub(crate) fn last_errors(mut errors: ChildStderr) -> String {
    const KEPT: usize = 1 << 14;
    let mut said = Vec::new();
    let mut piece = [0; KEPT];
    while let Ok(length @ 1..) = errors.read(&mut piece) {
        said.extend(&piece[..length]);
        said.drain(..said.len().saturating_sub(KEPT));
    }
    String::from_utf8_lossy(&said).into_owned()
}
