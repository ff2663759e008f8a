//! Diagnostics: what is wrong with a text, one plain sentence each, and where.

use std::fmt;

use syn::spanned::Spanned;

/// A place in the files of a program: columns of one line. Line 0 is no place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Span {
    /// The index of the file in the list that was given to [`read`](crate::read()), from 0.
    pub file: u16,
    /// The line, from 1.
    pub line: u32,
    /// The first column, in characters from 0.
    pub start: u32,
    /// The column behind the last; `u32::MAX` if the place goes on in the next line.
    pub end: u32,
}

/// The number of the first file of the prelude; the reader's files have smaller ones.
pub(crate) const PRELUDE: u16 = 1000;

impl Span {
    /// Returns the place of a piece of syntax.
    pub(crate) fn of(file: u16, piece: &impl Spanned) -> Self {
        Self::of_span(file, piece.span())
    }

    /// Returns the place of a token.
    pub(crate) fn of_span(file: u16, span: proc_macro2::Span) -> Self {
        let (first, last) = (span.start(), span.end());
        Self {
            file,
            line: first.line as u32,
            start: first.column as u32,
            end: match first.line == last.line {
                true => last.column as u32,
                false => u32::MAX,
            },
        }
    }
}

/// A kind of fault: who would find it, and when. Faults are listed in the order of these kinds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FaultKind {
    /// The text is no Rust: it can't be parsed at its place.
    Unparsed,
    /// The compiler would refuse the text.
    Refused,
    /// The text ends too early: a bracket is open, or a function has no result so far.
    Unfinished,
    /// The compiler may accept the text, but this interpreter does not read it.
    Unread,
    /// The program stops: a panic, or a budget that is used up.
    Stopped,
}

/// A reason why a text can't be run, or why it stops.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    at: Span,
    /// One line of plain text without a full stop. For a fault of the kind [`FaultKind::Unread`],
    /// the words that are not read.
    pub message: String,
    /// Who would find the fault.
    pub kind: FaultKind,
}

impl Fault {
    /// Makes a fault of any kind.
    pub fn new(kind: FaultKind, at: Span, message: impl Into<String>) -> Self {
        let message = message.into();
        Self { at, message, kind }
    }

    /// Makes the fault of a text that the compiler would refuse.
    pub(crate) fn refused(at: Span, message: impl Into<String>) -> Self {
        Self::new(FaultKind::Refused, at, message)
    }

    /// Makes the fault of words that this interpreter does not read.
    pub(crate) fn unread(at: Span, words: impl Into<String>) -> Self {
        Self::new(FaultKind::Unread, at, words)
    }

    /// Adds a question about the nearest known word, if one is near.
    pub(crate) fn or_meant<'k>(
        mut self,
        word: &str,
        known: impl IntoIterator<Item = &'k str>,
    ) -> Self {
        let lower = word.to_lowercase();
        let likeness = |name: &'k str| {
            let likeness = strsim::jaro_winkler(&lower, &name.to_lowercase());
            (likeness, name)
        };
        let near = known.into_iter().map(likeness);
        let near = near.filter(|(likeness, name)| *likeness > LIKE && *name != word);
        let nearest = near.max_by(|one, other| one.0.total_cmp(&other.0).then(other.1.cmp(one.1)));
        if let Some((_, name)) = nearest {
            self.message += &format!("; did you mean `{name}`?");
        }
        self
    }

    /// Makes the fault of a call with too many or too few arguments.
    pub(crate) fn miscounted(at: Span, wanted: usize, given: usize) -> Self {
        let plural = if wanted == 1 { "" } else { "s" };
        let message = format!("this takes {wanted} argument{plural}, and gets {given}");
        Self::refused(at, message)
    }

    /// Moves the fault from the prelude's text to the reader's line that called it.
    pub(crate) fn called_at(&mut self, at: Span) {
        if self.at.file >= PRELUDE {
            self.at = at;
        }
    }

    /// Returns the place in the reader's files; `None` if the fault has none there.
    pub fn place(&self) -> Option<Span> {
        Some(self.at).filter(|at| at.line > 0 && at.file < PRELUDE)
    }
}

/// How like two words have to be, by Jaro and Winkler, for one to be taken for the other.
const LIKE: f64 = 0.8;

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(place) = self.place() {
            write!(f, "line {}: ", place.line)?;
        }
        if self.kind == FaultKind::Unread {
            f.write_str("this page cannot read ")?;
        }
        f.write_str(&self.message)
    }
}
