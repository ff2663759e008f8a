//! `cargo rtrace`: the reader's companion.

mod book;
mod chapter;
mod check;
mod done;
mod draw;
mod files;
mod hit;
mod mine;
mod misuse;
mod needs;
mod probes;
mod save;
mod show;
#[cfg(unix)]
mod signals;
mod slips;
mod sources;
mod start;
mod subprocess;
mod terminal;
mod watch;

use std::process::ExitCode;

use ::check::names::companion;
use clap::{Parser, Subcommand};

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
    /// Weave the book: the notes with the code, the pictures and the figures
    Book(book::Arguments),
    /// Draw one picture: in the terminal, into a file, or into a viewer
    Show(show::Arguments),
    /// Check your own picture, and learn which mistake draws it
    Check(check::Arguments),
    /// Make a crate of your own for a chapter, ready to be typed into
    Start(start::Arguments),
    /// Judge your crate or program whenever you save it
    Watch(watch::Arguments),
    /// Show the list of what you have done, or add a line to it
    Done(done::Arguments),
    /// Look at one ray and one sphere through every method of chapter 6
    Hit(hit::Arguments),
    /// Find the least that a scene of your own needs, of all methods of chapter 6
    Needs(needs::Arguments),
    /// List the small scenes that show what the book's picture can't
    Probes(probes::Arguments),
    /// List the mistakes that are known, or draw one
    Slips(slips::Arguments),
}

fn main() -> ExitCode {
    let done = match misuse::command_line::<Cli>().command {
        None => draw::all().and_then(|()| book::this_book()),
        Some(Command::Book(arguments)) => book::book(&arguments),
        Some(Command::Show(arguments)) => show::show(&arguments),
        Some(Command::Check(arguments)) => return check::check(&arguments),
        Some(Command::Start(arguments)) => start::start(&arguments),
        Some(Command::Watch(arguments)) => match watch::watch(&arguments) {
            Ok(code) => return code,
            Err(error) => Err(error),
        },
        Some(Command::Done(arguments)) => done::done(&arguments),
        Some(Command::Hit(arguments)) => hit::hit(&arguments),
        Some(Command::Needs(arguments)) => needs::needs(&arguments),
        Some(Command::Probes(arguments)) => probes::list(&arguments),
        Some(Command::Slips(arguments)) => slips::slips(&arguments),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            misuse::fail(&format!("rtrace: {error}"));
            misuse::exit_code(&*error)
        }
    }
}
