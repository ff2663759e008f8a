//! `cargo rtrace book`: cargo runs the weaver into a temporary folder, and what it wrote
//! takes the place of the last book.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, path};

use check::names::from_here;
use clap::Args;
use common::engine::output;

use crate::misuse::misuse;
use crate::{draw, files};

/// What `cargo rtrace book` is told.
#[derive(Args)]
pub(crate) struct Arguments {
    /// Open the book in the browser
    #[arg(long)]
    open: bool,

    /// A folder for the book [default: target/book]
    #[arg(long, short, value_name = "DIR")]
    output: Option<PathBuf>,

    /// The folder with the book.toml of another book
    #[arg(long, value_name = "DIR")]
    source: Option<PathBuf>,
}

/// Weaves the book, says where it is, and opens it on request.
pub(crate) fn book(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let source = match &arguments.source {
        Some(source) => source.clone(),
        None => draw::workspace()?.join("book"),
    };
    output::to_stdout(|out| {
        out.write_all(
            b"Weaving the book. The first time, cargo builds mdBook for it, which takes a minute\n",
        )
    })?;
    let index = weave(&source, arguments.output.as_deref())?;
    let said = format!("The book is in {}\n", from_here(&index));
    output::to_stdout(|out| out.write_all(said.as_bytes()))?;
    if arguments.open {
        open::that_detached(&index).map_err(|cause| {
            format!(
                "no browser opened {}: {cause}\nOpen it by hand.",
                index.display()
            )
        })?;
    }
    Ok(())
}

/// Weaves this book into target/book, and says where it is.
pub(crate) fn this_book() -> Result<(), Box<dyn Error>> {
    book(&Arguments {
        open: false,
        output: None,
        source: None,
    })
}

/// Weaves the book in the folder `source`. Returns the path of its first page.
fn weave(source: &Path, output: Option<&Path>) -> Result<PathBuf, Box<dyn Error>> {
    let default = || draw::folder().map(|pictures| pictures.with_file_name("book"));
    let target = output.map_or_else(default, |output| Ok(output.to_owned()))?;
    refuse_pages(&target)?;
    files::refuse_strangers(&target, KIND)?;
    let woven = tempfile::tempdir()?;
    fill(woven.path(), source)?;
    files::fill(&target, KIND, &files::read(woven.path())?)?;
    Ok(target.join("index.html"))
}

/// What the folder is called where another one is refused.
const KIND: &str = "book";

/// mdBook copies what lies among the pages into the book: the last book, too.
fn refuse_pages(target: &Path) -> Result<(), Box<dyn Error>> {
    let target = path::absolute(target)?;
    let has_pages = |above: &Path| above.join("SUMMARY.md").is_file();
    match target.ancestors().any(has_pages) {
        false => Ok(()),
        true => Err(misuse(&format!(
            "{} lies among the pages of a book, and would become a part of the next one\n\
             Name a folder elsewhere.",
            from_here(&target)
        ))),
    }
}

/// Has cargo build the package `weave`, if need be, and run it.
fn fill(folder: &Path, source: &Path) -> Result<(), Box<dyn Error>> {
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let run = Command::new(cargo)
        .args(["run", "--quiet", "--package", "weave", "--manifest-path"])
        .arg(draw::workspace()?.join("Cargo.toml"))
        .arg("--")
        .args([source, folder])
        .output()
        .map_err(|cause| format!("cargo, which runs the weaver, does not start: {cause}"))?;
    match run.status.success() {
        true => Ok(()),
        false => Err(String::from_utf8_lossy(&run.stderr).trim_end().into()),
    }
}
