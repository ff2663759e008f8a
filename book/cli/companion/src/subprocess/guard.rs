//! A watchdog: a second process of this program, which ends what was started when the first
//! one is gone.
//!
//! It reads from a pipe that the first one holds open. Whatever ends that, a signal, a panic or
//! the closed terminal, the system closes the pipe, and so no signal need be caught.

use std::collections::BTreeSet;
use std::env;
use std::hash::{BuildHasher, Hasher, RandomState};
use std::io::{self, Write, stdin};
use std::path::Path;
use std::process::{self, ChildStdin, Command, Stdio};
use std::sync::{LazyLock, Mutex, PoisonError};

use super::tree;

/// The environment variable that marks a reader's program and all that it starts.
pub(crate) const MARK: &str = "RTRACE_STARTED_BY";

/// The environment variable that makes a process the guard of programs with this mark.
const GUARDS: &str = "RTRACE_GUARDS";

/// Returns the mark of this process, which no other run of this program has.
pub(crate) fn mark() -> &'static str {
    static MARKED: LazyLock<String> = LazyLock::new(|| {
        // The standard library asks the system for a random number to seed its hash tables.
        let number = RandomState::new().build_hasher().finish();
        format!("{}.{number:016x}", process::id())
    });
    &MARKED
}

/// The pipe that the guard reads; `None` before it is started.
static PIPE: Mutex<Option<ChildStdin>> = Mutex::new(None);

/// Starts the guard, a second process of this program, unless it runs already.
///
/// # Errors
/// If the guard does not start.
pub(super) fn ensure_started() -> io::Result<()> {
    let mut pipe = PIPE.lock().unwrap_or_else(PoisonError::into_inner);
    if pipe.is_none() {
        let own = env::current_exe()?;
        // Also if cargo has replaced that file since.
        let running = Path::new("/proc/self/exe");
        let mut guard = Command::new(if running.exists() { running } else { &own });
        guard.env(GUARDS, mark()).env_remove(MARK);
        guard.stdin(Stdio::piped());
        guard.stdout(Stdio::null()).stderr(Stdio::null());
        (*pipe, ..) = tree::take_pipes(&mut tree::spawn(&mut guard)?);
    }
    Ok(())
}

/// Tells the guard the number of a process that it has to end if this one ends.
pub(super) fn add(program: u32) {
    tell(&format!("{program}\n"));
}

/// Tells the guard that the process with this number has ended, and all that it had started.
pub(super) fn remove(program: u32) {
    tell(&format!("-{program}\n"));
}

fn tell(line: &str) {
    let mut pipe = PIPE.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(pipe) = &mut *pipe {
        // Without a guard there is nobody to tell.
        let _ = pipe.write_all(line.as_bytes());
    }
}

/// Returns false at once if this process is not to guard. Else waits until the process that started
/// it is gone, ends all that it left, and returns true.
pub(crate) fn run_if_guard() -> bool {
    let Ok(mark) = env::var(GUARDS) else {
        return false;
    };
    let mut programs = BTreeSet::new();
    for line in stdin().lines().map_while(Result::ok) {
        match line.strip_prefix('-') {
            Some(ended) => drop(programs.remove(ended)),
            None => drop(programs.insert(line)),
        }
    }
    let left = programs.iter().filter_map(|it| it.parse().ok());
    left.for_each(tree::kill_group);
    tree::kill_marked(&mark);
    true
}
