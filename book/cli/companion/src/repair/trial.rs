//! The trial of a program with one edit after the other: its picture is compared while it comes,
//! and it is ended at the first wrong number.

use std::collections::BTreeSet;
use std::io::Read;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use common::rtweekend::Picture;
use edits::schemata;

use super::schema::{Built, WIDTH_VARIABLE};
use crate::subprocess::RunningProgram;

/// How long one run may take.
const PATIENCE: Duration = Duration::from_secs(2);
/// The time between two looks whether a run is still wanted.
const LOOK: Duration = Duration::from_millis(20);
/// How many programs run at once at most.
const AT_ONCE: usize = 4;
/// How many edits are tried at least, even after one is right, unless that takes long.
const MORE: usize = 200;
const MORE_TIME: Duration = Duration::from_secs(2);

/// How good a program is, best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Grade {
    /// The picture is right, and all laws hold.
    Lawful,
    /// The picture is right, and the laws hold that held before.
    Exact,
    /// Something is wrong.
    Wrong,
}

/// What programs are asked.
pub(super) struct Court<'a> {
    built: &'a Built,
    /// The empty folder in which they run.
    folder: &'a Path,
    /// The pictures that count as right.
    right: &'a RightPictures,
    /// The laws that held before, by their tests.
    held: BTreeSet<String>,
    /// True if the picture is right without any edit, so that the laws are asked first.
    is_hidden: bool,
    /// True once nobody wants to know any more.
    stop: &'a AtomicBool,
}

/// The pictures that count as right, as [`numbers`].
pub(crate) struct RightPictures {
    /// Those in the size that the program draws.
    pub(crate) whole: Vec<Vec<u32>>,
    /// Those that are [`SMALL`] pixels wide; empty if they are not known, or the program can't draw
    /// them.
    pub(crate) small: Vec<Vec<u32>>,
}

/// The width in pixels of the pictures that are compared first.
pub(crate) const SMALL: u32 = 64;

/// Returns the numbers of a picture in a P3 file.
pub(crate) fn numbers(picture: &Picture) -> Vec<u32> {
    let head = [picture.width(), picture.height(), 255];
    let levels = picture.rgb().iter().map(|it| u32::from(*it));
    head.into_iter().chain(levels).collect()
}

impl<'a> Court<'a> {
    /// Prepares to run a program in an empty folder, until `stop` is set.
    pub(super) fn new(
        built: &'a Built,
        folder: &'a Path,
        right: &'a RightPictures,
        stop: &'a AtomicBool,
    ) -> Self {
        let (held, is_hidden) = (BTreeSet::new(), false);
        Self {
            built,
            folder,
            right,
            held,
            is_hidden,
            stop,
        }
    }

    /// Runs the program as it is, and notes which laws hold. Returns true if nothing is wrong.
    pub(super) fn accepts_as_it_is(&mut self) -> bool {
        self.is_hidden = self.is_right(None);
        let (is_lawful, held) = self.obeyed(None).unwrap_or((true, BTreeSet::new()));
        self.held = held;
        self.is_hidden && is_lawful
    }

    /// Returns true if the picture of the program as it is is right.
    pub(super) fn is_hidden(&self) -> bool {
        self.is_hidden
    }

    /// Says how good the program is with an edit, by its number.
    pub(super) fn grade(&self, edit: u32) -> Grade {
        let judged = || {
            let Some(laws) = self.obeyed(Some(edit)) else {
                return Grade::Exact;
            };
            match laws {
                (true, _) => Grade::Lawful,
                (false, held) if !self.is_hidden && held.is_superset(&self.held) => Grade::Exact,
                _ => Grade::Wrong,
            }
        };
        if self.is_hidden {
            return match judged() {
                Grade::Lawful if self.is_right(Some(edit)) => Grade::Lawful,
                _ => Grade::Wrong,
            };
        }
        if self.is_right(Some(edit)) {
            judged()
        } else {
            Grade::Wrong
        }
    }

    /// Runs the program, and returns true if it prints a right picture and ends well: first a small
    /// one, if it can.
    fn is_right(&self, edit: Option<u32>) -> bool {
        let is_small_right = || self.is_printed(edit, Some(SMALL), &self.right.small);
        (self.right.small.is_empty() || is_small_right())
            && self.is_printed(edit, None, &self.right.whole)
    }

    fn is_printed(&self, edit: Option<u32>, width: Option<u32>, right: &[Vec<u32>]) -> bool {
        let right = right.to_vec();
        let mut command = limited(&self.built.program);
        command.arg("-").env_clear();
        command.envs(width.map(|it| (WIDTH_VARIABLE, it.to_string())));
        let run = self.run(command, edit, move |output| is_printed(output, &right));
        run.is_some_and(|(is_right, is_success)| is_right && is_success)
    }

    /// Runs the test of the laws. Returns whether all hold, and the names of those that do; `None`
    /// if there is none.
    fn obeyed(&self, edit: Option<u32>) -> Option<(bool, BTreeSet<String>)> {
        let laws = self.built.laws.as_ref()?;
        let mut command = limited(laws);
        command.arg("--test-threads=1").env_clear();
        let run = self.run(command, edit, |output| {
            let mut said = String::new();
            let _ = output.take(1 << 20).read_to_string(&mut said);
            let held = said
                .lines()
                .filter_map(|it| it.strip_prefix("test ")?.strip_suffix(" ... ok"));
            held.map(str::to_owned).collect()
        });
        run.map(|(held, is_success)| (is_success, held))
            .or(Some((false, BTreeSet::new())))
    }

