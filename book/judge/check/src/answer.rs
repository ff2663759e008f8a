//! The answer to a reader as data: a headline, rows, pictures, and what to do next.
//!
//! [`Attempt::answer`] makes it, with the sentences of [`sentences`](crate::sentences); `text` and
//! `html` lay it out, for `check`, `watch`, the pages, the report and the laws.

use std::fmt;

use common::rtweekend::Picture;
use laws::Report;
use slips::{Chapter, Probe, Slip};

use crate::context::Context;
use crate::reading::Cause;
use crate::sentences::{law, refused};
use crate::task::Task;
use crate::verdict::{Finding, Verdict};

/// All that a reader is told of a picture or a program.
#[derive(Debug, Default)]
pub struct Answer {
    /// The verdict in a sentence.
    pub headline: Headline,
    /// What explains the verdict, the most important row first.
    pub rows: Vec<Row>,
    /// The reader's picture beside the right one, if there is one to see.
    pub pictures: Option<Pictures>,
    /// Slips whose pages tell how the line is right.
    pub read: Vec<&'static Slip>,
    /// What to do now; empty if the rows say it.
    pub next: String,
    /// What came out right, for the reader's list of done things.
    pub done: Vec<String>,
}

/// A sentence with the verdict in it: `sign.png is wrong: 3 of 90 pixels …`.
#[derive(Debug, Default)]
pub struct Headline {
    /// How the verdict is shown.
    pub grade: Grade,
    /// What is judged, as the name of a file; empty where the place of the answer says that.
    pub subject: String,
    /// The verdict itself: after `subject is`, or a whole sentence.
    pub verdict: String,
    /// The rest of the sentence, and what follows it.
    pub rest: String,
}

/// The kind of a verdict, by which it is colored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Grade {
    /// Nothing is left to do.
    Right,
    /// Nothing is wrong so far: a step, an unfinished text, a right picture but for something.
    OnTheWay,
    /// Something is wrong.
    #[default]
    Wrong,
    /// There is no picture to judge.
    NoPicture,
}

/// The two pictures of an answer, of the same size.
#[derive(Debug)]
pub struct Pictures {
    /// The reader's, as a viewer shows it.
    pub yours: Picture,
    /// What it should be.
    pub right: Picture,
}

/// A labeled line of an answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// What the line is.
    pub kind: RowKind,
    /// The line, which may be long.
    pub text: String,
}

/// What a row tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowKind {
    /// A line as a compiler or a program has printed it.
    Printed,
    /// The first complaint of the compiler that is no error.
    Warned,
    /// The reader's line, which is wrong.
    Yours,
    /// A wrong line that the reader probably has.
    Probably,
    /// A wrong line that the reader may have, the first of several.
    Perhaps,
    /// Another one.
    Or,
    /// A line that goes on with the row before.
    More,
    /// The right line.
    ShouldBe,
    /// A line that is not there.
    Missing,
    /// Why the wrong line is wrong.
    Why,
    /// By what the rows above were tried.
    Tried,
    /// An observation about the picture.
    Seen,
    /// The first pixel that differs.
    First,
    /// The numbers of its ray, as they should be.
    Numbers,
    /// For what the laws hold.
    Laws,
    /// The law that is broken.
    Law,
    /// What a function answered.
    Found,
    /// What it may answer.
    Allowed,
    /// A mistake with the same answers.
    SameAs,
    /// Where that is explained.
    Read,
    /// A command that asks the same again.
    ByHand,
    /// What a program answers to it.
    Says,
    /// Something that does not change the verdict.
    Besides,
    /// A further picture to draw, with the name of its probe if it has one.
    Probe(&'static str),
}

impl Answer {
    /// Says what the subject is, or what is judged if that has no name, and the rest of the
    /// sentence.
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

    /// Says a whole sentence.
    pub fn sentence(grade: Grade, verdict: impl Into<String>) -> Self {
        Self::of(grade, "", &verdict.into(), "")
    }

    /// Adds rows.
    pub fn with(mut self, rows: impl IntoIterator<Item = Row>) -> Self {
        self.rows.extend(rows);
        self
    }

    /// Adds what to do next.
    pub fn then(self, next: impl Into<String>) -> Self {
        let next = next.into();
        Self { next, ..self }
    }

    /// Returns true if nothing is left to do.
    pub fn is_right(&self) -> bool {
        self.headline.grade == Grade::Right
    }
}

impl Pictures {
    /// Takes those of a verdict, if it has some.
    fn of(verdict: Verdict) -> Option<Self> {
        let finding = match verdict {
            Verdict::Right(right) => {
                let picture = || right.task.right(right.width, right.height);
                return (right.levels == 0).then(|| Self {
                    yours: picture(),
                    right: picture(),
                });
            }
            Verdict::AlmostRight(finding) | Verdict::Wrong(finding) => finding,
            Verdict::WrongShape { finding, .. } | Verdict::NotAPicture { finding, .. } => *finding?,
            Verdict::Another { .. } => return None,
        };
        Some(Self {
            yours: finding.yours,
            right: finding.right,
        })
    }
}

impl Headline {
    /// Returns what stands before the verdict, the verdict, and what follows it.
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

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(char::to_uppercase);
    first.into_iter().flatten().chain(letters).collect()
}

