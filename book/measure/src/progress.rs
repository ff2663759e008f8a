//! Progress: one line in the terminal that says how much is done.

use std::io::{self, IsTerminal, Write};
use std::sync::atomic::{AtomicUsize, Ordering};

/// So many steps, taken on any thread. The line is gone when this is dropped, and never
/// there where standard error is no terminal.
pub struct Progress {
    steps: usize,
    done: AtomicUsize,
    is_shown: bool,
}

impl Progress {
    /// Nothing is done yet.
    pub fn new(steps: usize) -> Self {
        Self {
            steps,
            done: AtomicUsize::new(0),
            is_shown: io::stderr().is_terminal(),
        }
    }

    /// One step more is done.
    pub fn step(&self) {
        let done = 1 + self.done.fetch_add(1, Ordering::Relaxed);
        let percent = |done: usize| 100 * done / self.steps.max(1);
        if percent(done) > percent(done - 1) {
            self.show(&format!("\r{:3} %", percent(done)));
        }
    }

    fn show(&self, line: &str) {
        if self.is_shown {
            // Nobody misses a line that cannot be written.
            let _ = io::stderr().write_all(line.as_bytes());
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.show("\r     \r");
    }
}
