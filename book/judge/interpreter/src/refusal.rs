//! What is wrong with a text, and where: in bytes until it is said, in lines and columns then.

use std::fmt;
use std::ops::Range;

use crate::program::UncheckedLines;

/// A reason why a text does not run, with its place and words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Its place, if it has one in the text.
    pub place: Option<SourceSpan>,
    /// The message, in the words of the compiler where it has some.
    pub message: String,
    /// The words below the place, or none.
    pub label: String,
    /// A sentence that says what to do, or nothing.
    pub help: String,
    /// Who finds it: the compiler, the running program, or this page alone.
    pub kind: FaultKind,
}

/// The reason why a text does not run here.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FaultKind {
    /// The compiler refuses it.
    Refused,
    /// It ends too early: a bracket is open, or a function has no result so far.
    Unfinished,
    /// The compiler may take it, and it is not read here.
    Unread,
    /// It compiles, and stops when it runs.
    Stopped,
}

/// A place in a text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SourceSpan {
    /// The number of the file, counted from 0.
    pub file: usize,
    /// The line, counted from 1.
    pub line: usize,
    /// The columns, counted in characters from 0. The end may be beyond that of the line.
    pub columns: Range<usize>,
}

/// A place in the texts: the file, and the bytes.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Span {
    pub(crate) file: u32,
    pub(crate) start: u32,
    pub(crate) end: u32,
}

/// A fault, whose place is in bytes so far.
#[derive(Clone, Debug)]
pub(crate) struct Refusal {
    at: Span,
    message: String,
    label: String,
    help: String,
    pub(crate) kind: FaultKind,
}

impl Refusal {
    /// Makes one of what the compiler refuses.
    pub(crate) fn new(at: Span, message: impl Into<String>, label: &str, help: &str) -> Self {
        Self {
            at,
            message: message.into(),
            label: label.to_owned(),
            help: help.to_owned(),
            kind: FaultKind::Refused,
        }
    }

    /// Returns the refusal as that of a text that ends too early.
    pub(crate) fn unfinished(self) -> Self {
        Self {
            kind: FaultKind::Unfinished,
            ..self
        }
    }

    /// Makes one of what the compiler may take, and is not read here.
    pub(crate) fn unread(at: Span, what: &str) -> Self {
        Self {
            kind: FaultKind::Unread,
            ..Self::new(
                at,
                format!("this page does not read {what}"),
                "",
                "cargo may",
            )
        }
    }

    /// Says that a call has too many arguments, or too few.
    pub(crate) fn miscounted(is_method: bool, wanted: usize, count: usize, at: Span) -> Self {
        let what = if is_method { "method" } else { "function" };
        let several = |n: usize| if n == 1 { "argument" } else { "arguments" };
        let was = if count == 1 { "was" } else { "were" };
        let message = format!(
            "this {what} takes {wanted} {} but {count} {} {was} supplied",
            several(wanted),
            several(count)
        );
        Self::new(at, message, "", "")
    }

    /// Finds whether it is about this place.
    pub(crate) fn is_at(&self, at: Span) -> bool {
        (self.at.file, self.at.start, self.at.end) == (at.file, at.start, at.end)
    }

    /// Returns the refusal with other help, if there is some.
    pub(crate) fn or_help(mut self, help: &str) -> Self {
        if !help.is_empty() {
            help.clone_into(&mut self.help);
        }
        self
    }

    /// Says that a program that has begun stops.
    pub(crate) fn stop(at: Span, message: &str, help: &str) -> Self {
        Self {
            kind: FaultKind::Stopped,
            ..Self::new(at, message, "the program stops here", help)
        }
    }

    pub(crate) fn fault(self, texts: &[String]) -> Fault {
        Fault {
            place: place(texts, self.at),
            message: self.message,
            label: self.label,
            help: self.help,
            kind: self.kind,
        }
    }
}

/// Finds the line and the columns of a place, as far as its first line goes.
pub(crate) fn place(texts: &[String], at: Span) -> Option<SourceSpan> {
    let text = texts.get(at.file as usize).filter(|_| at.end > 0)?;
    let before = text.get(..at.start as usize)?;
    let said = text.get(at.start as usize..at.end as usize)?;
    let start = before.chars().rev().take_while(|&it| it != '\n').count();
    let end = if said.contains('\n') {
        usize::MAX
    } else {
        start + said.chars().count().max(1)
    };
    Some(SourceSpan {
        file: at.file as usize,
        line: before.matches('\n').count() + 1,
        columns: start..end,
    })
}

/// Finds from which line of which file to which a part of a text goes.
pub(crate) fn lines(texts: &[String], at: Span) -> Option<UncheckedLines> {
    let first = place(texts, at)?;
    let said = texts[first.file].get(at.start as usize..at.end as usize)?;
    let last = first.line + said.trim_end().matches('\n').count();
    Some(UncheckedLines {
        file: first.file,
        lines: first.line..=last,
    })
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(place) = &self.place {
            write!(f, "line {}: ", place.line)?;
        }
        f.write_str(&self.message)?;
        for more in [&self.label, &self.help] {
            if !more.is_empty() {
                write!(f, "; {more}")?;
            }
        }
        Ok(())
    }
}