impl Row {
    /// Makes a row.
    pub fn new(kind: RowKind, text: impl Into<String>) -> Self {
        let text = text.into();
        Self { kind, text }
    }
}

impl RowKind {
    /// Returns the label before the row.
    pub fn label(self) -> &'static str {
        match self {
            Self::Printed | Self::More => "",
            Self::Warned => "warned",
            Self::Yours => "yours",
            Self::Probably => "probably",
            Self::Perhaps => "perhaps",
            Self::Or => "or",
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
            Self::ByHand => "by hand",
            Self::Says => "it says",
            Self::Besides => "besides",
            Self::Probe(_) => "probe",
        }
    }

    /// Returns true if the row is a line of code or a command.
    pub fn is_code(self) -> bool {
        matches!(
            self,
            Self::Yours
                | Self::Probably
                | Self::Perhaps
                | Self::Or
                | Self::ShouldBe
                | Self::Missing
                | Self::ByHand
        )
    }
}

/// What the laws say of the functions that a reader typed.
#[derive(Debug)]
pub enum LawsStatus {
    /// All of them hold.
    Obeyed,
    /// One is broken.
    Broken(Box<Report>),
    /// One is broken by the reader's own prelude, on which all else stands.
    BrokenPrelude(Box<Report>),
    /// A function has a `todo!()` at this place.
    NotWritten(String),
    /// A function of the reader's own prelude has one.
    UnwrittenPrelude(String),
    /// They were not tried to the end, and this was printed.
    Unknown(String),
    /// They are still being built.
    Coming,
}

/// A picture that a reader hands in, and what is known of it.
pub struct Attempt<'a> {
    /// The scene that the picture should show.
    pub task: Task,
    /// True if that was guessed from the picture.
    pub is_guessed: bool,
    /// What the picture is called, or nothing.
    pub name: String,
    /// What keeps viewers from the file.
    pub encoding: Option<Cause>,
    /// What is known of the reader.
    pub context: &'a Context<'a>,
    /// What the laws say, where functions can be asked.
    pub laws: Option<&'a LawsStatus>,
    /// What the reader can do next.
    pub commands: Commands<'a>,
}

/// What a reader can type, or do on a page.
pub struct Commands<'a> {
    /// Judges a picture of the chapter, or of a probe of it.
    pub judge: Box<dyn Fn(Option<Probe>) -> String + 'a>,
    /// Goes on to another chapter, where chapters are typed.
    pub start: Option<Box<dyn Fn(Chapter) -> String + 'a>>,
    /// Shows more of a broken law, or says nothing.
    pub test: &'static str,
}

impl Commands<'_> {
    /// Makes those for pictures alone, which `check` judges.
    pub fn of_pictures(task: Task) -> Self {
        let judge = move |probe: Option<Probe>| match probe {
            Some(probe) => task.probed_command(probe),
            None => task.without_probe().command(),
        };
        Self {
            judge: Box::new(judge),
            start: None,
            test: "",
        }
    }
}

impl Attempt<'_> {
    /// Answers what was found in the picture.
    pub fn answer(&self, verdict: Verdict) -> Answer {
        let mut answer = match (self.unrecognized(&verdict), self.laws) {
            (Some(answer), _) => answer,
            (None, Some(LawsStatus::BrokenPrelude(report))) => Answer {
                rows: law(report),
                ..self.judged(&verdict)
            }
            .then("put this right first: what else is wrong may stand on it"),
            (None, _) => self.judged(&verdict),
        };
        if self.is_guessed && answer.headline.verdict != "not recognized" {
            answer.rows.push(self.taken_for());
        }
        let besides =
            |it: &Cause| Row::new(RowKind::Besides, format!("{}. {}", it.problem, it.fix));
        answer.rows.extend(self.encoding.iter().map(besides));
        answer.pictures = Pictures::of(verdict);
        answer
    }

    fn judged(&self, verdict: &Verdict) -> Answer {
        match verdict {
            Verdict::Right(right) => self.right(right),
            Verdict::AlmostRight(finding) => match (&finding.almost_right, finding.task.step()) {
                (Some(almost_right), Some(step)) if almost_right.is_exact() => {
                    self.step(step, finding)
                }
                (almost_right, _) => {
                    let unexplained = almost_right
                        .as_ref()
                        .map(|it| it.unexplained)
                        .unwrap_or_default();
                    self.nearly_right(finding, &unexplained)
                }
            },
            Verdict::Wrong(finding) => self.wrong(finding),
            Verdict::Another { cause, .. } => refused(&self.name, "wrong", cause),
            Verdict::WrongShape { cause, finding } => {
                let answer = refused(&self.name, "wrong", cause);
                self.with_pixels(answer, finding.as_deref())
            }
            Verdict::NotAPicture { cause, finding } => {
                let verdict = match finding {
                    Some(_) => "not a valid picture",
                    None => "not a picture",
                };
                let answer = refused(&self.name, verdict, cause);
                self.with_pixels(answer, finding.as_deref())
            }
        }
    }

    /// Adds what is seen in a picture that a cause refuses, without the numbers of a ray: the
    /// cause comes first, and they would take its room.
    fn with_pixels(&self, answer: Answer, finding: Option<&Finding>) -> Answer {
        let Some(finding) = finding else {
            return answer;
        };
        let mut answer = self.explained(answer, finding);
        answer.rows.retain(|row| row.kind != RowKind::Numbers);
        answer
    }
}
