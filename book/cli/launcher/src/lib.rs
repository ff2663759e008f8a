//! The first command: what draws and shows pictures, and has cargo build the rest.
//!
//! The program `launcher`, which `cargo rtrace` runs, is this and no more, so that the
//! first picture waits for nothing else. The companion begins with the same.

pub mod book;
pub mod cargo;
pub mod chapter;
pub mod draw;
pub mod files;
pub mod misuse;
pub mod save;
pub mod show;
pub mod terminal;

use std::error::Error;
use std::process::ExitCode;

use clap::Subcommand;

/// What needs nothing but the chapters, and the weaver.
#[derive(Subcommand)]
pub enum Command {
    /// Weave the book: the notes with the code, the pictures and the figures
    Book(book::Arguments),
    /// Draw one picture: in the terminal, into a file, or into a viewer
    Show(show::Arguments),
}

impl Command {
    /// Does it.
    ///
    /// # Errors
    /// If it can't be done: why, and what helps.
    pub fn run(&self) -> Result<ExitCode, Box<dyn Error>> {
        match self {
            Self::Book(arguments) => book::book(arguments),
            Self::Show(arguments) => show::show(arguments).map(|()| ExitCode::SUCCESS),
        }
    }
}

/// Draws all pictures, and weaves the book: what is done without a command.
///
/// # Errors
/// As those of a command.
pub fn run_without_command() -> Result<ExitCode, Box<dyn Error>> {
    draw::all()?;
    book::book(&book::Arguments::default())
}
