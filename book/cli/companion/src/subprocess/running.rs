//! Resource ownership: a running program ends when its value is dropped.

use std::io;
use std::process::{ChildStderr, ChildStdin, ChildStdout, Command, ExitStatus};

use super::{guard, tree};

/// A running program. Dropping this ends it, with all that it has started.
pub(crate) struct RunningProgram {
    tree: tree::ProcessTree,
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
    ///
    /// # Errors
    /// If the program or the guard does not start.
    pub(crate) fn start(command: &mut Command) -> io::Result<Self> {
        guard::ensure_started()?;
        let is_marked = command.get_envs().any(|(name, _)| name == guard::MARK);
        let mut tree = tree::spawn(command)?;
        guard::add(tree.id());
        let (input, printed, errors) = tree::take_pipes(&mut tree);
        Ok(Self {
            tree,
            is_marked,
            input,
            printed,
            errors,
        })
    }

    /// Has the program run at the lowest priority, with all that it starts.
    pub(crate) fn lower_priority(&self) {
        tree::lower_priority(self.tree.id());
    }

    /// Returns the program's exit status; `None` if it still runs.
    ///
    /// # Errors
    /// If the system does not know the program.
    pub(crate) fn exit_status(&mut self) -> io::Result<Option<ExitStatus>> {
        self.tree.try_wait()
    }

    /// Ends the program, with all that it has started, and waits for its end.
    pub(crate) fn kill(&mut self) {
        tree::kill(&mut self.tree);
        if self.is_marked {
            tree::kill_marked(guard::mark());
        }
        guard::remove(self.tree.id());
    }
}

impl Drop for RunningProgram {
    fn drop(&mut self) {
        self.kill();
    }
}
