//! Process groups: a signal to a group reaches all that its leader has started.
//!
//! What has left the group, as `setsid` does, is found on Linux by a mark in its environment,
//! which is handed on to whatever starts. Build servers end what they have started like that.

use std::fs;
use std::io;
use std::os::unix::process::CommandExt;
use std::process::{ChildStderr, ChildStdin, ChildStdout, Command};
use std::thread;
use std::time::Duration;

use rustix::process::{Pid, Signal, kill_process, kill_process_group, setpriority_pgrp};

/// A program and all that it starts: the leader of a process group.
pub(super) use std::process::Child as ProcessTree;

/// Starts a program as the leader of a new process group.
pub(super) fn spawn(command: &mut Command) -> io::Result<ProcessTree> {
    command.process_group(0).spawn()
}

/// Takes the pipes of the program's input, output and errors, as far as they are piped.
pub(super) fn take_pipes(
    tree: &mut ProcessTree,
) -> (Option<ChildStdin>, Option<ChildStdout>, Option<ChildStderr>) {
    (tree.stdin.take(), tree.stdout.take(), tree.stderr.take())
}

/// Ends the program and its group, and waits for the program's end.
pub(super) fn kill(tree: &mut ProcessTree) {
    kill_group(tree.id());
    let _ = tree.wait();
}

/// Ends the process group with this leader.
pub(super) fn kill_group(leader: u32) {
    if let Some(group) = pid(leader) {
        let _ = kill_process_group(group, Signal::KILL);
    }
}

/// Gives the process group with this leader the lowest priority.
pub(super) fn lower_priority(leader: u32) {
    const LAST: i32 = 19;
    let _ = setpriority_pgrp(pid(leader), LAST);
}

/// Ends all processes with this mark in their environment, also those that they start meanwhile.
pub(super) fn kill_marked(mark: &str) {
    const ROUNDS: usize = 200;
    let mark = format!("{}={mark}", super::guard::MARK);
    for _ in 0..ROUNDS {
        let marked: Vec<Pid> = processes().filter(|it| has(*it, mark.as_bytes())).collect();
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

/// Lists all processes, on systems that show them as folders.
fn processes() -> impl Iterator<Item = Pid> {
    let entries = fs::read_dir("/proc").into_iter().flatten().flatten();
    entries.filter_map(|entry| pid(entry.file_name().to_str()?.parse().ok()?))
}

/// Returns true if the process began with `mark` in its environment; false if it has ended.
fn has(process: Pid, mark: &[u8]) -> bool {
    let environment = fs::read(format!("/proc/{}/environ", process.as_raw_nonzero()));
    environment.is_ok_and(|it| it.split(|&byte| byte == 0).any(|it| it == mark))
}

fn pid(number: u32) -> Option<Pid> {
    Pid::from_raw(number.try_into().ok()?)
}
