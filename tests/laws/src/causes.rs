//! Fault localization by hypotheses: from wrong answers to the mistake that gives
//! all of them.
//!
//! A wrong function is seldom random. It answers another question rightly, and the
//! mistakes that lead there are known: each [`Slip`] is a program that makes one. A slip
//! that gives the same answer as the function under test to every question of a few
//! hundred is the cause. One that fits a single case is not: by chance many do, where a
//! is 1 or the radius is 0.

use std::cmp::Reverse;

use slips::{Chapter, Letters, Program, Slip};

use crate::answers::Answers;

/// What makes the answers of a function what they are.
#[derive(Clone, Debug)]
pub struct Cause {
    /// In which chapter.
    chapter: Chapter,
    /// In which language.
    letters: Letters,
    /// Each of these mistakes alone gives all the answers that are explained, and no question
    /// tells them apart. They are four at most.
    pub mistakes: Vec<&'static Slip>,
    /// How many answers are explained. Without a mistake: how many are right.
    pub explained: usize,
    /// How many there are.
    pub asked: usize,
}

/// How many mistakes a message names at most: in four places a root can lose its sign.
const NAMED: usize = 4;

impl Cause {
    /// The cause of the answers, among the slips that can be made in the chapter.
    pub(crate) fn of(answers: &Answers, letters: Letters) -> Self {
        let (chapter, asked) = (answers.chapter, answers.given.len());
        // One answer in twenty may be due to a second mistake.
        let most_unexplained = asked / 20;
        let explained_by = |program: &Program| {
            let (_, unexplained) = answers.unlike(program, most_unexplained + 1);
            (unexplained <= most_unexplained).then_some(asked - unexplained)
        };
        let right = explained_by(&Program::right(chapter)).unwrap_or(0);
        let mut fitting: Vec<(usize, &'static Slip)> = slips::all()
            .chain(slips::unnamed())
            .filter(|slip| slip.chapters.contains(&chapter) && slip.can_be_made_in(letters))
            .filter(|slip| answers.ends_as(&slip.program(chapter)))
            .filter_map(|slip| Some((explained_by(&slip.program(chapter))?, slip)))
            .filter(|&(explained, _)| explained > right)
            .collect();
        // Those that explain most, and of them those that are made most often.
        fitting.sort_by_key(|&(explained, slip)| Reverse((explained, slip.reports())));
        let explained = fitting.first().map_or(right, |&(most, _)| most);
        fitting.retain(|&(other, _)| other == explained);
        fitting.truncate(NAMED);
        Self {
            chapter,
            letters,
            mistakes: fitting.into_iter().map(|(_, slip)| slip).collect(),
            explained,
            asked,
        }
    }

    /// What to tell a reader, a line each; none, if nothing is known.
    pub(crate) fn lines(&self) -> Vec<String> {
        let share = format!("{} of {} answers", self.explained, self.asked);
        let mistakes = self.mistakes.iter();
        let mut lines: Vec<String> = mistakes.map(|slip| self.in_a_line(slip)).collect();
        if lines.is_empty() {
            return lines;
        }
        if self.explained < self.asked {
            lines.push(format!(
                "and another mistake: {share} are as this one has it"
            ));
        } else if lines.len() > 1 {
            lines.push("each of these gives the same answer to every question".to_owned());
        }
        lines
    }

    fn in_a_line(&self, slip: &Slip) -> String {
        let [(_, wrong), (should_be, right), _] = slip.rows(self.letters, self.chapter);
        let said = format!("{wrong}; {should_be}: {right}");
        match slip.name {
            "" => said,
            name => format!("{name}: {said}"),
        }
    }
}
