//! The answer to a reader as data: a headline, rows, pictures, and what to do next.
//!
//! [`Attempt::answer`](crate::attempt::Attempt::answer) makes one, with the sentences of
//! [`sentences`](crate::sentences); [`text`](crate::text) lays it out in a terminal,
//! [`html`](crate::html) in a page.

use std::fmt;

use common::rtweekend::Picture;
use slips::Slip;

use crate::verdict::Verdict;

/// The answer to a reader about a picture or a program.
#[derive(Debug, Default)]
pub struct Answer {
    /// The verdict in a sentence.
    pub headline: Headline,
    /// The explanation of the verdict, the most important row first; empty if the headline says
    /// all.
    pub rows: Vec<Row>,
    /// The reader's picture and the right one; `None` if there is nothing to compare, as for a file
    /// that can't be read, or if the picture is right only within a tolerance.
    pub pictures: Option<Pictures>,
    /// The slips (known mistakes) that were made; the [page](Slip::page) of each tells how its line
    /// is right. Empty if none was found.
    pub read: Vec<&'static Slip>,
    /// Advice on what to do next, in plain text; empty if there is none, or if the rows give it.
    pub next: String,
    /// Lines to add to the reader's list of done things, in plain text; empty if there are none.
    pub done: Vec<String>,
}

/// The first sentence of an answer, split around its verdict: `wrong` in `sign.png is wrong: 3 of
/// 90 pixels …`.
#[derive(Debug, Default)]
pub struct Headline {
    /// The grade, which gives the verdict its color.
    pub grade: Grade,
    /// The name of what is judged, such as a file's; empty if the verdict is a whole sentence.
    pub subject: String,
    /// The verdict: what follows `subject is`, such as `wrong`; or a whole sentence.
    pub verdict: String,
    /// The rest of the sentence after the verdict, and sentences that follow; may be empty.
    pub rest: String,
}

/// The grade of a verdict, from right to no picture; gives its color.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Grade {
    /// The subject is right, and nothing is left to do: green.
    Right,
    /// Nothing is wrong so far, as in an unfinished text or a right picture of a step: no color.
    OnTheWay,
    /// Something is wrong: red.
    #[default]
    Wrong,
    /// There is no picture to judge: red.
    NoPicture,
}

/// The reader's picture and the right one, of the same size, to be shown side by side.
#[derive(Debug)]
pub struct Pictures {
    /// The reader's picture, as a viewer shows it.
    pub yours: Picture,
    /// The right picture.
    pub right: Picture,
}

/// A labeled line of an answer, such as `should be` with a line of code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// The kind of the row, which gives its label.
    pub kind: RowKind,
    /// The text after the label, in plain text: one line without breaks, of any length.
    pub text: String,
}

/// The kind of a row: what its text tells, as a wrong line, a reason or an observation. It gives
/// the [`label`](RowKind::label) before the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowKind {
    /// A line as a compiler or a program has printed it, without a label.
    Printed,
    /// A warning of the compiler.
    Warned,
    /// A wrong line of the reader's own text.
    Yours,
    /// A wrong line that the reader probably has, in other words.
    Probably,
    /// A wrong line that the reader may have, since it would draw the reader's picture: the
    /// likeliest, if several would.
    Perhaps,
    /// A further wrong line that would draw the same picture, after [`Perhaps`](Self::Perhaps).
    Or,
    /// A continuation of the row before, without a label.
    More,
    /// The wrong line of the row before in Rust.
    InRust,
    /// The right line in the place of the wrong one before.
    ShouldBe,
    /// A line that the reader's text lacks.
    Missing,
    /// The reason why a line is wrong.
    Why,
    /// A clause on how the mistakes or repairs in the rows before were tried, and how well they
    /// explain the picture.
    Tried,
    /// An observation about the picture.
    Seen,
    /// The first pixel that differs from the right one.
    First,
    /// The numbers that a right program computes for the pixel of [`First`](Self::First).
    Numbers,
    /// A clause on the laws, the properties that a function must have: such as the functions for
    /// which they hold.
    Laws,
    /// The law that a function breaks.
    Law,
    /// The answer of the function that breaks the law.
    Found,
    /// The answers that the law allows.
    Allowed,
    /// A known mistake with which a function gives the same answers.
    SameAs,
    /// The chapter and the equation or function that explain the law.
    Read,
    /// A remark that does not change the verdict.
    Besides,
    /// A further picture to draw, with the name of its [`Probe`](slips::Probe), a changed scene;
    /// the name is empty for the chapter's own picture.
    Probe(&'static str),
}

