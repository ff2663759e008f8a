//! The first command: what draws and shows pictures, and has cargo build the rest.
//!
//! The program `launcher`, which `cargo rtrace` runs, is this and no more, so that the
//! first picture waits for nothing else. The companion begins with the same.

pub mod book;
pub mod cargo;
pub mod chapter;
pub mod command_line;
pub mod draw;
pub mod files;
pub mod limited;
pub mod misuse;
pub mod save;
pub mod show;
pub mod terminal;

use std::error::Error;
use std::process::ExitCode;

/// Draws all pictures, and weaves the book: what is done without a command.
///
/// # Errors
/// As those of a command.
pub fn run_without_command() -> Result<ExitCode, Box<dyn Error>> {
    draw::draw_all()?;
    book::book(&book::Arguments::default())
}
