//! `cargo rtrace`: draws and shows by itself, and hands every other command to the
//! companion.

use std::env;
use std::error::Error;
use std::ffi::OsString;
use std::process::ExitCode;

use clap::Args;
use launcher::cargo::{COMPANION, become_program};
use launcher::command_line::{Command, CommandLine, Companion};
use launcher::{book, misuse, show};

/// Hands all words on to the companion.
struct HandOn;

impl Companion for HandOn {
    type Check = Words;
    type Start = Words;
    type Watch = Words;
    type Laws = Words;
    type Done = Words;
    type Hit = Words;
    type Needs = Words;
    type Probes = Words;
}

/// Words that are for the companion to read.
#[derive(Args)]
#[command(disable_help_flag = true)]
struct Words {
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    _words: Vec<OsString>,
}

fn main() -> ExitCode {
    // The companion knows the words behind each command, and so its help.
    let asks_for_help = env::args_os().nth(1).is_some_and(|word| word == "help");
    misuse::exit_code_of(if asks_for_help { hand_on() } else { run() })
}

fn run() -> Result<ExitCode, Box<dyn Error>> {
    match misuse::command_line::<CommandLine<HandOn>>().command {
        None => launcher::run_without_command(),
        Some(Command::Book(arguments)) => book::book(&arguments),
        Some(Command::Show(arguments)) => show::show(&arguments).map(|()| ExitCode::SUCCESS),
        Some(_) => hand_on(),
    }
}

/// Becomes the companion, with the same words.
fn hand_on() -> Result<ExitCode, Box<dyn Error>> {
    let mut companion = COMPANION.built()?;
    companion.args(env::args_os().skip(1));
    become_program(companion)
}
