//! Job objects: a job ends with all that its first process has started.

use std::io;
use std::mem;
use std::process::{ChildStderr, ChildStdin, ChildStdout, Command, Stdio};

use process_wrap::std::{ChildWrapper, CommandWrap, JobObject};

/// A program and all that it starts: a job object.
pub(super) type ProcessTree = Box<dyn ChildWrapper>;

/// Starts a program in a new job.
pub(super) fn spawn(command: &mut Command) -> io::Result<ProcessTree> {
    let command = mem::replace(command, Command::new(""));
    CommandWrap::from(command).wrap(JobObject).spawn()
}

/// Takes the pipes of the program's input, output and errors, as far as they are piped.
pub(super) fn take_pipes(
    tree: &mut ProcessTree,
) -> (Option<ChildStdin>, Option<ChildStdout>, Option<ChildStderr>) {
    (
        tree.stdin().take(),
        tree.stdout().take(),
        tree.stderr().take(),
    )
}

/// Ends all processes of the job.
pub(super) fn kill(tree: &mut ProcessTree) {
    // What has ended already can't be ended once more.
    let _ = tree.kill();
}

/// Ends the process and those that it has started, as far as their parents still run. The job
/// itself is ended by its handle, which the guard does not have.
pub(super) fn kill_group(leader: u32) {
    let leader = leader.to_string();
    let mut kill = Command::new("taskkill");
    kill.args(["/T", "/F", "/PID", &leader])
        .stdin(Stdio::null());
    let _ = kill.stdout(Stdio::null()).stderr(Stdio::null()).status();
}

/// Does nothing: a job runs as other programs do.
pub(super) fn lower_priority(_leader: u32) {}

/// Does nothing: whatever starts in a job stays in it.
pub(super) fn kill_marked(_mark: &str) {}
