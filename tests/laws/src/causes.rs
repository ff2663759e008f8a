//! Fault localization by hypotheses: from wrong answers to the mistake that gives
//! all of them.
//!
//! A wrong function is seldom random. It answers another question rightly, and the
//! mistakes that lead there are known: each [`Slip`] is a program that makes one. A slip
//! that gives the same answer as the function under test to every question of a few
//! hundred is the cause. One that fits a single case is not: by chance many do, where a
//! is 1 or the radius is 0.

use slips::{Chapter, Letters, Program, Slip};

use crate::question::Question;
use crate::verdict::Broken;

/// What makes the answers of a function what they are.
#[derive(Clone, Debug, Default)]
pub struct Cause {
    /// Each of these mistakes alone, made in that chapter, gives all the answers that are
    /// explained, and no question tells them apart. They are four at most.
    pub mistakes: Vec<(&'static Slip, Chapter)>,
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
        let mut lines: Vec<String> = mistakes.iter().map(in_a_line).collect();
        match lines.len() {
            0 if *explained == 0 => {}
            0 => lines.push(format!("{share} are right: what is special here?")),
            _ if explained < asked => {
                lines.push(format!(
                    "and another mistake: {share} are as this one has it"
                ));
            }
            1 => {}
            _ => lines.push("each of these gives the same answer to every question".to_owned()),
        }
        if mistakes.is_empty() {
            lines.push(broken.usually.to_owned());
        }
        lines
    }
}

fn in_a_line(&(slip, chapter): &(&Slip, Chapter)) -> String {
    let [(_, wrong), (should_be, right), _] = slip.rows(Letters::Rust, chapter);
    let said = format!("{wrong}; {should_be}: {right}");
    match slip.name {
        "" => said,
        name => format!("{name}: {said}"),
    }
}

/// How many mistakes a message names at most: in four places a root can lose its sign.
const NAMED: usize = 4;

/// The cause of the answers that `answer` gives, to `questions` and to the one that was
/// `found`, and a program that gives them too, if one gives all. Mistakes in a `chapter`
/// are looked for, or in any that has such a function.
pub(crate) fn of<Q: Question>(
    answer: &dyn Fn(&Q) -> Q::Answer,
    mut questions: Vec<Q>,
    found: &Q,
    chapter: Option<Chapter>,
) -> (Cause, Option<Program>) {
    questions.push(found.clone());
    let answers: Vec<Q::Answer> = questions.iter().map(answer).collect();
    let asked = questions.len();
    // One answer in twenty may be due to a second mistake.
    let most_unexplained = asked / 20;
    let fits = |program: &Program| {
        let mut unexplained = 0;
        for (question, answer) in questions.iter().zip(&answers) {
            unexplained += usize::from(!question.same(answer, &question.answer_of(program)));
            if unexplained > most_unexplained {
                return None;
            }
        }
        Some(asked - unexplained)
    };
    let right = fits(&Q::right_program()).unwrap_or(0);
    let mut fitting: Vec<(usize, &Slip, Program)> = hypotheses::<Q>(chapter)
        .filter_map(|(slip, program)| Some((fits(&program)?, slip, program)))
        .filter(|&(fits, ..)| fits > right)
        .collect();
    let most = fitting.iter().map(|&(fits, ..)| fits).max();
    fitting.retain(|&(fits, ..)| Some(fits) == most);
    // Those that are made most often come first.
    fitting.sort_by_key(|(_, slip, _)| std::cmp::Reverse(slip.reports()));
    let mut mistakes: Vec<(&Slip, Chapter)> = Vec::new();
    for (_, slip, program) in &fitting {
        if !mistakes
            .iter()
            .any(|(other, _)| std::ptr::eq(*other, *slip))
        {
            mistakes.push((slip, program.chapter));
        }
    }
    mistakes.truncate(NAMED);
    let explained = most.unwrap_or(right);
    let first = fitting.first().map(|&(_, _, program)| program);
    let cause = Cause {
        mistakes,
        explained,
        asked,
    };
    (cause, first.filter(|_| explained == asked))
}

/// Each slip that can be made in a function of this kind in Rust, as each chapter writes it.
fn hypotheses<Q: Question>(
    chapter: Option<Chapter>,
) -> impl Iterator<Item = (&'static Slip, Program)> {
    let in_rust = |slip: &&Slip| slip.can_be_made_in(Letters::Rust);
    let slips = slips::all().chain(slips::unnamed()).filter(in_rust);
    slips.flat_map(move |slip| {
        let asked = move |it: &&Chapter| chapter.is_none_or(|chapter| **it == chapter);
        let chapters = Q::CHAPTERS.iter().filter(asked);
        let can_be_made = chapters.filter(|chapter| slip.chapters.contains(chapter));
        can_be_made.map(move |&chapter| (slip, slip.program(chapter)))
    })
}
