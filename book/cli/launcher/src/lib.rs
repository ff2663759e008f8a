//! The first command: draws and shows pictures, and has cargo build the rest.
//!
//! The program `launcher`, which `cargo rtrace` runs, is this and no more, so that the
//! first picture waits for nothing else. The companion begins with the same.

pub mod book;
pub mod cargo;
pub mod chapter;
pub mod command_line;
pub mod draw;
pub mod limited;
pub mod misuse;
pub mod save;
pub mod show;
pub mod terminal;

pub use course::names;

use std::error::Error;
use std::process::ExitCode;

/// Draws all pictures as [`draw::draw_all`] does, and then weaves the book into `target/book`.
/// Returns the exit code of the weaver.
///
/// # Errors
/// If a picture can't be drawn, or the book can't be woven.
pub fn run_without_command() -> Result<ExitCode, Box<dyn Error>> {
    draw::draw_all()?;
    book::book(&book::Arguments::default())
}
