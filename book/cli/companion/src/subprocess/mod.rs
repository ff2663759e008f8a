//! A subprocess, with limits on time and bytes.
//!
//! Threads read what it prints and says, no more than there is a use for. It takes with it all
//! that it has started, however it ends, and however this program ends.

pub(crate) mod guard;
mod running;

use std::ffi::OsString;
use std::io::{self, IsTerminal, Read, Write};
use std::process::{ChildStderr, Command, ExitStatus, Stdio};
use std::sync::mpsc::{self, Receiver, TryRecvError};
use std::thread;
use std::time::{Duration, Instant};

use check::names;
use check::reading::{Cause, MOST_BYTES};

use crate::misuse::complain;

pub(crate) use running::RunningProgram;

/// Runs a program to its end and returns all that it prints to standard output, up to one byte more
/// than a picture may have. Shows its standard error as it comes.
pub(crate) fn output_of(words: &[OsString], limit: Duration) -> Result<Vec<u8>, Cause> {
    let ran = run(reader_command(words), limit, show_errors, &mut || false);
    let name = names::escaped_name(&words[0]);
    printed_or_cause(&name, ran.map(|(end, _)| end), limit)
}

/// Returns the standard output of the program `name` that has ended well, or that printed too much
/// for a picture.
pub(crate) fn printed_or_cause(
    name: &str,
    end: io::Result<ProgramEnd>,
    limit: Duration,
) -> Result<Vec<u8>, Cause> {
    let (problem, fix) = match end {
        Ok(ProgramEnd::Itself(status, bytes)) if status.success() => return Ok(bytes),
        Ok(ProgramEnd::Full(bytes)) => return Ok(bytes),
        Ok(ProgramEnd::Itself(status, _)) => (
            format!("{name} ended with {status}"),
            "A program that draws a picture ends with 0. Read what it says above.",
        ),
        Ok(ProgramEnd::TooSlow) => (
            format!("{name} did not end within {limit:?}"),
            "Does every loop end? If the program is only slow, draw a smaller picture, or give it more time: --timeout SECONDS.",
        ),
        Ok(ProgramEnd::Interrupted) => unreachable!("nothing is newer"),
        Err(cause) => (
            format!("{name} does not start: {cause}"),
            "Is the program built, and is its path right? A program in this folder is ./NAME.",
        ),
    };
    Err(Cause::new("program-failed", problem, fix))
}

/// Makes the command of a reader's program, given by its name and its arguments. All that the
/// program starts can be found by a mark in its environment.
pub(crate) fn reader_command(words: &[OsString]) -> Command {
    let mut command = Command::new(&words[0]);
    command.args(&words[1..]).env(guard::MARK, guard::mark());
    command
}

/// The way in which a program ended.
pub(crate) enum ProgramEnd {
    /// An end of its own, with its status and its standard output.
    Itself(ExitStatus, Vec<u8>),
    /// An end by us, since it printed more than any picture has; this is the beginning.
    Full(Vec<u8>),
    /// An end by us after the time limit.
    TooSlow,
    /// An end by us, since its result was no longer wanted.
    Interrupted,
}

/// The time between two looks whether a program has ended.
const TICK: Duration = Duration::from_millis(5);

/// The time to wait for what an ended program has printed last.
const FAREWELL: Duration = Duration::from_secs(1);

/// Runs a program until it ends, takes longer than `limit`, prints too much, or `is_old` returns
/// true: then its result is no longer wanted. A thread calls `listen` with its standard error.
/// Returns how the program ended, and what `listen` returned, or an empty text if that takes too
/// long.
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
    let mut running = RunningProgram::start(command)?;
    let piped = "it is piped";
    let printed = running.printed.take().expect(piped);
    let printed = in_a_thread(move || read_picture_bytes(printed));
    let errors = running.errors.take().expect(piped);
    let said = in_a_thread(move || listen(errors));
    let end = finish(&mut running, &printed, limit, is_old)?;
    drop(running);
    Ok((end, said.recv_timeout(FAREWELL).unwrap_or_default()))
}

/// Waits until the program ends by itself, or ends it.
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
            let open = |_| {
                io::Error::other("a process that the program has started keeps the output open")
            };
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

/// Does `work` in a new thread, and returns the channel that its result comes through, once.
pub(crate) fn in_a_thread<T: Send + 'static>(
    work: impl FnOnce() -> T + Send + 'static,
) -> Receiver<T> {
    let (sender, result) = mpsc::channel();
    // A receiver that is gone misses nothing.
    thread::spawn(move || drop(sender.send(work())));
    result
}

/// Reads to the end, but at most one byte more than a picture may have, so that the parser can
/// refuse it.
pub(crate) fn read_picture_bytes(input: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    input.take(MOST_BYTES as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Copies a program's standard error to ours as it comes, up to a megabyte, and drops the rest. Ends
/// the last line, which may be one of a progress that is written over and over. Returns an empty
/// text.
pub(crate) fn show_errors(mut errors: ChildStderr) -> String {
    const MOST: usize = 1 << 20;
    let mut piece = [0; 1 << 12];
    let (mut shown, mut last, mut says_more) = (0, b'\n', false);
    while let Ok(length @ 1..) = errors.read(&mut piece) {
        // It need not notice that nothing is shown any more.
        says_more |= shown >= MOST;
        if !says_more {
            let _ = io::stderr().write_all(&piece[..length]);
            (shown, last) = (shown + length, piece[length - 1]);
        }
    }
    if last != b'\n' {
        let _ = writeln!(io::stderr());
    }
    if says_more {
        complain("rtrace: … the program says more, which is not shown");
    }
    String::new()
}

/// Reads a program's standard error to its end, and returns the last 16 KiB, with � for what is not
/// UTF-8.
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
