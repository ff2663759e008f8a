//! Static analysis of a reader's files: which statements of a chapter, or of a slip, they have.

mod likeness;
mod lines;

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt;

use slips::{Chapter, ChapterProgram, Slip};

pub use interpreter::SourceFile;

use crate::task::Task;

pub(crate) use likeness::likeness;
use lines::TypedStatement;
pub(crate) use lines::{CorrectedLine, LineComparison, StatementDiff};

/// The files that a reader types for a chapter, in Rust, beside those of the chapter; by default
/// none.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    yours: Vec<SourceFile>,
    chapter: Vec<SourceFile>,
    typed: Vec<TypedStatement>,
    /// The lines of slips that were looked for before.
    slip_lines: RefCell<BTreeMap<Key, SlipLine>>,
}

/// A slip by its name and, as some have none, its address, and a task by its chapter and step.
type Key = (&'static str, usize, Chapter, Option<usize>);

/// A line of a reader's source file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SourceLine {
    /// The path of the file, relative to the folder of the program: `src/lib.rs`.
    pub file: String,
    /// The number of the line, from 1.
    pub number: usize,
    /// The code of the line without indentation and repeated blanks. Where a statement goes on over
    /// more lines, they are joined.
    pub text: String,
}

/// The line of a slip in a reader's files.
#[derive(Clone, Debug, Default)]
pub(crate) struct SlipLine {
    /// The state of the line: with the slip, right, or not found.
    pub(crate) status: LineStatus,
    /// The line with the slip and its correction, if the status is [`LineStatus::Wrong`] and the
    /// line is known.
    pub(crate) corrected: Option<CorrectedLine>,
}

/// The state of a slip's line in a reader's files.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum LineStatus {
    /// The files have the line with the slip in it.
    Wrong,
    /// The files have the line as it should be.
    Right,
    /// The files are unknown, or have neither line in a form that is recognized.
    #[default]
    NotFound,
}

/// The fewest words and signs of a statement: `return t * color;` has six.
const STATEMENT: usize = 6;

impl Sources {
    /// Takes the files of a reader who types a chapter's own files in Rust; the right ones are
    /// added to compare with.
    pub fn of_chapter(yours: Vec<SourceFile>, chapter: Chapter) -> Self {
        // Some editors begin a file with a byte order mark.
        let without_mark = |file: SourceFile| SourceFile {
            text: file.text.trim_start_matches('\u{feff}').to_owned(),
            ..file
        };
        let yours: Vec<_> = yours.into_iter().map(without_mark).collect();
        Self {
            typed: yours.iter().flat_map(lines::typed).collect(),
            yours,
            chapter: slips::typed_files(chapter),
            slip_lines: RefCell::default(),
        }
    }

    /// Finds the line that has a slip in a task, or has it right.
    pub(crate) fn slip_line(&self, slip: &Slip, task: &Task) -> SlipLine {
        let task = task.without_probe();
        let key = (
            slip.name,
            std::ptr::from_ref(slip) as usize,
            task.chapter,
            task.step(),
        );
        let mut known = self.slip_lines.borrow_mut();
        let line = known.entry(key).or_insert_with(|| self.find(slip, &task));
        line.clone()
    }

    /// Finds the line of a slip, without looking whether it was found before.
    fn find(&self, slip: &Slip, task: &Task) -> SlipLine {
        if self.typed.is_empty() {
            return SlipLine::default();
        }
        let (right, wrong) = (task.program(&[]), task.program(&[slip]));
        let pairs = right.functions().zip(wrong.functions());
        let changed = pairs.filter(|((_, right), (_, wrong))| right != wrong);
        let change = StatementDiff::of(changed.map(|((_, right), (_, wrong))| (right, wrong)));
        let lines = self.beside(&right);
        let status = lines.status(&change);
        SlipLine {
            corrected: (status == LineStatus::Wrong)
                .then(|| lines.corrected(&change))
                .flatten(),
            status,
        }
    }

    /// Compares the statements of these files with those of a program.
    pub(crate) fn beside(&self, program: &ChapterProgram) -> LineComparison<'_> {
        LineComparison::new(program.functions().map(|it| it.1), &self.typed)
    }

    /// Returns the reader's files, `lib.rs` first, but for `main.rs`.
    pub(crate) fn of_the_library(&self) -> Vec<SourceFile> {
        let is_read = |it: &&SourceFile| !it.name.ends_with("main.rs");
        let mut files: Vec<_> = self.yours.iter().filter(is_read).cloned().collect();
        files.sort_by_key(|it| !it.name.ends_with("lib.rs"));
        files
    }

    /// Returns true if no file of the reader is known.
    pub(crate) fn is_empty(&self) -> bool {
        self.yours.is_empty()
    }

    /// Returns true if the reader has typed the whole chapter, right or wrong: the files with
    /// functions of the chapter have as many words and signs in all functions as the chapter, less
    /// than a statement fewer at most. False if no file is known.
    pub(crate) fn is_written(&self) -> bool {
        let [chapter, yours] = [&self.chapter, &self.yours].map(|files| {
            let files = files.iter();
            files.map(|it| function_sizes(&it.text)).collect::<Vec<_>>()
        });
        let is_of_chapter = |name: &String| chapter.iter().flatten().any(|it| it.0 == *name);
        // A prelude has none of the chapter's functions, and `start` gives a sky.
        let counts = |functions: &&Vec<(String, usize)>| {
            let mut functions = functions.iter();
            functions.any(|it| it.0 != "new" && is_of_chapter(&it.0))
        };
        let own = yours.iter().filter(counts).flatten();
        let own = own.filter(|it| it.0 != "sky").map(|it| it.1);
        let theirs = chapter.iter().flatten().map(|it| it.1);
        !self.is_empty() && own.sum::<usize>() + STATEMENT > theirs.sum()
    }
}

/// Lists the functions of a file, each with the number of words and signs up to the next one.
fn function_sizes(text: &str) -> Vec<(String, usize)> {
    let words = lines::words(text);
    let parts = words.split(|it| it.0 == "fn").skip(1);
    let named = parts.filter_map(|part| Some((part.first()?.0.clone(), part.len())));
    named.collect()
}

impl fmt::Display for SourceLine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}  {}", self.file, self.number, self.text)
    }
}
