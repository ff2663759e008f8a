//! Process groups, and jobs of Windows: a running program ends, with all that it has started, when
//! its value is dropped.

use std::io;
use std::process::{ChildStderr, ChildStdin, ChildStdout, Command, ExitStatus};

use process_wrap::std::{ChildWrapper, CommandWrap};

use super::guard;

/// A running program. Dropping this ends it, with all that it has started.
pub(crate) struct RunningProgram {
    program: Box<dyn ChildWrapper>,
    /// True if the environment has the mark of a reader's program.
    is_marked: bool,
    /// The pipe to its standard input; `None` if that is not piped, or was taken.
    pub(crate) input: Option<ChildStdin>,
    /// The pipe from its standard output; `None` if that is not piped, or was taken.
    pub(crate) printed: Option<ChildStdout>,
    /// The pipe from its standard error; `None` if that is not piped, or was taken.
    pub(crate) errors: Option<ChildStderr>,
}

impl RunningProgram {
    /// Starts a program, which the guard ends if this process ends first.
    pub(crate) fn start(command: Command) -> io::Result<Self> {
        guard::ensure_started()?;
        let is_marked = command.get_envs().any(|(name, _)| name == guard::MARK);
        let mut program = in_group(command)?;
        guard::tell(&program.id().to_string());
        Ok(Self {
            is_marked,
            input: program.stdin().take(),
            printed: program.stdout().take(),
            errors: program.stderr().take(),
            program,
        })
    }

    /// Has the program run at the lowest priority, with all that it starts; does nothing on
    /// Windows.
    pub(crate) fn lower_priority(&self) {
        #[cfg(unix)]
        {
            const LAST: i32 = 19;
            let _ = rustix::process::setpriority_pgrp(pid(self.program.id()), LAST);
        }
    }

    /// Returns the program's exit status; `None` if it still runs.
    pub(crate) fn exit_status(&mut self) -> io::Result<Option<ExitStatus>> {
        self.program.try_wait()
    }

    /// Ends the program, with all that it has started, and waits for its end.
    pub(crate) fn kill(&mut self) {
        // What has ended already can't be ended once more.
        let _ = self.program.start_kill();
        let _ = self.program.wait();
        if self.is_marked {
            guard::kill_marked(guard::mark());
        }
        guard::tell(&format!("-{}", self.program.id()));
    }
}

impl Drop for RunningProgram {
    fn drop(&mut self) {
        self.kill();
    }
}

/// Starts a program as the first of a new process group, or in a new job.
pub(super) fn in_group(command: Command) -> io::Result<Box<dyn ChildWrapper>> {
    let mut command = CommandWrap::from(command);
    #[cfg(unix)]
    command.wrap(process_wrap::std::ProcessGroup::leader());
    #[cfg(windows)]
    command.wrap(process_wrap::std::JobObject);
    command.spawn()
}

/// Ends the process group with this leader.
#[cfg(unix)]
pub(super) fn kill_group(leader: u32) {
    use rustix::process::{Signal, kill_process_group};
    let _ = pid(leader).map(|group| kill_process_group(group, Signal::KILL));
}

/// Ends the process and those that it has started, as far as their parents still run. The job
/// itself is ended by its handle, which only the process has that started it.
#[cfg(windows)]
pub(super) fn kill_group(leader: u32) {
    let mut kill = Command::new("taskkill");
    kill.args(["/T", "/F", "/PID", &leader.to_string()]);
    let _ = kill.stdin(std::process::Stdio::null()).output();
}

#[cfg(unix)]
pub(super) fn pid(number: u32) -> Option<rustix::process::Pid> {
    rustix::process::Pid::from_raw(number.try_into().ok()?)
}
