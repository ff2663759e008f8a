//! The first command: has cargo build the chapters, which draw, shows their pictures, and has cargo
//! build the rest when it is asked for.
//!
//! The program `launcher`, which `cargo rtrace` runs, is this and no more, so that the
//! first picture waits for nothing else. The companion begins with the same.

pub mod book;
pub mod cargo;
pub mod command_line;
mod draw;
mod drawing;
pub mod limited;
pub mod misuse;
pub mod output;
mod save;
mod show;
pub mod terminal;

pub use course::names;

use std::env;
use std::error::Error;
use std::process::ExitCode;

use course::chapter::Chapter;

use command_line::{Request, Words};

/// Does what the command line asks for, and returns the exit code; has `companion` run a command
/// that is not the launcher's own. An error is printed to standard error.
pub fn main(companion: impl FnOnce(&Words) -> Result<ExitCode, Box<dyn Error>>) -> ExitCode {
    let request = Request::read(env::args_os().skip(1));
    misuse::exit_code(request.and_then(|request| run(request, companion)))
}

fn run(
    request: Request,
    companion: impl FnOnce(&Words) -> Result<ExitCode, Box<dyn Error>>,
) -> Result<ExitCode, Box<dyn Error>> {
    match request {
        Request::Nothing => return run_without_command(),
        Request::Help(text) => output::print(&text)?,
        Request::Run(words) => match words.command.name() {
            "book" => return book::book(&words),
            "show" => show::show(&words)?,
            _ => return companion(&words),
        },
    }
    Ok(ExitCode::SUCCESS)
}

/// Draws the book's pictures, then that of chapter 6, whose methods the book is built with, and
/// weaves the book into `target/book`. Returns the exit code of the weaver.
fn run_without_command() -> Result<ExitCode, Box<dyn Error>> {
    let folder = names::name_from_here(&draw::pictures_folder()?);
    output::print(&format!("The pictures are in {folder}\n"))?;
    draw::draw(&Chapter::OF_THE_BOOK)?;
    let weaver = cargo::weaver()?;
    draw::draw(&[Chapter::SpeedVsAccuracy])?;
    book::weave(weaver, None, false)
}
