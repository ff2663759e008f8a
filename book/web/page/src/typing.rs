//! Incremental reading: a statement at whose end the caret stands is still being typed, so that its
//! faults may be missing words and not mistakes.

use std::ops::Range;

use interpreter::{Fault, FaultKind, SourceFile, Span};
use slips::ChapterCode;

use crate::typed::Draft;

/// The line of a draft at whose end a reader is typing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Caret {
    /// The index of its file in [`Draft::files`], from 0.
    pub file: usize,
    /// The line, counted from 1.
    pub line: usize,
    /// True if the reader has rested since the last letter: only what cannot be read yet, or has no
    /// result yet, is then unfinished.
    pub rests: bool,
}

impl Draft {
    /// Returns the caret's line if the fault may come only from missing words at its end: it lies in
    /// the caret's statement, or the text without that statement has none. While the reader rests,
    /// this holds only for a text that can be read up to the caret's line.
    pub(crate) fn unfinished_line(&self, fault: &Fault) -> Option<usize> {
        let caret = self.caret?;
        let line = |it: Span| (usize::from(it.file) == caret.file).then_some(it.line as usize);
        let is_above = |it: Span| line(it).is_none_or(|line| line < caret.line);
        let is_open = is_unread(fault) && !fault.place().is_some_and(is_above);
        if caret.rests && !is_open {
            return None;
        }
        let before = self.text_before(caret)?;
        let statement = statement(before);
        // What a bracket ends may go on behind it.
        let first = match &statement {
            Some(it) => 1 + before[..it.start].matches('\n').count(),
            None if before.ends_with('}') => caret.line,
            None => return None,
        };
        let lines = first..=caret.line;
        let is_there = fault
            .place()
            .and_then(line)
            .is_some_and(|it| lines.contains(&it));
        let is_alone = || statement.is_some_and(|it| self.is_read_without(it));
        (is_there || is_alone()).then_some(caret.line)
    }

    /// Returns the caret's line if it is the beginning of one of the chapter's that lacks more than a
    /// semicolon, and the reader does not rest.
    pub(crate) fn begun_line(&self) -> Option<usize> {
        let caret = self.caret.filter(|it| !it.rests)?;
        let SourceFile { name, text } = self.files.get(caret.file)?;
        let typed = without_blanks(text.lines().nth(caret.line.checked_sub(1)?)?);
        let theirs = self.chapter.files().iter().find(|it| it.name == name)?;
        let mut theirs = theirs.text.lines().map(without_blanks);
        let is_begun = theirs.any(|it| it.starts_with(&typed) && it.len() > typed.len() + 1);
        (is_begun && !typed.is_empty()).then_some(caret.line)
    }

    /// Returns the caret's file up to the end of its line, without blanks there, or `None` if there is
    /// no such file.
    fn text_before(&self, caret: Caret) -> Option<&str> {
        let text = &self.files.get(caret.file)?.text;
        let lines = text.split_inclusive('\n').take(caret.line);
        Some(text[..lines.map(str::len).sum()].trim_end())
    }

    /// Returns true if a compiler would take the caret's file with nothing in place of `part`, or
    /// with a `todo!()`.
    fn is_read_without(&self, part: Range<usize>) -> bool {
        ["", "todo!()"].iter().any(|instead| {
            let mut rest = self.clone();
            if let Some(caret) = rest.caret.take() {
                let text = &mut rest.files[caret.file].text;
                text.replace_range(part.clone(), instead);
            }
            let drawn = interpreter::read(&rest.files).and_then(|it| it.draw(TRIAL_WIDTH));
            let kind = drawn.err().map(|it| it.kind);
            !matches!(kind, Some(FaultKind::Unparsed | FaultKind::Refused))
        })
    }
}

/// The width, in pixels, of a picture that is drawn only to find faults.
const TRIAL_WIDTH: u32 = 24;

/// Returns true for a fault of the grammar: the text cannot be read at its place, or ends too early.
fn is_unread(fault: &Fault) -> bool {
    matches!(fault.kind, FaultKind::Unparsed | FaultKind::Unfinished)
}

/// Returns the range of bytes of the last statement, if no `;`, `{` or `}` ends it.
fn statement(text: &str) -> Option<Range<usize>> {
    let start = text.rfind([';', '{', '}']).map_or(0, |at| at + 1);
    let start = text.len() - text[start..].trim_start().len();
    (start < text.len()).then_some(start..text.len())
}

/// Returns the text without blanks and line breaks.
fn without_blanks(text: &str) -> String {
    text.split_whitespace().collect()
}
