//! An adapter for any language: a function that is asked by lines of text, and answers by lines.
//!
//! A line asks about one ray and one sphere, a line answers. So a program in any language can be
//! put under the laws of a Rust function, if it reads and prints numbers.

use std::cell::RefCell;

use common::rtweekend::*;
use laws::nearer_root::{self, obeys_every_law, root_bound};
use laws::oracle::ExactCase;
use laws::record::{self, RecordedHit};
use laws::{Case, Complaint, IntervalCase, Outcome, Question, Trial};

mod manner;

pub use manner::Manner;
use manner::right_record;

/// What stands for an infinite end: not every language reads infinity, and no root that is asked
/// for is as far away.
const FAR: f64 = 1e300;

/// What a function of a chapter answers about one ray and one sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FunctionKind {
    /// True if the line meets the sphere, as in chapter 2.
    Decision,
    /// The nearer root, as in chapters 3 and 4.
    Root,
    /// The nearest hit in a range, as in chapter 5.
    Record,
}

/// Asks a program for the hit in a range, which only a [`FunctionKind::Record`] has.
pub type Ask<'a> = dyn Fn(&IntervalCase) -> Option<RecordedHit> + 'a;

/// What comes of a program.
pub struct FunctionVerdict {
    /// True if the laws hold, apart from its manners.
    pub outcome: Outcome,
    /// In which of its answers it differs from version 4 of the book, and no picture shows it.
    pub manners: Vec<Manner>,
    /// What was asked about the smallest case that breaks a law.
    pub last: Vec<IntervalCase>,
}

/// Why a line is no answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoAnswer {
    /// Its numbers have a comma where a decimal point should be.
    DecimalComma,
    /// It is something else.
    Other,
}

impl FunctionKind {
    /// Writes the question as a line: center, radius, origin, direction, and for a record the range, as
    /// decimal numbers that read back to the same bits.
    pub fn line(self, asked: &IntervalCase) -> String {
        let range = [asked.t_min, asked.t_max].map(|end| end.clamp(-FAR, FAR));
        let range = if self == Self::Record {
            &range[..]
        } else {
            &[]
        };
        let numbers = asked.case.numbers();
        let words = numbers
            .iter()
            .chain(range)
            .map(|number| format!("{number:?}"));
        words.collect::<Vec<_>>().join(" ")
    }

    /// Reads the answer of a line.
    ///
    /// For a record, the normal and `front` or `back` may stand behind `t`; without them, they
    /// count as right. If a program `says_minus_one` for a miss, as the book's C++ in chapters 3
    /// and 4, that counts as one, unless it is the root.
    ///
    /// # Errors
    /// If it is no answer.
    pub fn read(
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

/// Reads a number as any language prints it: NaN also as `-nan(ind)`.
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

/// Returns true if `t` is the nearer root, as far as rounding lets it be known.
fn is_root(case: &Case, t: f64) -> bool {
    let exact = ExactCase::of(case);
    let bound = root_bound(case, exact.discriminant_margin());
    let root = exact.nearer_root();
    root.is_some_and(|root| (root.rounded() - t).abs() <= bound)
}

/// Puts a function in a program of any language under the laws of a Rust function. Where it differs from
/// a right one only by a manner, it is taken for right.
pub fn tried(trial: &Trial, function: FunctionKind, ask: &Ask) -> FunctionVerdict {
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
        Some(meant(&IntervalCase::on_the_line(case))?.t)
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
    let (used, last) = (used.take(), last.take());
    FunctionVerdict {
        outcome,
        manners: manners.into_iter().filter(|it| used.contains(it)).collect(),
        last: of_one_kind(last),
    }
}

/// Each question once, of the kind of the last one: what is asked about a range is no matter of
/// the whole line.
fn of_one_kind(asked: Vec<IntervalCase>) -> Vec<IntervalCase> {
    let is_on_the_line = |it: &IntervalCase| it.t_min == f64::NEG_INFINITY;
    let kind = asked.last().map(is_on_the_line);
    let mut once: Vec<IntervalCase> = Vec::new();
    for it in asked {
        if Some(is_on_the_line(&it)) == kind && !once.contains(&it) {
            once.push(it);
        }
    }
    once
}
