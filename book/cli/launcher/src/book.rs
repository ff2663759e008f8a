//! `book`: cargo builds the weaver, and the weaver makes the book.

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use common::engine::output;
use course::names::name_from_here;

use crate::cargo::WEAVER;
use crate::draw;

/// The arguments of `cargo rtrace book`.
#[derive(Args, Default)]
pub struct Arguments {
    /// Open the book in the browser
    #[arg(long)]
    open: bool,

    /// A folder for the book [default: target/book]
    #[arg(long, short, value_name = "DIR")]
    output: Option<PathBuf>,
}

/// Weaves the book into a folder, prints where its first page is, and opens that in the browser if
/// the reader asks for it. Returns the exit code of the weaver, which reports its own failures.
///
/// # Errors
/// If the weaver can't be built or started, or if no browser opens the page.
pub fn book(arguments: &Arguments) -> Result<ExitCode, Box<dyn Error>> {
    let workspace = draw::find_workspace()?;
    let usual = || workspace.join("target/book");
    let folder = arguments.output.clone().unwrap_or_else(usual);
    let source = workspace.join("book");
    let woven = WEAVER.built_program()?.args([&source, &folder]).status();
    let woven = woven.map_err(|cause| format!("the weaver does not start: {cause}"))?;
    if !woven.success() {
        let code = woven.code().and_then(|code| u8::try_from(code).ok());
        return Ok(code.map_or(ExitCode::FAILURE, ExitCode::from));
    }
    let index = folder.join("index.html");
    let said = format!("The book is in {}\n", name_from_here(&index));
    output::to_stdout(|out| out.write_all(said.as_bytes()))?;
    if arguments.open {
        open::that_detached(&index).map_err(|cause| {
            format!(
                "no browser opened {}: {cause}\nOpen the page by hand.",
                index.display()
            )
        })?;
    }
    Ok(ExitCode::SUCCESS)
}
