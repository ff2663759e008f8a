//! `rtrace`: the reader's companion.

mod check;
mod done;
mod hit;
mod laws;
mod needs;
mod probes;
mod reader_crates;
mod sources;
mod start;
mod subprocess;
mod watch;
mod wrap;

use std::env;
use std::error::Error;
use std::process::ExitCode;
use std::thread;

use launcher::command_line::{self, Request, Words};
use launcher::{chapter, limited, misuse, output, terminal};

/// The size of the stack in bytes: reading and running a reader's text recurse for each level of
/// it. Only the part that is used takes memory.
const STACK: usize = 1 << 26;

fn main() -> ExitCode {
    if subprocess::guard::run_if_guard() {
        return ExitCode::SUCCESS;
    }
    let named = thread::Builder::new().stack_size(STACK);
    let ended = named.spawn(run).map(thread::JoinHandle::join);
    // What panics has said so.
    ended.map_or_else(|_| run(), |code| code.unwrap_or(ExitCode::from(101)))
}

fn run() -> ExitCode {
    let request = Request::read(env::args_os().skip(1));
    match request.map(launcher::run_own) {
        Ok(Ok(done)) => misuse::exit_code_of(done),
        Ok(Err(words)) if words.command.name() == "check" => check::check(&words),
        Ok(Err(words)) => misuse::exit_code_of(run_command(&words)),
        Err(error) => misuse::exit_code(Err(error)),
    }
}

/// Runs a command that the launcher has handed on.
fn run_command(words: &Words) -> Result<ExitCode, Box<dyn Error>> {
    match words.command.name() {
        "watch" => return watch::watch(&watch::Arguments::read(words)?),
        "laws" => return laws::laws(&laws::Arguments::read(words)?),
        "start" => start::start(&start::Arguments::read(words)?)?,
        "done" => done::done(&done::Arguments::read(words)?)?,
        "hit" => hit::hit(&hit::Arguments::read(words)?)?,
        "needs" => needs::needs(&needs::Arguments::read(words)?)?,
        "probes" => probes::list(words)?,
        name => unreachable!("the command {name} is the launcher's own"),
    }
    Ok(ExitCode::SUCCESS)
}
