//! `book`: cargo builds the weaver, and the weaver makes the book.

use std::error::Error;
use std::path::PathBuf;
use std::process::{Command, ExitCode};

use course::names::name_from_here;

use crate::command_line::Words;
use crate::{cargo, draw, output};

/// The arguments of `cargo rtrace book`.
#[derive(Default)]
pub struct Arguments {
    open: bool,
    output: Option<PathBuf>,
}

impl Arguments {
    /// Reads the arguments from a command line.
    pub fn read(words: &Words) -> Self {
        Self {
            open: words.has("--open"),
            output: words.path("-o, --output <DIR>"),
        }
    }
}

/// Builds the weaver and weaves the book, as [`weave`] does.
///
/// # Errors
/// If the weaver can't be built or started, or if no browser opens the page.
pub fn book(arguments: &Arguments) -> Result<ExitCode, Box<dyn Error>> {
    weave(cargo::weaver()?, arguments)
}

/// Has the weaver make the book in a folder, prints where its first page is, and opens that in the
/// browser if the reader asks for it. Returns the exit code of the weaver, which reports its own
/// failures.
///
/// # Errors
/// If the weaver can't be started, or if no browser opens the page.
pub fn weave(mut weaver: Command, arguments: &Arguments) -> Result<ExitCode, Box<dyn Error>> {
    let workspace = draw::find_workspace()?;
    let usual = || workspace.join("target/book");
    let folder = arguments.output.clone().unwrap_or_else(usual);
    let source = workspace.join("book");
    let woven = weaver.args([&source, &folder]).status();
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
