//! The first command: has cargo build the chapters, which draw, shows their pictures, and has cargo
//! build the rest when it is asked for.
//!
//! The program `launcher`, which `cargo rtrace` runs, is this and no more, so that the
//! first picture waits for nothing else. The companion begins with the same.

pub mod book;
pub mod cargo;
pub mod chapter;
pub mod command_line;

pub mod draw;
mod drawing;
pub mod limited;
pub mod misuse;
pub mod output;
mod save;
mod show;
pub mod terminal;

pub use course::names;

use std::error::Error;
use std::process::ExitCode;

use course::chapter::Chapter;

use command_line::{Request, Words};

/// Does what a command line asks for if it is no command of the companion, and returns the exit
/// code. Returns the words of a command of the companion as the outer error.
///
/// # Errors
/// The inner error, if it can't be done.
pub fn run_own(request: Request) -> Result<Result<ExitCode, Box<dyn Error>>, Words> {
    let done = |it: Result<(), Box<dyn Error>>| it.map(|()| ExitCode::SUCCESS);
    Ok(match request {
        Request::Nothing => run_without_command(),
        Request::Help(text) => {
            let printed = output::to_stdout(|out| out.write_all(text.as_bytes()));
            done(printed.map_err(Into::into))
        }
        Request::Run(words) => match words.command.name() {
            "book" => book::book(&book::Arguments::read(&words)),
            "show" => done(show::Arguments::read(&words).and_then(|it| show::show(&it))),
            _ => return Err(words),
        },
    })
}

/// Draws the book's pictures, then that of chapter 6, whose methods the book is built with, and
/// weaves the book into `target/book`. Returns the exit code of the weaver.
fn run_without_command() -> Result<ExitCode, Box<dyn Error>> {
    draw::say_where()?;
    draw::draw(&Chapter::OF_THE_BOOK)?;
    let weaver = cargo::weaver()?;
    draw::draw(&[Chapter::SpeedVsAccuracy])?;
    book::weave(weaver, &book::Arguments::default())
}
