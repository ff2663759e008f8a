//! Fault localization by hypotheses: from wrong answers to the mistake that gives
//! all of them.
//!
//! A wrong function is seldom random. It answers another question rightly, and the
//! mistakes that lead there are known: each is here as a function that makes it, a
//! *mutant*. One that gives the same answer as the function under test to every
//! question of a few hundred is the cause. One that fits a single case is not: by
//! chance many do, where a is 1 or the radius is 0.

mod list;
mod ray_and_camera;
mod record;
mod roots;

use std::fmt;

use crate::shrinker::Simplify;
use crate::verdict::Broken;

/// What a function under test is asked.
pub trait Question: Simplify + 'static {
    /// What it answers.
    type Answer;

    /// What the function is called that a test for this question imports.
    const FUNCTION: &'static str;

    /// The right answer, but for roundings.
    fn right(&self) -> Self::Answer;

    /// Whether two answers are the same, but for roundings.
    fn same(&self, one: &Self::Answer, other: &Self::Answer) -> bool;

    /// Questions to which different mistakes give different answers.
    fn telling() -> Vec<Self>;

    /// The mistakes that are known, those that are made most often first.
    fn hypotheses() -> Vec<Hypothesis<Self>>;

    /// Whether mistakes fit the question by chance, as for a sphere of radius 0.
    fn is_degenerate(&self) -> bool {
        false
    }
}

/// A mistake that is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// The slips of `cargo rtrace slips` that this is: more than one if chapters
    /// write the same step in different ways, none if it is not in that list.
    pub names: &'static [&'static str],
    /// What the code probably says, in no particular language.
    pub wrong: &'static str,
    /// What it should say.
    pub right: &'static str,
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            names,
            wrong,
            right,
        } = self;
        if !names.is_empty() {
            write!(f, "{}: ", names.join(" or "))?;
        }
        write!(f, "{wrong}; should be: {right}")
    }
}

/// A mistake, and a function that makes it.
pub struct Hypothesis<Q: Question> {
    /// The mistake.
    pub mistake: Mistake,
    /// What the function answers.
    pub answer: Answering<Q>,
}

/// A function that is asked and answers.
pub type Answering<Q> = Box<dyn Fn(&Q) -> <Q as Question>::Answer>;

impl<Q: Question> Hypothesis<Q> {
    fn new(mistake: Mistake, answer: impl Fn(&Q) -> Q::Answer + 'static) -> Self {
        Self {
            mistake,
            answer: Box::new(answer),
        }
    }
}

/// What makes the answers of a function what they are.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cause {
    /// Each of these mistakes alone gives all the answers that are explained. They
    /// are three at most, and no question tells them apart.
    pub mistakes: Vec<Mistake>,
    /// How many answers are explained. Without a mistake: how many are right.
    pub explained: usize,
    /// How many there are.
    pub asked: usize,
}

impl Cause {
    /// What to tell a reader, a line each.
    pub(crate) fn lines(&self, broken: &Broken) -> Vec<String> {
        let Self {
            mistakes,
            explained,
            asked,
        } = self;
        let share = format!("{explained} of {asked} answers");
        let mut lines: Vec<String> = mistakes.iter().map(Mistake::to_string).collect();
        match lines.len() {
            0 if *explained == 0 && *asked > 0 => {
                lines.push("no single mistake that is known gives these answers".to_owned());
            }
            0 if *asked > 0 => lines.push(format!("{share} are right: what is special here?")),
            _ if explained < asked => {
                lines.push(format!(
                    "and another mistake: {share} are as this one has it"
                ));
            }
            0 | 1 => {}
            _ => lines.push("each of these gives the same answer to every question".to_owned()),
        }
        if mistakes.is_empty() {
            lines.push(broken.usually.to_owned());
        }
        lines
    }
}

/// How many mistakes a message names at most: more are no help.
const NAMED: usize = 3;

/// The cause of the answers that `answer` gives, to `questions` and to the one
/// that was `found`, with the first of the hypotheses that explain them.
pub(crate) fn of<Q: Question>(
    answer: &dyn Fn(&Q) -> Q::Answer,
    mut questions: Vec<Q>,
    found: &Q,
) -> (Cause, Option<Hypothesis<Q>>) {
    questions.push(found.clone());
    let answers: Vec<Q::Answer> = questions.iter().map(answer).collect();
    let fits = |wrong: &dyn Fn(&Q) -> Q::Answer| {
        let both = questions.iter().zip(&answers);
        both.filter(|(question, answer)| question.same(answer, &wrong(question)))
            .count()
    };
    let (asked, right) = (questions.len(), fits(&Q::right));
    // One answer in twenty may be due to a second mistake.
    let enough = |fits: usize| 20 * fits >= 19 * asked;
    let mut fitting: Vec<(usize, Hypothesis<Q>)> = Q::hypotheses()
        .into_iter()
        .map(|hypothesis| (fits(&*hypothesis.answer), hypothesis))
        .filter(|&(fits, _)| fits > right && enough(fits))
        .collect();
    let most = fitting.iter().map(|&(fits, _)| fits).max();
    fitting.retain(|&(fits, _)| Some(fits) == most);
    let mut mistakes: Vec<Mistake> = fitting.iter().map(|(_, one)| one.mistake).collect();
    mistakes.dedup();
    mistakes.truncate(NAMED);
    let explained = most.unwrap_or(if enough(right) { right } else { 0 });
    let first = fitting.into_iter().next().map(|(_, first)| first);
    let cause = Cause {
        mistakes,
        explained,
        asked,
    };
    (cause, first.filter(|_| explained == asked))
}
