//! Comparison word by word: the statements of a reader's files beside those of a chapter.

use std::ops::Range;

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use super::{LineStatus, SourceFile, SourceLine, likeness};
use crate::search::squeezed;

/// Above this [likeness](likeness()) a line is one of the chapter's with a mistake in it.
const MISTAKEN: f64 = 0.75;

/// A statement of Rust, or the head of a block.
#[derive(Clone, Debug)]
struct Statement {
    /// The words, without `let`, `return`, `Some(…)` around the rest, and types.
    words: Vec<String>,
    /// The bytes of the text from the first of these words to the last.
    at: Range<usize>,
    /// The code of these bytes on one line.
    text: String,
}

/// A statement of a reader's file.
#[derive(Clone, Debug)]
pub(super) struct TypedStatement {
    statement: Statement,
    line: SourceLine,
}

/// A chapter's statements beside those that a reader typed.
pub(crate) struct LineComparison<'a> {
    chapter: Vec<Statement>,
    typed: &'a [TypedStatement],
}

/// The statements that an edit takes from functions of a chapter, and those that it adds.
pub(crate) struct StatementDiff {
    lost: Vec<Statement>,
    added: Vec<Statement>,
}

/// A reader's line with a mistake, and what should be in its place.
#[derive(Clone, Debug)]
pub(crate) struct CorrectedLine {
    /// The line as it is.
    pub(crate) line: SourceLine,
    /// The line as it should be; empty where nothing should be.
    pub(crate) right: String,
}

impl<'a> LineComparison<'a> {
    /// Takes the texts of a chapter's functions, and a reader's statements.
    pub(super) fn new<'f>(
        functions: impl Iterator<Item = &'f str>,
        typed: &'a [TypedStatement],
    ) -> Self {
        let chapter = functions.flat_map(statements).collect();
        Self { chapter, typed }
    }

    /// Returns true if the reader's statements are not known.
    pub(crate) fn is_empty(&self) -> bool {
        self.typed.is_empty()
    }

    /// Tells whether the reader has made an edit of the chapter. The edit is made if a statement
    /// that it adds is typed more often than it occurs in the chapter, and not made if one that it
    /// takes is typed as often as there; or, if it adds none, a similar one is typed in the place.
    pub(crate) fn status(&self, edit: &StatementDiff) -> LineStatus {
        let stands = |it: &Statement| self.chapter.iter().filter(|own| own.is_same(it)).count();
        let is_right =
            |it: &Statement| self.times_typed(it) > 0 && self.times_typed(it) >= stands(it);
        // If a line is left out, none that is much like it stands in its place.
        let is_mistaken = |it: &Statement| edit.added.is_empty() && self.closest(it) > MISTAKEN;
        let is_made = |it: &Statement| self.times_typed(it) > stands(it);
        if edit.lost.iter().any(|it| is_right(it) || is_mistaken(it)) {
            LineStatus::Right
        } else if edit.added.iter().any(is_made) {
            LineStatus::Wrong
        } else {
            LineStatus::NotFound
        }
    }

    /// Finds the reader's line that an edit adds, and corrects it by what the edit takes.
    pub(crate) fn corrected(&self, edit: &StatementDiff) -> Option<CorrectedLine> {
        edit.added.iter().find_map(|wrong| {
            let mut typed = self.typed.iter();
            let TypedStatement { statement, line } =
                typed.find(|it| it.statement.is_same(wrong))?;
            let right = edit.lost.iter().find(|it| it.words[0] == wrong.words[0]);
            let right = right.or(edit.lost.first());
            let corrected = |right: &Statement| line.text.replacen(&statement.text, &right.text, 1);
            Some(CorrectedLine {
                line: line.clone(),
                right: right.map(corrected).unwrap_or_default(),
            })
        })
    }

    fn times_typed(&self, it: &Statement) -> usize {
        let typed = self.typed.iter();
        typed.filter(|typed| typed.statement.is_same(it)).count()
    }

    /// Returns the greatest likeness of a statement to a line that the chapter does not have; 0 if
    /// there is no such line.
    fn closest(&self, it: &Statement) -> f64 {
        let typed = self.typed.iter().map(|typed| &typed.statement);
        let own = typed.filter(|typed| !self.chapter.iter().any(|it| it.is_same(typed)));
        let like = own.map(|own| likeness(&own.words, &it.words));
        like.fold(0.0, f64::max)
    }
}