impl Answer {
    /// Makes an answer of a headline alone: `subject is verdict`, then `rest`, which begins with
    /// its own punctuation or blank, as `: 3 of 90 pixels differ.` If `subject` is empty, the
    /// verdict begins the sentence.
    pub fn of(grade: Grade, subject: &str, verdict: &str, rest: impl Into<String>) -> Self {
        let headline = Headline {
            grade,
            subject: subject.to_owned(),
            verdict: verdict.to_owned(),
            rest: rest.into(),
        };
        Self {
            headline,
            ..Self::default()
        }
    }

    /// Makes an answer of a headline alone that is one whole sentence, `verdict`, all of it in the
    /// color of the grade.
    pub fn sentence(grade: Grade, verdict: impl Into<String>) -> Self {
        Self::of(grade, "", &verdict.into(), "")
    }

    /// Appends rows to the answer, after those that it has.
    pub fn with(mut self, rows: impl IntoIterator<Item = Row>) -> Self {
        self.rows.extend(rows);
        self
    }

    /// Sets the advice [`next`](Self::next), in plain text, in place of an earlier one.
    pub fn then(self, next: impl Into<String>) -> Self {
        let next = next.into();
        Self { next, ..self }
    }

    /// Returns true if the grade of the headline is [`Grade::Right`].
    pub fn is_right(&self) -> bool {
        self.headline.grade == Grade::Right
    }
}

impl Pictures {
    /// Takes the two pictures of a verdict. `None` if it has none, or if the picture is right only
    /// within a tolerance.
    pub(crate) fn of(verdict: Verdict) -> Option<Self> {
        let is_right = verdict.is_right();
        let finding = verdict.finding?;
        if is_right && finding.levels() > 0 {
            return None;
        }
        Some(Self {
            yours: finding.yours,
            right: finding.right,
        })
    }
}

impl Headline {
    /// Returns the three parts of the sentence, which give it when joined: `subject is` and a blank,
    /// the verdict, and the text after it. The first is empty, and the verdict has a capital, if
    /// there is no subject.
    pub fn parts(&self) -> [String; 3] {
        let (before, verdict) = match &*self.subject {
            "" => (String::new(), capital(&self.verdict)),
            subject => (format!("{subject} is "), self.verdict.clone()),
        };
        [before, verdict, self.rest.clone()]
    }
}

impl fmt::Display for Headline {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.parts().concat())
    }
}

/// Makes the first letter of a text a capital.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(char::to_uppercase);
    first.into_iter().flatten().chain(letters).collect()
}

impl Row {
    /// Makes a row of its kind and its text, which is one line of plain text.
    pub fn new(kind: RowKind, text: impl Into<String>) -> Self {
        let text = text.into();
        Self { kind, text }
    }
}

impl RowKind {
    /// Returns the label that stands before the text, such as `should be`; empty for
    /// [`Printed`](Self::Printed) and [`More`](Self::More).
    pub fn label(self) -> &'static str {
        match self {
            Self::Printed | Self::More => "",
            Self::Warned => "warned",
            Self::Yours => "yours",
            Self::Probably => "probably",
            Self::Perhaps => "perhaps",
            Self::Or => "or",
            Self::InRust => "in Rust",
            Self::ShouldBe => "should be",
            Self::Missing => "missing",
            Self::Why => "why",
            Self::Tried => "tried",
            Self::Seen => "seen",
            Self::First => "first",
            Self::Numbers => "numbers",
            Self::Laws => "the laws",
            Self::Law => "the law",
            Self::Found => "found",
            Self::Allowed => "allowed",
            Self::SameAs => "same as",
            Self::Read => "read",
            Self::Besides => "besides",
            Self::Probe(_) => "probe",
        }
    }

    /// Returns true if the text is a line of code, and false for sentences and clauses.
    pub fn is_code(self) -> bool {
        matches!(
            self,
            Self::Yours
                | Self::Probably
                | Self::Perhaps
                | Self::Or
                | Self::InRust
                | Self::ShouldBe
                | Self::Missing
        )
    }
}
