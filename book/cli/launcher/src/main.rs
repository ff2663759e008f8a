//! `cargo rtrace`: draws and shows by itself, and hands every other command to the
//! companion.

use std::env;
use std::error::Error;
use std::ffi::OsString;
use std::process::ExitCode;

use clap::{Args, Parser, Subcommand};
use course::names::companion;
use rtrace::cargo::{COMPANION, become_program};
use rtrace::misuse;

/// The pictures of Ray Tracing in One Weekend, chapter by chapter.
///
/// Without a command: draws all of them into target/pictures, as PNG and as
/// PPM files, and weaves the book into target/book.
#[derive(Parser)]
#[command(name = "rtrace", bin_name = companion(), disable_help_subcommand = true)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

/// The names and words of the companion's commands are written there as well: a test
/// compares what both say to `--help`.
#[derive(Subcommand)]
enum Command {
    #[command(flatten)]
    Own(rtrace::Command),
    /// Check your own picture, and learn which mistake draws it
    Check(Words),
    /// Make a crate of your own for a chapter, ready to be typed into
    Start(Words),
    /// Judge your crate or program whenever you save it
    Watch(Words),
    /// Put a function of any program, in any language, under the laws
    Laws(Words),
    /// Show the list of what you have done, or add a line to it
    Done(Words),
    /// Look at one ray and one sphere through every method of chapter 6
    Hit(Words),
    /// Find the least that a scene of your own needs, of all methods of chapter 6
    Needs(Words),
    /// List the small scenes that show what the book's picture can't
    Probes(Words),
    /// Print this message or the help of the given subcommand(s)
    Help(Words),
}

/// What the companion is to read.
#[derive(Args)]
#[command(disable_help_flag = true)]
struct Words {
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    _words: Vec<OsString>,
}

fn main() -> ExitCode {
    misuse::exit_code_of(match misuse::command_line::<Cli>().command {
        None => rtrace::run_without_command(),
        Some(Command::Own(command)) => command.run(),
        Some(_) => hand_on(),
    })
}

/// Becomes the companion, with the same words.
fn hand_on() -> Result<ExitCode, Box<dyn Error>> {
    let mut companion = COMPANION.built()?;
    companion.args(env::args_os().skip(1));
    become_program(companion)
}