    /// Runs a program in the empty folder, and has a thread read its output. Returns what that has
    /// read, and whether the program ended well; `None` if it took too long, or is not wanted.
    fn run<T: Send + 'static>(
        &self,
        mut command: Command,
        edit: Option<u32>,
        read: impl FnOnce(&mut dyn Read) -> T + Send + 'static,
    ) -> Option<(T, bool)> {
        command.current_dir(self.folder);
        // Nobody reads why a law is broken, or the case made smaller.
        command
            .env("RUST_BACKTRACE", "0")
            .env("PROPTEST_MAX_SHRINK_ITERS", "0");
        command.envs(edit.map(|it| (schemata::VARIABLE, it.to_string())));
        command
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::null());
        let mut running = RunningProgram::start(command).ok()?;
        let mut printed = running.printed.take()?;
        let (sender, result) = mpsc::channel();
        // A receiver that is gone misses nothing.
        thread::spawn(move || drop(sender.send(read(&mut printed))));
        let read = self.wait(&result)?;
        let is_success = loop {
            match running.exit_status().ok()? {
                Some(status) => break status.success(),
                None if self.stop.load(Relaxed) => return None,
                None => thread::sleep(Duration::from_micros(200)),
            }
        };
        Some((read, is_success))
    }

    fn wait<T>(&self, result: &Receiver<T>) -> Option<T> {
        let end = Instant::now() + PATIENCE;
        while Instant::now() < end && !self.stop.load(Relaxed) {
            match result.recv_timeout(LOOK) {
                Err(RecvTimeoutError::Timeout) => {}
                result => return result.ok(),
            }
        }
        None
    }

    /// Tries the edits in their order, several at once, until `wanted` of them are lawful, or the
    /// time is over. After the first, goes on for a while: there may be others. Returns the good
    /// ones, in their order, and the number of all that were tried.
    pub(super) fn try_all(&self, wanted: usize, end: Instant) -> (Vec<(usize, Grade)>, usize) {
        let (next, found) = (AtomicUsize::new(0), Mutex::new(Found::default()));
        let found_so_far = || found.lock().unwrap_or_else(PoisonError::into_inner);
        let work = || {
            while !self.stop.load(Relaxed)
                && Instant::now() < end
                && !found_so_far().is_enough(wanted)
            {
                let n = next.fetch_add(1, Relaxed);
                let Some((edit, number)) = self.built.numbers.get(n) else {
                    break;
                };
                let grade = self.grade(*number);
                found_so_far().add(n, *edit, grade);
            }
        };
        let at_once = thread::available_parallelism().map_or(1, |it| it.get().min(AT_ONCE));
        thread::scope(|scope| {
            for _ in 0..at_once {
                scope.spawn(work);
            }
        });
        let found = found.into_inner().unwrap_or_else(PoisonError::into_inner);
        let mut good = found.good;
        good.sort_unstable();
        let good = good.into_iter().map(|(grade, _, edit)| (edit, grade));
        (good.collect(), found.tried)
    }
}

/// The good edits so far.
#[derive(Default)]
struct Found {
    /// Of each its grade, its place in the order of trial, and the edit.
    good: Vec<(Grade, usize, usize)>,
    /// The number of edits that were tried.
    tried: usize,
    /// When the first lawful one was found, and how many had been tried.
    first: Option<(Instant, usize)>,
}

impl Found {
    fn add(&mut self, n: usize, edit: usize, grade: Grade) {
        self.tried += 1;
        if grade != Grade::Wrong {
            self.good.push((grade, n, edit));
        }
        if grade == Grade::Lawful {
            self.first.get_or_insert((Instant::now(), self.tried));
        }
    }

    /// Returns true once so many lawful ones are found, or as many were tried after the first as
    /// before, or that takes long.
    fn is_enough(&self, wanted: usize) -> bool {
        let lawful = self.good.iter().filter(|it| it.0 == Grade::Lawful).count();
        lawful >= wanted
            || self.first.is_some_and(|(at, tried)| {
                self.tried > (2 * tried).max(MORE) || at.elapsed() > MORE_TIME
            })
    }
}

/// Makes the command of a program that can't take much memory or time, nor write a byte to a file.
fn limited(program: &Path) -> Command {
    if !cfg!(unix) {
        return Command::new(program);
    }
    // The shell sets its own limits, and becomes the program. In KiB, blocks and seconds.
    const LIMITS: &str =
        "ulimit -v 4194304; ulimit -f 0; ulimit -c 0; ulimit -t 10; exec \"$0\" \"$@\"";
    let mut command = Command::new("/bin/sh");
    command.args(["-c", LIMITS]).arg(program);
    command
}

/// Reads a P3 picture while it is one of the right ones, and returns true if it is to its end.
fn is_printed(output: &mut dyn Read, right: &[Vec<u32>]) -> bool {
    let mut begin = [0; 2];
    if output.read_exact(&mut begin).is_err() || begin != *b"P3" {
        return false;
    }
    let mut right: Vec<&[u32]> = right.iter().map(Vec::as_slice).collect();
    let (mut number, mut count) = (None::<u32>, 0);
    let mut buffer = vec![0; 1 << 16];
    loop {
        // What ends the picture ends its last number.
        let size = output.read(&mut buffer).unwrap_or(0);
        let bytes = if size == 0 { b"\n" } else { &buffer[..size] };
        for &byte in bytes {
            match byte {
                b'0'..=b'9' => {
                    let digit = u32::from(byte - b'0');
                    number = Some(number.unwrap_or(0).saturating_mul(10).saturating_add(digit));
                }
                _ if byte.is_ascii_whitespace() => {
                    if let Some(number) = number.take() {
                        right.retain(|it| it.get(count) == Some(&number));
                        count += 1;
                    }
                }
                _ => return false,
            }
        }
        if size == 0 || right.is_empty() {
            return right.iter().any(|it| it.len() == count);
        }
    }
}
