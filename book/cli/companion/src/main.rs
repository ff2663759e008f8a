//! `rtrace`: the reader's companion.

mod check;
mod done;
mod laws;
mod reader_crates;
mod repair;
mod sources;
mod start;
mod subprocess;
mod watch;
mod wrap;

use std::error::Error;
use std::process::ExitCode;
use std::thread;

use launcher::command_line::{self, Words};
use launcher::{limited, misuse, output, terminal};

/// The size of the stack in bytes: reading and running a reader's text recurse for each level of
/// it. Only the part that is used takes memory.
const STACK: usize = 1 << 26;

fn main() -> ExitCode {
    if subprocess::guard::run_if_guard() {
        return ExitCode::SUCCESS;
    }
    let run = || launcher::main(run_command);
    let named = thread::Builder::new().stack_size(STACK);
    let ended = named.spawn(run).map(thread::JoinHandle::join);
    // What panics has said so.
    ended.map_or_else(|_| run(), |code| code.unwrap_or(ExitCode::from(101)))
}

/// Runs a command that the launcher has handed on, and prints what it says.
fn run_command(words: &Words) -> Result<ExitCode, Box<dyn Error>> {
    let (code, said) = match words.command.name() {
        "watch" => return watch::watch(words),
        "check" => check::check(words)?,
        "laws" => laws::laws(words)?,
        "start" => (0, start::start(words)?),
        "done" => (0, done::done(words)?),
        _ => return launcher::cargo::hand_on(words),
    };
    output::print(&said)?;
    Ok(ExitCode::from(code))
}
