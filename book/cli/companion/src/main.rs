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

use std::process::ExitCode;
use std::thread;

use launcher::command_line::{ArgumentTypes, Command, CommandLine};
use launcher::{book, chapter, limited, misuse, show, terminal};

/// The command line of the companion, which reads the arguments of all commands.
struct ReadArguments;

impl ArgumentTypes for ReadArguments {
    type Check = check::Arguments;
    type Start = start::Arguments;
    type Watch = watch::Arguments;
    type Laws = laws::Arguments;
    type Done = done::Arguments;
    type Hit = hit::Arguments;
    type Needs = needs::Arguments;
    type Probes = probes::Arguments;
}

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
    let done = match misuse::command_line::<CommandLine<ReadArguments>>().command {
        None => return misuse::exit_code_of(launcher::run_without_command()),
        Some(Command::Book(arguments)) => return misuse::exit_code_of(book::book(&arguments)),
        Some(Command::Show(arguments)) => show::show(&arguments),
        Some(Command::Check(arguments)) => return check::check(&arguments),
        Some(Command::Watch(arguments)) => return misuse::exit_code_of(watch::watch(&arguments)),
        Some(Command::Laws(arguments)) => return misuse::exit_code_of(laws::laws(&arguments)),
        Some(Command::Start(arguments)) => start::start(&arguments),
        Some(Command::Done(arguments)) => done::done(&arguments),
        Some(Command::Hit(arguments)) => hit::hit(&arguments),
        Some(Command::Needs(arguments)) => needs::needs(&arguments),
        Some(Command::Probes(arguments)) => probes::list(&arguments),
    };
    misuse::exit_code(done)
}
