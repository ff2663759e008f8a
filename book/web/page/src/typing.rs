//! Incremental reading: a line at whose end the caret stands is still being typed, so that a fault
//! there, or below, may be a missing word and not a mistake.

use interpreter::{Fault, FaultKind};
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
    /// Returns the caret's line if the fault may come only from missing words at its end: the line is
    /// not finished, and the fault does not lie above. While the reader rests, this holds only for a
    /// text that cannot be read.
    pub(crate) fn unfinished_line(&self, fault: &Fault) -> Option<usize> {
        let caret = self.caret?;
        let line = self.text_at(caret)?;
        let is_above = fault.place().is_some_and(|it| {
            usize::from(it.file) != caret.file || (it.line as usize) < caret.line
        });
        let is_unread = matches!(fault.kind, FaultKind::Unparsed | FaultKind::Unfinished);
        let is_finished = line.ends_with([';', '{']);
        let may_go_on = is_unread || !line.is_empty() && !caret.rests;
        (!is_finished && !is_above && may_go_on).then_some(caret.line)
    }

    /// Returns the caret's line if it is the beginning of one of the chapter's that lacks more than a
    /// semicolon, and the reader does not rest.
    pub(crate) fn begun_line(&self) -> Option<usize> {
        let caret = self.caret.filter(|it| !it.rests)?;
        let typed = without_blanks(self.text_at(caret)?);
        let name = &self.files[caret.file].name;
        let theirs = self.chapter.files().iter().find(|it| it.name == name)?;
        let mut theirs = theirs.text.lines().map(without_blanks);
        let is_begun = theirs.any(|it| it.starts_with(&typed) && it.len() > typed.len() + 1);
        (is_begun && !typed.is_empty()).then_some(caret.line)
    }

    /// Returns the text of the caret's line without blanks at its end, or `None` if there is no such
    /// line.
    fn text_at(&self, caret: Caret) -> Option<&str> {
        let text = &self.files.get(caret.file)?.text;
        text.lines()
            .nth(caret.line.checked_sub(1)?)
            .map(str::trim_end)
    }
}

/// Returns the text without blanks and line breaks.
fn without_blanks(text: &str) -> String {
    text.split_whitespace().collect()
}
