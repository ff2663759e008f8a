//! `cargo rtrace book`: pages, sources, figures and formulas become one book.
//!
//! mdBook does what it does well: Markdown, search, themes, the print page. What
//! it does not know, the directives of the pages and their formulas, is resolved
//! before by [`Weave`]. Whatever goes wrong fails the build, with the file, the
//! line and the cause.

mod changes;
mod code;
mod directive;
mod figure;
mod maths;
mod measured;
mod page;
mod slip;
mod snapshot;
mod warnings;
mod woven;

use std::error::Error;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

use clap::Args;
use common::engine::output;
use mdbook_driver::MDBook;
use mdbook_preprocessor::book::{Book, BookItem};
use mdbook_preprocessor::{Preprocessor, PreprocessorContext};

use crate::draw;
use crate::misuse::misuse;
use maths::Maths;
use page::Page;

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
        Some(source) => source,
        None => Path::new(env!("CARGO_MANIFEST_DIR")),
    };
    let index = weave(source, arguments.output.as_deref())?;
    let said = format!("The book is in {}\n", draw::shown(&index).display());
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

/// Weaves the book in the folder `source`; returns the path of its first page.
fn weave(source: &Path, output: Option<&Path>) -> Result<PathBuf, Box<dyn Error>> {
    let target = draw::folder()?.with_file_name("book");
    let output = output.unwrap_or(&target);
    refuse_to_clear(output)?;
    // mdBook clears the folder and fills it again: one at a time.
    let lock = File::create(target.with_extension("lock"))?;
    lock.lock()?;
    let warnings = warnings::collect(|| {
        let mut book = MDBook::load(source)?;
        book.config.build.build_dir = std::path::absolute(output)?;
        book.with_preprocessor(Weave);
        book.build()
    })
    .map_err(|error| format!("the book can't be woven\n{error:#}"))?;
    match warnings.is_empty() {
        true => Ok(output.join("index.html")),
        false => Err(format!("mdBook warns about the book\n{}", warnings.join("\n")).into()),
    }
}

/// A folder is cleared only if it holds a book, or nothing.
fn refuse_to_clear(folder: &Path) -> Result<(), Box<dyn Error>> {
    let is_empty = || fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_none());
    if !folder.exists() || folder.join("print.html").exists() || is_empty() {
        return Ok(());
    }
    Err(misuse(&format!(
        "{} is no folder with a book: it would be cleared. Name a new folder, or an empty one.",
        folder.display()
    )))
}

/// Resolves what the pages have that mdBook does not know.
struct Weave;

impl Preprocessor for Weave {
    fn name(&self) -> &str {
        "weave"
    }

    fn run(&self, context: &PreprocessorContext, mut book: Book) -> anyhow::Result<Book> {
        let notes = context.root.join(&context.config.book.src);
        let mut maths = Maths::new();
        let mut problems = Vec::new();
        book.for_each_mut(|item| {
            if let BookItem::Chapter(chapter) = item
                && let Some(path) = &chapter.source_path
            {
                let page = Page::new(notes.join(path), &chapter.content);
                match page.weave(&mut maths) {
                    Ok(woven) => chapter.content = woven,
                    Err(causes) => problems.extend(causes),
                }
            }
        });
        match problems.is_empty() {
            true => Ok(book),
            false => anyhow::bail!(problems.join("\n")),
        }
    }
}
