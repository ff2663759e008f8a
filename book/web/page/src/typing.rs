//! Incremental reading: a statement at whose end the caret stands is still being typed, and what
//! it lacks is not wrong yet.

use std::ops::Range;

use interpreter::{Fault, FaultKind};

use crate::typed::Draft;

/// The end of a line, where a reader types.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Caret {
    /// The place of the file among those of the reader.
    pub file: usize,
    /// The line, counted from 1.
    pub line: usize,
}

/// So wide a picture shows what the compiler would refuse.
const WIDTH: u32 = 16;

impl Draft {
    /// Returns the line that is being typed, if these faults may come only from what is missing
    /// at its end: a bracket; or they are all in its statement, or without that there are none.
    pub(crate) fn unfinished_line(&self, faults: &[Fault]) -> Option<usize> {
        let caret = self.caret?;
        let before = self.text_before(caret)?;
        let text = &self.files[caret.file].text;
        if is_nested(before) && !is_nested(text) {
            return Some(caret.line);
        }
        let statement = statement(before);
        // What a bracket ends may go on behind it.
        let first = match &statement {
            Some(it) => 1 + before[..it.start].matches('\n').count(),
            None if before.ends_with('}') => caret.line,
            None => return None,
        };
        let is_there = |fault: &Fault| {
            let place = fault.place.as_ref();
            place.is_some_and(|it| {
                self.typed(it.file) == caret.file && (first..=caret.line).contains(&it.line)
            })
        };
        let is_alone = faults.iter().all(is_there)
            || statement.is_some_and(|statement| self.is_read_without(statement));
        is_alone.then_some(caret.line)
    }

    /// Returns the line that is being typed, if its statement is how one of the chapter begins.
    pub(crate) fn begun_line(&self) -> Option<usize> {
        let caret = self.caret?;
        let name = &self.files.get(caret.file)?.name;
        let text = self.text_before(caret)?;
        let typed = without_blanks(&text[statement(text)?]);
        let (_, theirs) = self.chapter.files().iter().find(|(it, _)| it == name)?;
        let theirs = without_blanks(theirs);
        let mut begun = theirs.match_indices(&typed);
        let goes_on = |end: usize| !theirs[end..].starts_with([';', '}']);
        begun
            .any(|(at, it)| goes_on(at + it.len()))
            .then_some(caret.line)
    }

    /// Returns what is typed up to the caret.
    fn text_before(&self, caret: Caret) -> Option<&str> {
        let text = &self.files.get(caret.file)?.text;
        let lines = text.split_inclusive('\n').take(caret.line);
        Some(text[..lines.map(str::len).sum()].trim_end())
    }

    /// Returns true if the compiler refuses nothing of the text without this part of it.
    fn is_read_without(&self, part: Range<usize>) -> bool {
        let mut rest = self.clone();
        if let Some(caret) = rest.caret.take() {
            let blank = |letter| if letter == '\n' { letter } else { ' ' };
            let text = &mut rest.files[caret.file].text;
            let blank: String = text[part.clone()].chars().map(blank).collect();
            text.replace_range(part, &blank);
        }
        let program = interpreter::read(&rest.in_reading_order());
        let fault = match program.map(|it| it.draw(WIDTH)) {
            Ok(drawn) => drawn.err(),
            Err(faults) => faults.into_iter().next(),
        };
        fault.is_none_or(|it| it.kind != FaultKind::Refused)
    }
}

/// Returns where the statement stands with which the text ends, if it has no end yet.
fn statement(text: &str) -> Option<Range<usize>> {
    let start = text.rfind([';', '{', '}']).map_or(0, |at| at + 1);
    let start = text.len() - text[start..].trim_start().len();
    (start < text.len()).then_some(start..text.len())
}

/// Returns true if each bracket that closes belongs to the last open one.
fn is_nested(text: &str) -> bool {
    let code = text
        .lines()
        .map(|line| line.split("//").next().unwrap_or(line));
    let mut open = Vec::new();
    for letter in code.flat_map(str::chars) {
        let closed = match letter {
            '(' | '[' | '{' => {
                open.push(letter);
                continue;
            }
            ')' => '(',
            ']' => '[',
            '}' => '{',
            _ => continue,
        };
        if open.pop() != Some(closed) {
            return false;
        }
    }
    true
}

fn without_blanks(text: &str) -> String {
    text.split_whitespace().collect()
}
