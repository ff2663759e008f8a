//! `cargo rtrace book`: a folder is prepared, cargo runs the weaver into it, and it takes
//! the place of the last book.

use std::env;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;

use check::places::shown;
use clap::Args;
use common::engine::folder::{self, NewFolder};
use common::engine::output;

use crate::draw;
use crate::misuse::refusal;

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
        out.write_all(b"Weaving the book: the first time cargo builds mdBook for it, in a minute\n")
    })?;
    let (index, aside) = weave(&source, arguments.output.as_deref())?;
    let mut said = format!("The book is in {}\n", shown(&index));
    if let Some(aside) = aside {
        said += &format!(
            "What was there had no list of its files, so it is now {}, to keep or to delete.\n",
            shown(&aside)
        );
    }
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

/// Weaves the book in the folder `source`. Returns the path of its first page, and
/// where a folder is now that was in the way.
fn weave(
    source: &Path,
    output: Option<&Path>,
) -> Result<(PathBuf, Option<PathBuf>), Box<dyn Error>> {
    let default = || draw::folder().map(|pictures| pictures.with_file_name("book"));
    let target = output.map_or_else(default, |output| Ok(output.to_owned()))?;
    let folder = NewFolder::beside(&target, "book").map_err(refusal)?;
    // Books that were woven before there were manifests have none. In our own folder
    // they make way; elsewhere nobody knows whether it was a book.
    let makes_way = output.is_none() && folder::is_unlisted(&target);
    if !makes_way {
        folder.check().map_err(refusal)?;
    }
    fill(&folder.path(), source)?;
    let aside = match makes_way {
        true => folder::set_aside(&target).map_err(refusal)?,
        false => None,
    };
    folder.put_in_place().map_err(refusal)?;
    Ok((target.join("index.html"), aside))
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
