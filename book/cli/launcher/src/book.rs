//! `book`: cargo builds the weaver, and the weaver makes the book.

use std::error::Error;
use std::path::PathBuf;
use std::process::{Command, ExitCode};

use course::names::name_from_here;

use crate::command_line::Words;
use crate::{cargo, draw, output};

/// Builds the weaver and weaves the book, as [`weave`] does.
pub(crate) fn book(words: &Words) -> Result<ExitCode, Box<dyn Error>> {
    weave(
        cargo::weaver()?,
        words.path("--output"),
        words.has("--open"),
    )
}

/// Has the weaver make the book in `folder`, or else in `target/book`, prints where its first page
/// is, and opens that in the browser if `opens`. Returns the exit code of the weaver, which reports
/// its own failures.
pub(crate) fn weave(
    mut weaver: Command,
    folder: Option<PathBuf>,
    opens: bool,
) -> Result<ExitCode, Box<dyn Error>> {
    let workspace = draw::find_workspace()?;
    let folder = folder.unwrap_or_else(|| workspace.join("target/book"));
    let source = workspace.join("book");
    let woven = weaver.args([&source, &folder]).status();
    let woven = woven.map_err(|cause| format!("the weaver does not start: {cause}"))?;
    if !woven.success() {
        let code = woven.code().and_then(|code| u8::try_from(code).ok());
        return Ok(code.map_or(ExitCode::FAILURE, ExitCode::from));
    }
    let index = folder.join("index.html");
    output::print(&format!("The book is in {}\n", name_from_here(&index)))?;
    if opens {
        open::that_detached(&index).map_err(|cause| {
            format!(
                "no browser opened {}: {cause}\nOpen the page by hand.",
                index.display()
            )
        })?;
    }
    Ok(ExitCode::SUCCESS)
}
