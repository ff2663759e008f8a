//! A background build: while a reader types, cargo builds the laws at the lowest priority.
//!
//! It stops for each save, since cargo builds one thing at a time in a folder, and goes on from
//! there. So a reader who has typed for some minutes does not wait for the laws.

use std::io::BufReader;
use std::path::Path;
use std::process::Stdio;
use std::thread;

use launcher::cargo;

use super::build;
use crate::misuse::complain;
use crate::subprocess::RunningProgram;

const MEANWHILE: &str = "Meanwhile, the laws are built, which test your functions: about a minute, once, and no save waits";

/// A cargo in the background that builds all dependencies of a reader's tests.
#[derive(Default)]
pub(super) struct BackgroundBuild {
    running: Option<RunningProgram>,
    /// True if all is built that can be.
    is_done: bool,
}

impl BackgroundBuild {
    /// Starts cargo for the crate in `folder`, unless all is built. Cargo goes on where it was
    /// stopped.
    pub(super) fn go_on(&mut self, folder: &Path) {
        if self.is_done {
            return;
        }
        // What the crate lacks to be compiled keeps nothing else from it.
        let mut cargo = build::cargo_command(folder, &["build", "--tests", "--keep-going"]);
        cargo.stdout(Stdio::null()).stderr(Stdio::piped());
        // Without it, the laws are built when they are asked.
        self.running = RunningProgram::start(cargo).ok();
        if let Some(running) = &mut self.running {
            running.lower_priority();
            let errors = running.errors.take().expect("it is piped");
            let say = |_: &str, is_first| {
                if is_first {
                    complain(MEANWHILE);
                }
            };
            thread::spawn(move || cargo::listen_for_work(BufReader::new(errors), say));
        }
    }

    /// Returns true if the cargo that was started last has ended by itself; false while it runs, is
    /// stopped, or was not started.
    pub(super) fn has_ended(&mut self) -> bool {
        let ended = |it: &mut RunningProgram| it.exit_status().ok().flatten().is_some();
        let has_ended = self.running.as_mut().is_some_and(ended);
        self.is_done |= has_ended;
        has_ended
    }

    /// Stops cargo at once.
    pub(super) fn pause(&mut self) {
        self.has_ended();
        self.running = None;
    }

    /// Returns true if all is built that can be.
    pub(super) fn is_done(&self) -> bool {
        self.is_done
    }
}
