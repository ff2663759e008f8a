//! `cargo rtrace book`: pages, sources, figures and formulas become one book.
//!
//! mdBook does what it does well: Markdown, search, themes, the print page. What
//! it does not know, the directives of the pages and their formulas, is resolved
//! before by [`Weave`]. Whatever goes wrong fails the build, with the file, the
//! line and the cause.

mod breaks;
mod changes;
mod code;
mod controls;
mod directive;
mod figure;
mod maths;
mod measured;
mod page;
mod picture;
mod slip;
mod snapshot;
mod step;
mod warnings;
mod woven;

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use check::places::shown;
use clap::Args;
use common::engine::folder::{self, NewFolder};
use common::engine::output;
use mdbook_driver::MDBook;
use mdbook_preprocessor::book::{Book, BookItem};
use mdbook_preprocessor::{Preprocessor, PreprocessorContext};

use crate::draw;
use crate::misuse::{misuse, refusal};
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
        Some(source) => source.clone(),
        None => draw::workspace()?.join("book"),
    };
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
    fill(&folder, source)?;
    let aside = match makes_way {
        true => folder::set_aside(&target).map_err(refusal)?,
        false => None,
    };
    folder.put_in_place().map_err(refusal)?;
    Ok((target.join("index.html"), aside))
}

/// Writes the book in the folder `source` into a new folder.
fn fill(folder: &NewFolder, source: &Path) -> Result<(), Box<dyn Error>> {
    let warnings = warnings::collect(|| {
        let mut book = MDBook::load(source).map_err(cannot_weave)?;
        refuse_inside(&book.source_dir(), folder.target())?;
        book.config.build.build_dir = folder.path();
        book.with_preprocessor(Weave);
        book.build().map_err(cannot_weave)
    })?;
    match warnings.is_empty() {
        true => Ok(()),
        false => Err(format!("mdBook warns about the book\n{}", warnings.join("\n")).into()),
    }
}

/// mdBook copies what lies among the pages into the book: the last book, too.
fn refuse_inside(pages: &Path, target: &Path) -> Result<(), Box<dyn Error>> {
    let above = target.parent().unwrap_or(target);
    match fs::canonicalize(above)?.starts_with(fs::canonicalize(pages)?) {
        false => Ok(()),
        true => Err(misuse(&format!(
            "{} lies among the pages of the book, and would become a part of the next one.\n\
             Name a folder elsewhere.",
            target.display()
        ))),
    }
}

fn cannot_weave(error: anyhow::Error) -> Box<dyn Error> {
    format!("the book can't be woven\n{error:#}").into()
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
