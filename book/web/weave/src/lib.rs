//! A preprocessor of mdBook that makes one book of pages, sources, figures and formulas.
//!
//! mdBook does Markdown, search, themes and the print page. Before it starts, [`Weaver`] replaces
//! all that mdBook does not know: the directives of the pages, and their formulas. Any error fails
//! the build, with the file, the line and the cause.

mod changes;
mod code;
mod controls;
mod directive;
mod figure;
mod folded;
pub mod folder;
mod ground;
mod lesson;
mod maths;
mod measured;
mod modules;
mod page;
mod source;
mod symbols;
mod warnings;

use std::error::Error;
use std::io::{self, Read, Write};
use std::path::Path;

use launcher::output;
use mdbook_driver::MDBook;
use mdbook_preprocessor::book::{Book, BookItem};
use mdbook_preprocessor::errors::{Error as Cause, Result as Done};
use mdbook_preprocessor::{Preprocessor, PreprocessorContext, parse_input};

use maths::Maths;
use page::Page;
use symbols::Symbols;

/// Builds the book in the folder `source`, which has a book.toml, as HTML pages into the empty
/// folder `folder`.
///
/// # Errors
/// If a page cannot be woven, or mdBook gives an error or a warning. The message has all of them.
pub fn weave(source: &Path, folder: &Path) -> Result<(), Box<dyn Error>> {
    let warnings = warnings::collect(|| {
        let mut book = MDBook::load(source).map_err(cannot_weave)?;
        book.config.build.build_dir = folder.to_owned();
        book.with_preprocessor(Weaver);
        book.build().map_err(cannot_weave)
    })?;
    if warnings.is_empty() {
        return Ok(());
    }
    Err(format!("mdBook warns about the book\n{}", warnings.join("\n")).into())
}

/// Serves mdBook's own program as a preprocessor: reads the context and the book from `question`,
/// as the JSON that mdBook sends, and writes the woven book to `answer` as JSON.
///
/// # Errors
/// If the input is no book, if a page cannot be woven, or if `answer` can't be written to.
pub fn preprocess(question: impl Read, answer: impl Write) -> Result<(), Box<dyn Error>> {
    let (context, book) = parse_input(question).map_err(cannot_weave)?;
    let woven = Weaver.run(&context, book).map_err(cannot_weave)?;
    Ok(serde_json::to_writer(answer, &woven)?)
}

/// Says that the book can't be woven, why, and what helps if the disk is full.
fn cannot_weave(error: Cause) -> Box<dyn Error> {
    let mut causes = error
        .chain()
        .filter_map(|cause| cause.downcast_ref::<io::Error>());
    let fix = causes.find_map(output::when_full).unwrap_or_default();
    format!("the book can't be woven\n{error:#}\n{fix}").into()
}

/// The folder with the modules of WebAssembly, from the folder of the book.
const MODULES: &str = "web/page/modules";

/// The preprocessor that replaces directives and formulas, and packs the modules of the pages.
struct Weaver;

impl Preprocessor for Weaver {
    fn name(&self) -> &str {
        "weave"
    }

    fn run(&self, context: &PreprocessorContext, mut book: Book) -> Done<Book> {
        let notes = context.root.join(&context.config.book.src);
        modules::pack(&context.root.join(MODULES), &notes.join("live"))?;
        let maths = Maths::new(Symbols::read(&notes));
        let mut problems = Vec::new();
        book.for_each_mut(|item| {
            if let BookItem::Chapter(chapter) = item
                && let Some(path) = &chapter.source_path
            {
                match Page::new(notes.join(path), &chapter.content).weave(&maths) {
                    Ok(content) => chapter.content = content,
                    Err(causes) => problems.extend(causes),
                }
            }
        });
        if problems.is_empty() {
            return Ok(book);
        }
        Err(Cause::msg(problems.join("\n")))
    }
}
