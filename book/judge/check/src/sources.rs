//! Comparison word by word: which statements of a known mistake stand in a reader's files.

use std::fmt;
use std::ops::Range;

pub use interpreter::SourceFile;
use slips::{Chapter, ChapterProgram};

/// The files that a reader types for a chapter, in Rust; by default none.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    typed: Vec<(Statement, SourceLine)>,
    /// True if the files have as many words as the chapter's, less than a statement fewer.
    is_written: bool,
}

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

/// A reader's line with a mistake, and what should be in its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CorrectedLine {
    /// The line as it is.
    pub line: SourceLine,
    /// The line as it should be; empty where nothing should be.
    pub right: String,
}

/// The state of a mistake's line in a reader's files.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) enum LineStatus {
    /// The files have the line with the mistake in it.
    Wrong(CorrectedLine),
    /// The files have the line as it should be.
    Right,
    /// The files are unknown, or have neither line word by word.
    #[default]
    NotFound,
}

/// A statement, or the head of a block: its words and signs, and its bytes in the text.
#[derive(Clone, Debug)]
struct Statement {
    words: Vec<String>,
    at: Range<usize>,
}

/// The fewest words and signs of a statement: `return t * color;` has six.
const STATEMENT: usize = 6;

impl Sources {
    /// Takes the files of a reader who types a chapter's own files in Rust.
    pub fn of_chapter(yours: Vec<SourceFile>, chapter: Chapter) -> Self {
        let chapter = slips::typed_files(chapter);
        let is_typed = |it: &&SourceFile| chapter.iter().any(|own| own.name == it.name);
        let count = |it: &SourceFile| words(&it.text).len();
        let own: usize = yours.iter().filter(is_typed).map(count).sum();
        Self {
            is_written: own + STATEMENT > chapter.iter().map(count).sum(),
            typed: yours.iter().flat_map(typed).collect(),
        }
    }

    /// Returns true if no file of the reader is known.
    pub(crate) fn is_empty(&self) -> bool {
        self.typed.is_empty()
    }

    /// Returns true if the reader has typed as much as the whole chapter, right or wrong.
    pub(crate) fn is_written(&self) -> bool {
        self.is_written
    }

    /// Tells whether the reader has made the change from one program to another. It is made if a
    /// statement that it adds is typed more often than it stands in the right program, and not made
    /// if one that it takes away is typed as often as there.
    pub(crate) fn status(&self, right: &ChapterProgram, wrong: &ChapterProgram) -> LineStatus {
        if self.is_empty() {
            return LineStatus::NotFound;
        }
        let of = |it: &ChapterProgram| -> Vec<(String, Statement)> {
            let all = it.functions().flat_map(|(_, text)| {
                let all = statements(text).into_iter();
                all.map(move |it| (text.to_owned(), it))
            });
            all.collect()
        };
        let (right, wrong) = (of(right), of(wrong));
        let count = |all: &[(String, Statement)], it: &Statement| {
            all.iter()
                .filter(|(_, other)| other.words == it.words)
                .count()
        };
        let typed = |it: &Statement| {
            let typed = self.typed.iter();
            typed.filter(|(typed, _)| typed.words == it.words).count()
        };
        let lost = right
            .iter()
            .filter(|(_, it)| count(&wrong, it) < count(&right, it));
        let lost: Vec<_> = lost.collect();
        if lost.iter().any(|(_, it)| typed(it) >= count(&right, it)) {
            return LineStatus::Right;
        }
        let added = wrong.iter().find(|(_, it)| {
            let stands = count(&right, it);
            count(&wrong, it) > stands && typed(it) > stands
        });
        let line = added.and_then(|(_, wrong)| {
            let mut typed = self.typed.iter();
            let (statement, line) = typed.find(|(typed, _)| typed.words == wrong.words)?;
            let like = |(_, it): &&&(String, Statement)| it.words[0] == statement.words[0];
            let right = lost.iter().find(like).or(lost.first());
            let right = right.map_or(String::new(), |(text, it)| squeezed(&text[it.at.clone()]));
            Some(CorrectedLine {
                line: line.clone(),
                right,
            })
        });
        line.map_or(LineStatus::NotFound, LineStatus::Wrong)
    }
}

/// Lists the statements of a file, each with its line.
fn typed(file: &SourceFile) -> Vec<(Statement, SourceLine)> {
    let SourceFile { name, text } = file;
    let all = statements(text).into_iter().map(|statement| {
        let line = SourceLine {
            file: name.clone(),
            number: text[..statement.at.start].matches('\n').count() + 1,
            text: squeezed(&text[statement.at.clone()]),
        };
        (statement, line)
    });
    all.collect()
}

/// Splits a text in Rust at semicolons and braces, and leaves `let` and `return` out.
fn statements(text: &str) -> Vec<Statement> {
    let words = words(text);
    let parts = words.split(|at| [";", "{", "}"].contains(&&text[at.clone()]));
    let statement = |part: &[Range<usize>]| {
        let is_said =
            |at: &&Range<usize>| !["let", "mut", "return"].contains(&&text[(*at).clone()]);
        let unsaid = part.iter().take_while(|it| !is_said(it)).count();
        let part = &part[unsaid..];
        let at = part.first()?.start..part.last()?.end;
        let words = part.iter().map(|at| text[at.clone()].to_owned());
        Some(Statement {
            words: words.collect(),
            at,
        })
    };
    parts.filter_map(statement).collect()
}

/// Splits a text into words and signs, without comments and without commas before a bracket that
/// closes.
fn words(text: &str) -> Vec<Range<usize>> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let mut words: Vec<Range<usize>> = Vec::new();
    let mut at = 0;
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        let is_comment = rest.starts_with("//");
        let end = match first {
            _ if is_comment => rest.find('\n').unwrap_or(rest.len()),
            first if is_word(first) => rest.find(|c| !is_word(c)).unwrap_or(rest.len()),
            first => first.len_utf8(),
        };
        if ")]}".contains(first) && words.last().is_some_and(|it| &text[it.clone()] == ",") {
            words.pop();
        }
        if !is_comment && !first.is_whitespace() && first != '\u{feff}' {
            words.push(at..at + end);
        }
        at += end;
    }
    words
}

/// Writes code on one line, without comments, and with blanks where rustfmt has them.
pub(crate) fn squeezed(text: &str) -> String {
    let lines = text.lines();
    let code = lines.map(|line| line.split("//").next().unwrap_or(line));
    let words: Vec<&str> = code.flat_map(str::split_whitespace).collect();
    let loose = [
        ("( ", "("),
        (", )", ")"),
        (",)", ")"),
        (" )", ")"),
        (", }", " }"),
        (" .", "."),
        (",..", ", .."),
        (" ,", ","),
        (",\0", ", \0"),
    ];
    let text = words.join(" ");
    loose
        .iter()
        .fold(text, |text, (loose, tight)| text.replace(loose, tight))
}

impl fmt::Display for SourceLine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}  {}", self.file, self.number, self.text)
    }
}
