//! A watchdog: a second process of this program, which ends what was started when the first
//! one is gone.
//!
//! It reads from a pipe that the first one holds open. Whatever ends that, a signal, a panic or
//! the closed terminal, the system closes the pipe, and so no signal need be caught. What has left
//! its process group, as build servers do, is found on Linux by a mark in its environment, which is
//! handed on to whatever starts.

use std::collections::BTreeSet;
use std::env;
use std::io::{self, Write, stdin};
use std::path::Path;
use std::process::{self, ChildStdin, Command, Stdio};
use std::sync::{LazyLock, Mutex, PoisonError};
#[cfg(unix)]
use std::{fs, thread, time::Duration};

#[cfg(unix)]
use rustix::process::{Pid, Signal, kill_process};

#[cfg(unix)]
use super::running::pid;
use super::running::{in_group, kill_group};
use crate::output;

/// The environment variable that marks a reader's program and all that it starts.
pub(crate) const MARK: &str = "RTRACE_STARTED_BY";

/// The environment variable that makes a process the guard of programs with this mark.
const GUARDS: &str = "RTRACE_GUARDS";

/// Returns the mark of this process, which no other run of this program has.
pub(crate) fn mark() -> &'static str {
    static MARKED: LazyLock<String> =
        LazyLock::new(|| format!("{}.{:016x}", process::id(), output::random()));
    &MARKED
}

/// The pipe that the guard reads; `None` before it is started.
static PIPE: Mutex<Option<ChildStdin>> = Mutex::new(None);

/// Starts the guard, a second process of this program, unless it runs already.
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
        *pipe = in_group(guard)?.stdin().take();
    }
    Ok(())
}

/// Tells the guard the number of a process that it has to end if this one ends; with a `-` before
/// it, that the process has ended, and all that it had started.
pub(super) fn tell(line: &str) {
    let mut pipe = PIPE.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(pipe) = &mut *pipe {
        // Without a guard there is nobody to tell.
        let _ = writeln!(pipe, "{line}");
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
    left.for_each(kill_group);
    kill_marked(&mark);
    true
}

/// Ends all processes with this mark in their environment, also those that they start meanwhile,
/// on systems that show processes as folders.
#[cfg(unix)]
pub(super) fn kill_marked(mark: &str) {
    const ROUNDS: usize = 200;
    let mark = format!("{MARK}={mark}");
    let is_marked = |process: &Pid| {
        let environment = fs::read(format!("/proc/{}/environ", process.as_raw_nonzero()));
        environment.is_ok_and(|it| it.split(|&byte| byte == 0).any(|it| it == mark.as_bytes()))
    };
    for _ in 0..ROUNDS {
        let all = fs::read_dir("/proc").into_iter().flatten().flatten();
        let all = all.filter_map(|entry| pid(entry.file_name().to_str()?.parse().ok()?));
        let marked: Vec<Pid> = all.filter(is_marked).collect();
        if marked.is_empty() {
            break;
        }
        for process in marked {
            // It may have ended meanwhile.
            let _ = kill_process(process, Signal::KILL);
        }
        thread::sleep(Duration::from_millis(1));
    }
}

/// Does nothing: whatever starts in a job stays in it.
#[cfg(windows)]
pub(super) fn kill_marked(_mark: &str) {}
