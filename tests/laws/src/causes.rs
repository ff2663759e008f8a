//! Fault localization by hypotheses: from wrong answers to the known mistakes that give
//! all of them.
//!
//! A wrong function is seldom random. It answers another question rightly, and the
//! mistakes that lead there are known: each [`Slip`] is a program that makes one. Named is
//! a slip that gives the same answer as the function under test to every question of a few
//! hundred. One that fits a single case is not: by chance many do, where a is 1 or the
//! radius is 0.

use std::cmp::Reverse;

use slips::{Chapter, Letters, Program, Slip};

use crate::answers::Answers;

/// Which known mistakes give the answers of a function.
#[derive(Clone, Debug)]
pub struct Cause {
    /// In which chapter.
    chapter: Chapter,
    /// In which language.
    letters: Letters,
    /// Each of these mistakes alone gives all the answers, and no question tells them apart.
    /// They are four at most.
    pub mistakes: Vec<&'static Slip>,
}

/// How many mistakes a message names at most: in four places a root can lose its sign.
const NAMED: usize = 4;

impl Cause {
    /// The mistakes that give all the answers, among the slips that can be made in the
    /// chapter: none, if a right program gives them too.
    pub(crate) fn of(answers: &Answers, letters: Letters) -> Self {
        let chapter = answers.chapter;
        let gives_all =
            |program: &Program| answers.ends_as(program) && answers.unlike(program, 1).1 == 0;
        let mut mistakes: Vec<&'static Slip> = slips::all()
            .chain(slips::unnamed())
            .filter(|slip| slip.chapters.contains(&chapter) && slip.can_be_made_in(letters))
            .filter(|slip| gives_all(&slip.program(chapter)))
            .collect();
        if gives_all(&Program::right(chapter)) {
            mistakes.clear();
        }
        // Those that are made most often.
        mistakes.sort_by_key(|slip| Reverse(slip.reports()));
        mistakes.truncate(NAMED);
        Self {
            chapter,
            letters,
            mistakes,
        }
    }

    /// What to tell a reader, a line each; none, if nothing is known.
    pub(crate) fn lines(&self) -> Vec<String> {
        let mistakes = self.mistakes.iter();
        let mut lines: Vec<String> = mistakes.map(|slip| self.in_a_line(slip)).collect();
        match lines.len() {
            0 => {}
            1 => lines.push("it gives the same answer to every question".to_owned()),
            _ => lines.push("each of these gives the same answer to every question".to_owned()),
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
