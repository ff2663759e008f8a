//! An attempt: a picture that a reader hands in with what is known of its program, and the
//! [`Answer`] to it.

use laws::Report;
use slips::{Chapter, Probe};

use crate::answer::{Answer, Pictures, Row, RowKind};
use crate::context::Context;
use crate::reading::Cause;
use crate::sentences::{law_rows, refused};
use crate::task::Task;
use crate::verdict::{Finding, RefusalKind, Verdict};

/// The outcome of the laws, the properties that a function must have, for the functions that a
/// reader typed.
#[derive(Debug)]
pub enum LawsStatus {
    /// All laws hold.
    Obeyed,
    /// A function of the chapter breaks the law of this report.
    Broken(Box<Report>),
    /// A function of the reader's own prelude, the vectors and rays on which all else stands,
    /// breaks the law of this report.
    BrokenPrelude(Box<Report>),
    /// A function of the chapter has a `todo!()` at this place, such as `src/lib.rs:12`.
    NotWritten(String),
    /// A function of the reader's own prelude (vectors and rays) has a `todo!()` at this place,
    /// such as `src/ray.rs:12`.
    UnwrittenPrelude(String),
    /// The laws were not tried to the end; the text is the reason, or what was printed instead.
    Unknown(String),
    /// The laws are still being built: their outcome will follow.
    Coming,
}

/// A picture that a reader hands in, with what is known of its program.
pub struct Attempt<'a> {
    /// The task that the picture should fulfill.
    pub task: Task,
    /// True if the task was guessed from the picture.
    pub is_guessed: bool,
    /// The name of the picture, such as its file's; empty if it has none.
    pub name: String,
    /// The flaw of a file that could be read, such as an encoding in UTF-16; `None` if it has none.
    pub flaw: Option<Cause>,
    /// The context of the picture: files, answers and warnings of the reader's program.
    pub context: &'a Context<'a>,
    /// The outcome of the laws; `None` where the functions can't be asked.
    pub laws: Option<&'a LawsStatus>,
    /// The commands that the reader can give next.
    pub commands: Commands<'a>,
}

/// The commands that a reader can type next, or their like on a page, each as one line of plain
/// text.
pub struct Commands<'a> {
    /// Returns the command that judges the picture of the given probe (a changed scene), or for
    /// `None` the chapter's own picture.
    pub judge: Box<dyn Fn(Option<Probe>) -> String + 'a>,
    /// Returns the command that starts the given chapter; `None` where no chapter is typed.
    pub start: Option<Box<dyn Fn(Chapter) -> String + 'a>>,
    /// The command that shows more of a broken law; empty if there is none.
    pub test: &'static str,
}

impl Commands<'_> {
    /// Makes the commands for a reader who hands in pictures alone: `judge` gives those of `check`
    /// for the chapter of the task, `start` is `None` and `test` empty.
    pub fn of_pictures(task: Task) -> Self {
        let judge = move |probe: Option<Probe>| match probe {
            Some(_) => Task { probe, ..task }.command(),
            None => Task::of(task.chapter).command(),
        };
        Self {
            judge: Box::new(judge),
            start: None,
            test: "",
        }
    }
}

impl<'a> Attempt<'a> {
    /// Makes the attempt at a task that was named, of a reader who hands in a picture alone:
    /// without name and flaw, and without functions that the laws could ask.
    pub fn new(task: Task, context: &'a Context<'a>) -> Self {
        Self {
            task,
            is_guessed: false,
            name: String::new(),
            flaw: None,
            context,
            laws: None,
            commands: Commands::of_pictures(task),
        }
    }

    /// Puts the verdict on the picture into an answer.
    ///
    /// A picture whose task was guessed may get the verdict `not recognized`. A law that the
    /// reader's own prelude breaks replaces all rows that explain the picture.
    pub fn answer(&self, verdict: Verdict) -> Answer {
        let mut answer = match (self.unrecognized(&verdict), self.laws) {
            (Some(answer), _) => answer,
            (None, Some(LawsStatus::BrokenPrelude(report))) => Answer {
                rows: law_rows(report),
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
        answer.rows.extend(self.flaw.iter().map(besides));
        answer.pictures = Pictures::of(verdict);
        answer
    }

    /// Puts the verdict into an answer, for a picture that is recognized.
    fn judged(&self, verdict: &Verdict) -> Answer {
        match (&verdict.refusal, verdict.finding()) {
            (None, Some(finding)) => (finding.rule.says)(self, finding),
            (Some(refusal), finding) => {
                let verdict = match (refusal.kind, finding) {
                    (RefusalKind::NotAPicture, Some(_)) => "not a valid picture",
                    (RefusalKind::NotAPicture, None) => "not a picture",
                    _ => "wrong",
                };
                self.with_pixels(refused(&self.name, verdict, &refusal.cause), finding)
            }
            (None, None) => Answer::default(),
        }
    }

    /// Adds what explains the pixels of a picture that was refused, but for the numbers of a ray,
    /// which would take the room of the cause.
    fn with_pixels(&self, answer: Answer, finding: Option<&Finding>) -> Answer {
        let Some(finding) = finding else {
            return answer;
        };
        let mut answer = self.explained(answer, finding);
        answer.rows.retain(|row| row.kind != RowKind::Numbers);
        answer
    }
}
