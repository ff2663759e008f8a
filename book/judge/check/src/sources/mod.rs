//! Static analysis of a reader's files, in any of ten languages: which statements of a chapter, or
//! of a slip, they have.

mod chapter_statement;
mod likeness;
mod lines;
mod transplant;

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt;

use language::{
    FunctionSize, Language, Op, Role, Statement, Tree, canonical, function_sizes, normal,
    statements,
};
use slips::{Chapter, Edition, Slip};

pub use interpreter::SourceFile;

use crate::task::Task;

pub(crate) use likeness::likeness;
pub(crate) use lines::{CorrectedLine, LineComparison, StatementDiff};
pub(crate) use transplant::Transplant;

/// The source files of a reader's program, in any of ten languages, beside those of the chapter
/// that the reader follows; by default none.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    yours: Vec<SourceFile>,
    /// Empty if the reader's program need not have the functions of a chapter.
    chapter: Vec<SourceFile>,
    typed: Vec<TypedStatement>,
    /// The lines of slips that were looked for before.
    slip_lines: RefCell<BTreeMap<Key, SlipLine>>,
}

/// A slip by its name and, as some have none, its address, and a task by its chapter, edition and
/// step.
type Key = (&'static str, usize, Chapter, Edition, Option<usize>);

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

/// A statement of a reader's file.
#[derive(Clone, Debug)]
pub(crate) struct TypedStatement {
    /// The line at which the statement begins.
    pub(crate) line: SourceLine,
    language: Language,
    /// The purpose of the expression.
    role: Role,
    /// The expression as it is written in the file.
    value: Tree,
    /// The normal form of the expression.
    normal: Tree,
}

/// The fewest tokens of a statement: `return t * color;` has six.
const STATEMENT: usize = 6;

impl Sources {
    /// Takes all files of a reader's program. `chapter` has the right files if the reader types a
    /// chapter's own files in Rust, and is empty for a program of any other form.
    pub fn new(yours: Vec<SourceFile>, chapter: Vec<SourceFile>) -> Self {
        // Some editors begin a file with a byte order mark.
        let without_mark = |file: SourceFile| SourceFile {
            text: file.text.trim_start_matches('\u{feff}').to_owned(),
            ..file
        };
        let yours: Vec<_> = yours.into_iter().map(without_mark).collect();
        Self {
            typed: yours.iter().flat_map(typed).collect(),
            yours,
            chapter,
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
            task.edition,
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
        let change =
            StatementDiff::of(changed.map(|((name, right), (_, wrong))| (name, right, wrong)));
        let lines = LineComparison::new(right.functions(), &self.typed);
        // A line of an older edition is wrong only beside lines of this one.
        let is_older = || {
            let older = Edition::V3.program(task.chapter);
            change.is_made_in(older.functions()) && self.in_rust().is_empty()
        };
        match lines.status(&change) {
            LineStatus::Wrong if is_older() => SlipLine::default(),
            status => SlipLine {
                corrected: (status == LineStatus::Wrong)
                    .then(|| lines.corrected(&change))
                    .flatten(),
                status,
            },
        }
    }

    /// Takes the files of a reader who types a chapter's own files in Rust; the right ones are
    /// added to compare with.
    pub fn of_chapter(yours: Vec<SourceFile>, chapter: Chapter) -> Self {
        Self::new(yours, slips::typed_files(chapter))
    }

    /// Returns true if the reader types the files of a chapter, and no program of another form.
    pub(crate) fn are_of_the_chapter(&self) -> bool {
        !self.chapter.is_empty()
    }

    /// Returns the reader's files in Rust, `lib.rs` first, but for `main.rs`.
    pub(crate) fn in_rust(&self) -> Vec<SourceFile> {
        let is_read = |it: &&SourceFile| it.name.ends_with(".rs") && !it.name.ends_with("main.rs");
        let mut files: Vec<_> = self.yours.iter().filter(is_read).cloned().collect();
        files.sort_by_key(|it| !it.name.ends_with("lib.rs"));
        files
    }

    /// Returns all files of the reader.
    pub(crate) fn files(&self) -> &[SourceFile] {
        &self.yours
    }

    /// Returns true if no file of the reader is known.
    pub(crate) fn is_empty(&self) -> bool {
        self.yours.is_empty()
    }

    /// Returns the statements of all files whose language is known.
    pub(crate) fn typed(&self) -> &[TypedStatement] {
        &self.typed
    }

    /// Returns true if the reader has typed the whole chapter, right or wrong: the files with
    /// functions of the chapter have as many tokens in all functions as the chapter, less than a
    /// statement fewer at most. False if no chapter is typed.
    pub(crate) fn is_written(&self) -> bool {
        let [chapter, yours] = [&self.chapter, &self.yours].map(|files| {
            let files = files.iter();
            files.map(|it| function_sizes(&it.text)).collect::<Vec<_>>()
        });
        let is_of_chapter = |name: &str| chapter.iter().flatten().any(|it| it.name == name);
        // A prelude has none of the chapter's functions, and `start` gives a sky.
        let counts = |functions: &&Vec<FunctionSize>| {
            let mut functions = functions.iter();
            functions.any(|it| it.name != "new" && is_of_chapter(it.name))
        };
        let own = yours.iter().filter(counts).flatten();
        let own = own.filter(|it| it.name != "sky").map(|it| it.tokens);
        let theirs = chapter.iter().flatten().map(|it| it.tokens);
        self.are_of_the_chapter() && own.sum::<usize>() + STATEMENT > theirs.sum()
    }
}

/// Reads the statements of a file; none if its language is unknown.
fn typed(file: &SourceFile) -> Vec<TypedStatement> {
    let SourceFile { name, text } = file;
    let Some(language) = Language::of_file(name) else {
        return Vec::new();
    };
    let all = with_values(read(text, language)).into_iter();
    let typed = all.map(|it| {
        let before = &text[..it.at.start];
        let lines = text[it.at.clone()].matches('\n').count() + 1;
        let first = before.matches('\n').count();
        let words = text
            .lines()
            .skip(first)
            .take(lines)
            .flat_map(str::split_whitespace);
        TypedStatement {
            line: SourceLine {
                file: name.to_owned(),
                number: first + 1,
                text: words.collect::<Vec<_>>().join(" "),
            },
            language,
            role: it.role,
            normal: normal(&it.value),
            value: it.value,
        }
    });
    typed.collect()
}

/// Reads the statements of a text. Each sphere that is made in a statement becomes one of its own,
/// however it is added to the world.
fn read(text: &str, language: Language) -> Vec<Statement> {
    let all = statements(text, language).into_iter();
    let parts = all.flat_map(|it| {
        let nodes = it.value.nodes().into_iter();
        let spheres = nodes.filter(|node| normal(node).is_call("sphere"));
        let added: Vec<Statement> = spheres
            .map(|value| Statement {
                role: Role::Effect,
                value: value.clone(),
                at: it.at.clone(),
            })
            .collect();
        if added.is_empty() { vec![it] } else { added }
    });
    parts.collect()
}

/// Writes `r.direction` or `r.origin` for each variable that only stands for it, as `d` does after
/// `d = r.direction`.
fn with_values(all: Vec<Statement>) -> Vec<Statement> {
    let given = |name: &str| {
        let is_it = |it: &&Statement| matches!(&it.role, Role::ValueOf(own) if own == name);
        let mut found = all.iter().filter(is_it);
        found.next().filter(|_| found.next().is_none())
    };
    let short = |tree: &Tree| {
        let value = &given(tree.name()?)?.value;
        let is_field = matches!(&value.parts[..], [of] if of.name().is_some());
        let is_of_ray = |it: &Tree| matches!(&normal(it).op, Op::Call(name) if name == "direction" || name == "origin");
        (is_field && is_of_ray(value)).then(|| value.clone().placed_at(tree.at.clone()))
    };
    let with = all.iter().map(|it| Statement {
        value: it.value.map_nodes(&short),
        ..it.clone()
    });
    with.collect()
}

/// Returns true if two names differ in capitals and `_` at most.
fn is_same_name(one: &str, other: &str) -> bool {
    canonical(one) == canonical(other)
}

impl fmt::Display for SourceLine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}  {}", self.file, self.number, self.text)
    }
}