impl StatementDiff {
    /// Compares functions, each given by its text, and its text with an edit.
    pub(crate) fn of<'f>(functions: impl Iterator<Item = (&'f str, &'f str)>) -> Self {
        let (mut lost, mut added) = (Vec::new(), Vec::new());
        for (right, wrong) in functions {
            let [right, wrong] = [right, wrong].map(statements);
            let only = |one: &[Statement], other: &[Statement]| {
                let is_new = |it: &&Statement| !other.iter().any(|other| it.is_same(other));
                one.iter().filter(is_new).cloned().collect::<Vec<_>>()
            };
            lost.extend(only(&right, &wrong));
            added.extend(only(&wrong, &right));
        }
        Self { lost, added }
    }
}

impl Statement {
    fn is_same(&self, other: &Self) -> bool {
        self.words == other.words
    }

    /// Makes a statement of the words of a text, each with its place; `None` if nothing is said.
    fn of(text: &str, words: &[(String, Range<usize>)]) -> Option<Self> {
        let is_said = |it: &&(String, _)| !["let", "mut", "return", "pub"].contains(&&*it.0);
        let unsaid = words.iter().take_while(|it| !is_said(it)).count();
        let mut words = &words[unsaid..];
        let some = |it: &str, n: usize| words.get(n).is_some_and(|word| word.0 == it);
        if some("Some", 0) && some("(", 1) && closing(&words[1..]) + 2 == words.len() {
            words = &words[2..words.len() - 1];
        }
        let at = words.first()?.1.start..words.last()?.1.end;
        let (name, rest) = words.split_at(1);
        let is_typed = unsaid > 0 && rest.first().is_some_and(|it| it.0 == ":");
        let kind = rest.iter().take_while(|it| is_typed && it.0 != "=").count();
        let words = name.iter().chain(&rest[kind..]);
        Some(Self {
            words: words.map(|it| it.0.clone()).collect(),
            text: squeezed(&text[at.clone()]),
            at,
        })
    }
}

/// Returns the index of the bracket that closes the first word, which opens one; 0 if none does.
fn closing(words: &[(String, Range<usize>)]) -> usize {
    let mut open = 0;
    let closes = |it: &(String, _)| {
        open += i32::from(it.0 == "(") - i32::from(it.0 == ")");
        open == 0
    };
    words.iter().position(closes).unwrap_or_default()
}

/// Reads the statements of a file.
pub(super) fn typed(file: &SourceFile) -> Vec<TypedStatement> {
    let SourceFile { name, text } = file;
    let typed = statements(text).into_iter().map(|statement| {
        let first = text[..statement.at.start].matches('\n').count();
        let count = text[statement.at.clone()].matches('\n').count() + 1;
        let lines: Vec<&str> = text.lines().skip(first).take(count).collect();
        let line = SourceLine {
            file: name.clone(),
            number: first + 1,
            text: squeezed(&lines.join("\n")),
        };
        TypedStatement { statement, line }
    });
    typed.collect()
}

/// Splits a text in Rust at semicolons and braces; empty if its brackets don't match.
fn statements(text: &str) -> Vec<Statement> {
    let words = words(text);
    let parts = words.split(|it| [";", "{", "}"].contains(&&*it.0));
    parts.filter_map(|it| Statement::of(text, it)).collect()
}

/// Splits a text in Rust into words and signs, each with its bytes, without comments and attributes;
/// empty if its brackets don't match.
pub(super) fn words(text: &str) -> Vec<(String, Range<usize>)> {
    let mut words = Vec::new();
    if let Ok(tokens) = text.parse() {
        add_words(tokens, &mut words);
    }
    words
}

fn add_words(tokens: TokenStream, words: &mut Vec<(String, Range<usize>)>) {
    let mut is_attribute = false;
    for token in tokens {
        match token {
            TokenTree::Punct(it) if it.as_char() == '#' => is_attribute = true,
            TokenTree::Group(_) if is_attribute => is_attribute = false,
            TokenTree::Group(group) => {
                let [open, close] = match group.delimiter() {
                    Delimiter::Brace => ["{", "}"],
                    Delimiter::Bracket => ["[", "]"],
                    _ => ["(", ")"],
                };
                words.push((open.to_owned(), group.span_open().byte_range()));
                add_words(group.stream(), words);
                words.push((close.to_owned(), group.span_close().byte_range()));
            }
            token => words.push((token.to_string(), token.span().byte_range())),
        }
    }
}
