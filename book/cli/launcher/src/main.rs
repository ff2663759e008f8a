//! `cargo rtrace`: draws and shows by itself, and hands every other command to the
//! companion.

use std::env;
use std::error::Error;
use std::ffi::OsString;
use std::process::ExitCode;

use clap::Args;
use launcher::cargo::{COMPANION, become_program};
use launcher::command_line::{ArgumentTypes, Command, CommandLine};
use launcher::{book, misuse, show};

/// The command line of the launcher, which hands the arguments of the companion's commands on.
struct HandedOn;

impl ArgumentTypes for HandedOn {
    type Check = UnreadWords;
    type Start = UnreadWords;
    type Watch = UnreadWords;
    type Laws = UnreadWords;
    type Done = UnreadWords;
    type Hit = UnreadWords;
    type Needs = UnreadWords;
    type Probes = UnreadWords;
}

/// Arguments that the companion reads.
#[derive(Args)]
#[command(disable_help_flag = true)]
struct UnreadWords {
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    _words: Vec<OsString>,
}

fn main() -> ExitCode {
    // The companion knows the arguments of each command, and so its help.
    let asks_for_help = env::args_os().nth(1).is_some_and(|word| word == "help");
    misuse::exit_code_of(if asks_for_help { hand_on() } else { run() })
}

fn run() -> Result<ExitCode, Box<dyn Error>> {
    match misuse::command_line::<CommandLine<HandedOn>>().command {
        None => launcher::run_without_command(),
        Some(Command::Book(arguments)) => book::book(&arguments),
        Some(Command::Show(arguments)) => show::show(&arguments).map(|()| ExitCode::SUCCESS),
        Some(_) => hand_on(),
    }
}

/// Builds the companion, and becomes it, with all arguments of this process.
fn hand_on() -> Result<ExitCode, Box<dyn Error>> {
    let mut companion = COMPANION.built_program()?;
    companion.args(env::args_os().skip(1));
    become_program(companion)
}
