//! An adapter that puts a program in any language under the laws of a Rust function: the
//! program reads questions and prints answers, a line of text each, about one ray and one sphere.

use std::cell::RefCell;

use common::rtweekend::*;
use laws::nearer_root::{self, obeys_every_law, root_bound};
use laws::oracle::ExactCase;
use laws::record::{self, RecordedHit};
use laws::{Case, Complaint, IntervalCase, Outcome, Question, Trial};

mod manner;

pub use manner::Manner;
use manner::right_record;

/// The finite number that stands for an infinite end of a range: not every language reads infinity,
/// and no root that is asked for is as far away.
const FAR: f64 = 1e300;

/// The kind of a chapter's function, by its answer about one ray and one sphere: yes or no, a root,
/// or a record of the hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FunctionKind {
    /// A function that decides whether the line meets the sphere, as in chapter 2.
    Decision,
    /// A function that returns the nearer root, as in chapters 3 and 4.
    Root,
    /// A function that returns the nearest hit in a range, as in chapter 5.
    Record,
}

/// A function that asks a program the question of a ray and a sphere, and returns the nearest hit,
/// `None` for a miss. Only a [`FunctionKind::Record`] heeds the range of the question.
pub type AskProgram<'a> = dyn Fn(&IntervalCase) -> Option<RecordedHit> + 'a;

/// The verdict of the laws, the properties that an intersection must have, on a function in any
/// language.
pub struct FunctionVerdict {
    /// The outcome of the laws, with answers that differ only by a manner taken as right.
    pub outcome: Outcome,
    /// The manners in which some of the function's answers differ from version 4 of the book; empty
    /// if none do.
    pub manners: Vec<Manner>,
    /// The questions about the smallest case that breaks a law, each once; empty if none is broken.
    pub questions: Vec<IntervalCase>,
}

/// The reason why a line that a program printed is no answer: a decimal comma, or anything else.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoAnswer {
    /// A number has a comma where the decimal point should be.
    DecimalComma,
    /// The line has other words, or more or fewer numbers, than an answer.
    Other,
}

impl FunctionKind {
    /// Writes a question as a line for the program: center, radius, origin, direction, and for a
    /// record `t_min` and `t_max`, as decimal numbers with blanks between them that read back to
    /// the same bits. An infinite end of the range is written as ±1e300.
    pub fn question_line(self, asked: &IntervalCase) -> String {
        let range = [asked.t_min, asked.t_max].map(|end| end.clamp(-FAR, FAR));
        let range = range.into_iter().filter(|_| self == Self::Record);
        let numbers = asked.case.numbers().into_iter().chain(range);
        let words = numbers.map(|number| format!("{number:?}"));
        words.collect::<Vec<_>>().join(" ")
    }

    /// Parses the line that answers a question; `None` is a miss.
    ///
    /// The line is `miss`, `hit` for a decision, or the number `t`. For a record, the normal and
    /// `front` or `back` may follow `t`; without them, they count as right. If a program
    /// `says_minus_one` for a miss, as the book's C++ does in chapters 3 and 4, that number is a
    /// miss unless it is the root.
    ///
    /// # Errors
    /// If the line is no answer, with the reason.
    pub fn parse_answer(
        self,
        asked: &IntervalCase,
        line: &str,
        says_minus_one: bool,
    ) -> Result<Option<RecordedHit>, NoAnswer> {
        let words: Vec<&str> = line.split_whitespace().collect();
        let case = &asked.case;
        match (self, &words[..]) {
            (_, ["miss"]) => Ok(None),
            (Self::Decision, ["hit"]) => Ok(Some(right_record(case, 0.0))),
            (Self::Decision, _) => Err(NoAnswer::Other),
            (Self::Record, [t, x, y, z, side @ ("front" | "back")]) => Ok(Some(RecordedHit {
                normal: Vec3::new(number(x)?, number(y)?, number(z)?),
                front_face: *side == "front",
                ..right_record(case, number(t)?)
            })),
            (_, [t]) => {
                let t = number(t)?;
                let may_be_a_miss = says_minus_one && self == Self::Root && t == -1.0;
                let is_a_miss = may_be_a_miss && !is_root(case, t);
                Ok((!is_a_miss).then(|| right_record(case, t)))
            }
            _ => Err(NoAnswer::Other),
        }
    }
}

/// Parses a number as any language prints it: NaN also as `-nan(ind)`.
fn number(word: &str) -> Result<f64, NoAnswer> {
    let is_nan = word.to_ascii_lowercase().contains("nan");
    let has_comma = || word.replace(',', ".").parse::<f64>().is_ok();
    match word.parse() {
        Ok(number) => Ok(number),
        Err(_) if is_nan => Ok(f64::NAN),
        Err(_) if has_comma() => Err(NoAnswer::DecimalComma),
        Err(_) => Err(NoAnswer::Other),
    }
}

/// Returns true if `t` is the nearer root, within the bound of rounding.
fn is_root(case: &Case, t: f64) -> bool {
    let exact = ExactCase::of(case);
    let bound = root_bound(case, exact.discriminant_margin());
    let root = exact.nearer_root();
    root.is_some_and(|root| (root.rounded() - t).abs() <= bound)
}

/// Puts the function of a program in any language, which `ask` calls, under the laws for a Rust
/// function of that kind. An answer that differs from the right one only by a manner is taken as
/// right.
pub fn try_laws(trial: &Trial, function: FunctionKind, ask: &AskProgram) -> FunctionVerdict {
    let manners = Manner::of(function, ask);
    let (used, last) = (RefCell::new(Vec::new()), RefCell::new(Vec::new()));
    let meant = |asked: &IntervalCase| {
        last.borrow_mut().push(*asked);
        let found = ask(asked);
        let meant = |manner: &&Manner| manner.meant(function, asked, found.as_ref());
        let Some(manner) = manners.iter().find(|manner| meant(manner).is_some()) else {
            return found;
        };
        used.borrow_mut().push(*manner);
        meant(&manner).flatten()
    };
    let solve = |center, radius, ray: &Ray| {
        let case = Case::new(center, radius, *ray);
        Some(meant(&IntervalCase::unbounded(case))?.t)
    };
    let decide = |center, radius, ray: &Ray| solve(center, radius, ray).is_some();
    let outcome = match function {
        FunctionKind::Decision => trial.decision(&decide),
        FunctionKind::Root => trial.nearer_root(&solve),
        FunctionKind::Record => trial.record(&meant),
    };
    last.borrow_mut().clear();
    if let Err(Complaint::Broken(report)) = &outcome {
        // Asked once more, it breaks the law again.
        let _ = match report.answers.given.last().map(|it| &it.question) {
            Some(Question::Decision(case)) => {
                obeys_every_law(&nearer_root::solver_of_decision(decide), case)
            }
            Some(Question::Root(case)) => obeys_every_law(&solve, case),
            Some(Question::Record(asked)) => record::obeys_every_law(&meant, asked),
            _ => Ok(()),
        };
    }
    let used = used.take();
    let mut questions = Vec::new();
    for asked in last.take() {
        if !questions.contains(&asked) {
            questions.push(asked);
        }
    }
    FunctionVerdict {
        outcome,
        manners: manners.into_iter().filter(|it| used.contains(it)).collect(),
        questions,
    }
}
