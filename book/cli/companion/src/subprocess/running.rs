//! A program that runs, and a promise: it ends when this is dropped.

use std::io;
use std::process::{ChildStderr, ChildStdin, ChildStdout, Command, ExitStatus};

use super::{guard, tree};

/// A program that ends when this is dropped, with all that it has started.
pub(crate) struct RunningProgram {
    tree: tree::ProcessTree,
    /// True if it has the mark of a reader's program.
    is_marked: bool,
    /// Its input, output and errors, as far as they are piped.
    pub(crate) input: Option<ChildStdin>,
    pub(crate) printed: Option<ChildStdout>,
    pub(crate) errors: Option<ChildStderr>,
}

impl RunningProgram {
    /// Starts the program.
    ///
    /// # Errors
    /// If it does not start, or can't be guarded.
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

    /// Gives way to everything else that runs here.
    pub(crate) fn lower_priority(&self) {
        tree::lower_priority(self.tree.id());
    }

    /// Returns its status, if it has ended.
    ///
    /// # Errors
    /// If the system does not tell.
    pub(crate) fn exit_status(&mut self) -> io::Result<Option<ExitStatus>> {
        self.tree.try_wait()
    }

    /// Ends it, with all that it has started.
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
