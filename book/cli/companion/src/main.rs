//! `rtrace`: the reader's companion.

mod check;
mod done;
mod hit;
mod laws;
mod mine;
mod needs;
mod probes;
mod sources;
mod start;
mod subprocess;
mod watch;
mod wrap;

use std::process::ExitCode;

use ::check::names::companion;
use clap::{Parser, Subcommand};
use rtrace::{chapter, files, misuse, terminal};

/// The pictures of Ray Tracing in One Weekend, chapter by chapter.
///
/// Without a command: draws all of them into target/pictures, as PNG and as
/// PPM files, and weaves the book into target/book.
#[derive(Parser)]
#[command(name = "rtrace", bin_name = companion())]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Subcommand)]
enum Command {
    #[command(flatten)]
    Pictures(rtrace::Command),
    /// Check your own picture, and learn which mistake draws it
    Check(check::Arguments),
    /// Make a crate of your own for a chapter, ready to be typed into
    Start(start::Arguments),
    /// Judge your crate or program whenever you save it
    Watch(watch::Arguments),
    /// Put a function of any program, in any language, under the laws
    Laws(laws::Arguments),
    /// Show the list of what you have done, or add a line to it
    Done(done::Arguments),
    /// Look at one ray and one sphere through every method of chapter 6
    Hit(hit::Arguments),
    /// Find the least that a scene of your own needs, of all methods of chapter 6
    Needs(needs::Arguments),
    /// List the small scenes that show what the book's picture can't
    Probes(probes::Arguments),
}

fn main() -> ExitCode {
    let done = match misuse::command_line::<Cli>().command {
        None => return misuse::exit_code_of(rtrace::run_without_command()),
        Some(Command::Pictures(command)) => return misuse::exit_code_of(command.run()),
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
