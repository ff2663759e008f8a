//! Diagnostics: what is wrong with a text, and where; in bytes while it is read and run, in lines
//! and columns for its reader.

use std::fmt;
use std::ops::Range;

use crate::program::UncheckedLines;

/// A reason why a program's text can't be run, or why the program stops: its place and its words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The place in the text; `None` if the fault has none, as when a function is missing from all
    /// files.
    pub place: Option<SourceSpan>,
    /// The main message, one line without a full stop; in the compiler's words where rustc has a
    /// message for this.
    pub message: String,
    /// The words that a compiler would write below the place, one line; empty if there are none.
    pub label: String,
    /// A hint at what to do, one line; empty if there is none.
    pub help: String,
    /// Who finds the fault: the compiler, the running program, or this interpreter alone.
    pub kind: FaultKind,
}

/// A kind of fault: who would find it, and when. Faults are listed in the order of these kinds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FaultKind {
    /// The compiler would refuse the text.
    Refused,
    /// The text ends too early: a bracket is open, or a function has no result so far.
    Unfinished,
    /// The compiler may accept the text, but this interpreter does not read it.
    Unread,
    /// The text compiles, and the program stops when it runs: a panic, or a budget that is used up.
    Stopped,
}

/// A place in the files of a program: columns of one line.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SourceSpan {
    /// The index of the file in the list that was given to [`read`](crate::read()), from 0.
    pub file: usize,
    /// The number of the line in the file, from 1.
    pub line: usize,
    /// The columns, in characters from 0, the end excluded. A place that goes on in the next line
    /// ends at `usize::MAX`.
    pub columns: Range<usize>,
}

/// A place in the files as bytes: it may go over several lines. An `end` of 0 means no place.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Span {
    pub(crate) file: u32,
    pub(crate) start: u32,
    pub(crate) end: u32,
}

/// A fault whose place is in bytes so far.
#[derive(Clone, Debug)]
pub(crate) struct Refusal {
    at: Span,
    message: String,
    label: String,
    help: String,
    pub(crate) kind: FaultKind,
}

impl Refusal {
    /// Makes a refusal of what the compiler would refuse. `label` and `help` may be empty.
    pub(crate) fn new(at: Span, message: impl Into<String>, label: &str, help: &str) -> Self {
        Self {
            at,
            message: message.into(),
            label: label.to_owned(),
            help: help.to_owned(),
            kind: FaultKind::Refused,
        }
    }

    /// Turns the refusal into that of a text which ends too early.
    pub(crate) fn unfinished(self) -> Self {
        Self {
            kind: FaultKind::Unfinished,
            ..self
        }
    }

    /// Makes a refusal of what the compiler may accept and this interpreter does not read.
    pub(crate) fn unread(at: Span, what: &str) -> Self {
        let message = format!("this page does not read {what}");
        Self {
            kind: FaultKind::Unread,
            ..Self::new(at, message, "", "cargo may")
        }
    }

    /// Makes the refusal of a call with too many or too few arguments, in the compiler's words.
    pub(crate) fn miscounted(is_method: bool, wanted: usize, count: usize, at: Span) -> Self {
        let what = if is_method { "method" } else { "function" };
        let was = if count == 1 { "was" } else { "were" };
        let [wanted, count] = [wanted, count].map(arguments);
        let message = format!("this {what} takes {wanted} but {count} {was} supplied");
        Self::new(at, message, "", "")
    }

    /// Returns true if the refusal is about exactly this span.
    pub(crate) fn is_at(&self, at: Span) -> bool {
        (self.at.file, self.at.start, self.at.end) == (at.file, at.start, at.end)
    }

    /// Replaces the help, unless the new one is empty.
    pub(crate) fn or_help(mut self, help: &str) -> Self {
        if !help.is_empty() {
            help.clone_into(&mut self.help);
        }
        self
    }

    /// Makes the refusal of a program that stops while it runs.
    pub(crate) fn stop(at: Span, message: &str, help: &str) -> Self {
        Self {
            kind: FaultKind::Stopped,
            ..Self::new(at, message, "the program stops here", help)
        }
    }

    /// Turns the refusal into a fault, whose line and columns these texts show.
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

/// Returns a count of arguments in words.
pub(crate) fn arguments(count: usize) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} argument{plural}")
}

/// Finds the line and the columns of a span, as far as its first line goes; `None` for no place.
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

/// Finds the lines over which a span goes; `None` for no place.
pub(crate) fn lines(texts: &[String], at: Span) -> Option<UncheckedLines> {
    let first = place(texts, at)?;
    let said = texts[first.file].get(at.start as usize..at.end as usize)?;
    let last = first.line + said.trim_end().matches('\n').count();
    Some(UncheckedLines {
        file: first.file,
        lines: first.line..=last,
    })
}

impl Fault {
    /// Makes a fault without a place in the text.
    pub(crate) fn without_place(kind: FaultKind, message: String) -> Self {
        Self {
            place: None,
            message,
            label: String::new(),
            help: String::new(),
            kind,
        }
    }
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
