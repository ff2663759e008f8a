//! What a reader wrote: files in ten languages, and the statements in them.

mod lines;

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt;

use language::{Language, Role, Statement, Tree, canonical, functions, normal, statements};
use slips::{Chapter, Edition, Slip};

pub use interpreter::SourceFile;

use crate::task::Task;

pub(crate) use lines::{CorrectedLine, LineComparison, StatementDiff, Transplant};

/// What a reader wrote, and the chapter as it should be.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    yours: Vec<SourceFile>,
    chapter: Vec<SourceFile>,
    typed: Vec<TypedStatement>,
    /// What was said of slips in scenes, which is asked again and again.
    said: RefCell<BTreeMap<Key, (LineStatus, Option<CorrectedLine>)>>,
}

/// A slip by its name and its place in memory, in a chapter of an edition.
type Key = (&'static str, usize, Chapter, Edition, Option<usize>);

/// A line that somebody typed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SourceLine {
    /// The file, as seen from the folder of the program.
    pub file: String,
    /// Its number, from 1.
    pub number: usize,
    /// What it says.
    pub text: String,
}

/// What a reader's files say of a slip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LineStatus {
    /// The wrong line is there.
    Wrong,
    /// The line is right.
    Right,
    /// Neither is found.
    NotFound,
}

/// A statement that somebody typed.
#[derive(Clone, Debug)]
pub(crate) struct TypedStatement {
    pub(crate) line: SourceLine,
    language: Language,
    role: Role,
    /// The expression as it stands there, and its normal form.
    value: Tree,
    normal: Tree,
}

/// So many tokens are less than a statement: `return t * color;` has six.
const STATEMENT: usize = 6;

impl Sources {
    /// The files by their names and texts: the reader's, and those of the chapter if the
    /// reader types just these.
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
            said: RefCell::default(),
        }
    }

    /// Returns what they say of a slip in a scene, and the line that makes it, if that is found.
    pub(crate) fn say(&self, slip: &Slip, task: &Task) -> (LineStatus, Option<CorrectedLine>) {
        if self.typed.is_empty() {
            return (LineStatus::NotFound, None);
        }
        let task = task.unchanged();
        let key = (
            slip.name,
            std::ptr::from_ref(slip) as usize,
            task.chapter,
            task.edition,
            task.step(),
        );
        if let Some(said) = self.said.borrow().get(&key) {
            return said.clone();
        }
        let said = self.says(slip, &task);
        self.said.borrow_mut().insert(key, said.clone());
        said
    }

    fn says(&self, slip: &Slip, task: &Task) -> (LineStatus, Option<CorrectedLine>) {
        let (right, wrong) = (task.program(&[]), task.program(&[slip]));
        let pairs = right.functions().zip(wrong.functions());
        let changed = pairs.filter(|((_, right), (_, wrong))| right != wrong);
        let change =
            StatementDiff::of(changed.map(|((name, right), (_, wrong))| (name, right, wrong)));
        let lines = LineComparison::new(right.functions(), &self.typed);
        match lines.say(&change) {
            // What an older edition has is wrong in a mixture only, which no single line tells.
            LineStatus::Wrong
                if change.is_in(Edition::V3.program(task.chapter).functions())
                    && self.in_rust().is_empty() =>
            {
                (LineStatus::NotFound, None)
            }
            LineStatus::Wrong => (LineStatus::Wrong, lines.found(&change)),
            said => (said, None),
        }
    }

    /// The files of a reader who types the chapter, beside its own.
    pub fn of_chapter(yours: Vec<SourceFile>, chapter: Chapter) -> Self {
        Self::new(yours, slips::typed_files(chapter))
    }

    /// Returns true if they are those of the chapter and no other program.
    pub(crate) fn are_of_the_chapter(&self) -> bool {
        !self.chapter.is_empty()
    }

    /// Returns those in Rust but for the program's own, the root first.
    pub(crate) fn in_rust(&self) -> Vec<SourceFile> {
        let is_read = |it: &&SourceFile| it.name.ends_with(".rs") && !it.name.ends_with("main.rs");
        let mut files: Vec<_> = self.yours.iter().filter(is_read).cloned().collect();
        files.sort_by_key(|it| !it.name.ends_with("lib.rs"));
        files
    }

    /// Returns all of them, by their names and texts.
    pub(crate) fn files(&self) -> &[SourceFile] {
        &self.yours
    }

    /// Returns true if nothing is known of them.
    pub(crate) fn is_empty(&self) -> bool {
        self.yours.is_empty()
    }

    /// Lists what was typed, statement by statement.
    pub(crate) fn typed(&self) -> &[TypedStatement] {
        &self.typed
    }

    /// Returns true if the chapter's functions are as long as there, right or wrong, but for less
    /// than a statement. What stands in functions of the reader's own counts with them.
    pub(crate) fn is_written(&self) -> bool {
        let [chapter, yours] = [&self.chapter, &self.yours].map(|files| {
            let files = files.iter();
            files.map(|it| functions(&it.text)).collect::<Vec<_>>()
        });
        let is_of_chapter = |name: &str| chapter.iter().flatten().any(|(it, _)| *it == name);
        // A prelude has none of the chapter's functions, and `start` gives a sky.
        let counts = |functions: &&Vec<(&str, usize)>| {
            let mut functions = functions.iter();
            functions.any(|(name, _)| *name != "new" && is_of_chapter(name))
        };
        let own = yours.iter().filter(counts).flatten();
        let own = own.filter(|(name, _)| *name != "sky").map(|(_, size)| size);
        let theirs = chapter.iter().flatten().map(|(_, size)| size);
        self.are_of_the_chapter() && own.sum::<usize>() + STATEMENT > theirs.sum()
    }
}

/// Reads the statements of a file, if its language is known.
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

/// Reads the statements of a text. What is added to a world is one of its own, however that is
/// done.
fn read(text: &str, language: Language) -> Vec<Statement> {
    let all = statements(text, language).into_iter();
    let parts = all.flat_map(|it| {
        let nodes = it.value.nodes().into_iter();
        let spheres = nodes.filter(|node| normal(node).is_call("sphere"));
        let added: Vec<Statement> = spheres
            .map(|value| Statement {
                role: Role::Done,
                value: value.clone(),
                at: it.at.clone(),
            })
            .collect();
        if added.is_empty() { vec![it] } else { added }
    });
    parts.collect()
}

/// Puts what has a name of its own only to be shorter, `d = r.direction`, in the place of it.
fn with_values(all: Vec<Statement>) -> Vec<Statement> {
    let given = |name: &str| {
        let is_it = |it: &&Statement| matches!(&it.role, Role::Given(own) if own == name);
        let mut found = all.iter().filter(is_it);
        found.next().filter(|_| found.next().is_none())
    };
    let short = |tree: &Tree| {
        let value = &given(tree.name()?)?.value;
        let is_field = matches!(&value.parts[..], [of] if of.name().is_some());
        let is_of_ray = |it: &Tree| matches!(&normal(it).op, language::Op::Call(name) if name == "direction" || name == "origin");
        (is_field && is_of_ray(value)).then(|| value.clone().at(tree.at.clone()))
    };
    let with = all.iter().map(|it| Statement {
        value: it.value.mapped(&short),
        ..it.clone()
    });
    with.collect()
}

/// Returns true if two names are the same but for capitals and `_`.
fn is_same_name(one: &str, other: &str) -> bool {
    canonical(one) == canonical(other)
}

impl fmt::Display for SourceLine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}  {}", self.file, self.number, self.text)
    }
}
