//! The context of a picture: the reader's files, the answers of its functions, warnings.

use slips::{ChapterProgram, Edit, Languages, Slip};

use crate::lawful::Mismatch;
use crate::repair::TypedText;
use crate::sources::{CorrectedLine, LineStatus, Sources};
use crate::task::{Task, Version};

/// A function that compares the answers of the reader's functions with those of the given program,
/// and counts the answers that differ.
pub type CompareAnswers<'a> = dyn Fn(&ChapterProgram) -> Mismatch + 'a;

/// All that is known of a reader's program besides its picture; by default nothing.
#[derive(Default)]
pub struct Context<'a> {
    /// The languages in which lines are shown.
    pub languages: Languages,
    /// Returns true if the reader can have made the given slip (known mistake); `None` if every
    /// slip is possible.
    pub can_be_made: Option<&'a dyn Fn(&Slip) -> bool>,
    /// The reader's files; empty if they are not known.
    pub sources: Sources,
    /// The text that the reader types in a page, which is repaired; `None` elsewhere.
    pub typed: Option<TypedText<'a>>,
    /// Compares the answers of the reader's functions with those of a program; `None` if they were
    /// not asked.
    pub answers: Option<&'a CompareAnswers<'a>>,
    /// The warnings of the compiler, in its words, as plain text; empty if there are none.
    pub warnings: Vec<String>,
    /// For each step of the chapter in its order, true if the reader has done it before; empty if
    /// no steps are judged.
    pub steps: Vec<bool>,
}

impl Context<'_> {
    /// Returns the task by each version of the book whose picture counts as right, for a picture of
    /// that size: version 4, and version 3 in the chapter's own shape unless the reader types our
    /// files.
    pub(crate) fn versions(&self, task: &Task, width: u32, height: u32) -> Vec<Task> {
        let newest = task.fitting(width, height);
        let has_older = newest.size.is_none() && self.sources.is_empty();
        let older = has_older.then_some(Task {
            version: Version::Three,
            ..newest
        });
        [newest].into_iter().chain(older).collect()
    }

    /// Returns the line of a slip (known mistake), wrong and right, in the chapter of the task: in the
    /// book's C++ and in Rust, or in Rust alone.
    pub(crate) fn slip_lines(&self, slip: &Slip, task: &Task) -> Vec<Edit> {
        slip.lines_in(self.languages, task.chapter)
    }

    /// Returns true if the reader can have made the slip, as far as is known: the field
    /// `can_be_made` does not deny it, and its right line does not stand in the files.
    pub fn can_be_made(&self, slip: &Slip, task: &Task) -> bool {
        self.can_be_made.is_none_or(|can_be| can_be(slip))
            && self.line_status(slip, task) != LineStatus::Right
    }

    /// Finds out whether the slip's line is wrong or right in the reader's files.
    pub(crate) fn line_status(&self, slip: &Slip, task: &Task) -> LineStatus {
        if self.sources.is_empty() {
            return LineStatus::NotFound;
        }
        let task = Task {
            probe: None,
            ..*task
        };
        let right = task.program(&[]);
        self.sources.status(&right, &task.program(&[slip]))
    }

    /// Finds the reader's line that makes the slip; `None` if the files are not known or have none.
    pub(crate) fn wrong_line(&self, slip: &Slip, task: &Task) -> Option<CorrectedLine> {
        match self.line_status(slip, task) {
            LineStatus::Wrong(line) => Some(line),
            LineStatus::Right | LineStatus::NotFound => None,
        }
    }

    /// Returns true if the reader's functions give all answers of the program, or were not asked.
    pub(crate) fn is_answered_by(&self, program: &ChapterProgram) -> bool {
        self.answers
            .is_none_or(|compare| compare(program).differing == 0)
    }
}
