//! The context of a picture: the reader's files, the answers of its functions, warnings; and the
//! evidence that the judge weighs.

use std::cell::OnceCell;

use slips::{ChapterProgram, Edit, Languages, Probe, Slip};

use crate::blind_spots;
use crate::candidate::Candidate;
use crate::lawful::Mismatch;
use crate::reading::Reading;
use crate::search::{self, DrawingMutants, Repair, TypedText};
use crate::sources::{CorrectedLine, LineStatus, Sources};
use crate::task::Task;

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

/// A program is refuted if it differs in more than one of this many answers: rounding explains no
/// more.
const REFUTING: usize = 50;

impl Context<'_> {
    /// Returns the task by each version of the book whose picture counts as right, for a picture of
    /// that size: version 4, and version 3 in the chapter's own shape unless the reader types our
    /// files.
    pub(crate) fn versions(&self, task: &Task, width: u32, height: u32) -> Vec<Task> {
        let newest = task.fitting(width, height);
        let older = newest.by_version_3().filter(|_| self.sources.is_empty());
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
        let task = task.without_probe();
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

/// The evidence in the judgment of one picture: the picture, its context, and what searches of both
/// have found, each done once when it is first asked for.
pub(crate) struct Evidence<'a> {
    /// The task; without its probe, if that is about another width than the picture's.
    pub(crate) task: Task,
    /// The picture as it was read.
    pub(crate) reading: &'a Reading,
    /// True if the picture has numbers that are no levels from 0 to 255.
    pub(crate) has_invalid_levels: bool,
    /// The context of the picture.
    pub(crate) context: &'a Context<'a>,
    /// The change that makes the reader's program right.
    repair: OnceCell<Option<Repair>>,
    /// The single edits of the chapter that draw the picture.
    drawn: OnceCell<DrawingMutants>,
    /// The slips that the chapter's own picture hides.
    passed: OnceCell<Vec<&'static Slip>>,
}

impl<'a> Evidence<'a> {
    /// Collects the evidence; nothing is searched yet.
    pub(crate) fn new(task: &Task, reading: &'a Reading, context: &'a Context<'a>) -> Self {
        let has_another_width =
            |probe: Probe| probe.spheres.is_none() && probe.width != reading.width;
        Self {
            task: match task.probe.is_some_and(has_another_width) {
                true => task.whole_chapter(),
                false => *task,
            },
            reading,
            has_invalid_levels: reading.invalid_levels().is_some(),
            context,
            repair: OnceCell::new(),
            drawn: OnceCell::new(),
            passed: OnceCell::new(),
        }
    }

    /// Searches for a change of the text that is typed in a page that makes the program right.
    pub(crate) fn repair(&self) -> Option<&Repair> {
        let typed = self.context.typed.as_ref();
        let repair = || Repair::find(&self.task, self.reading, typed?);
        self.repair.get_or_init(repair).as_ref()
    }

    /// Searches for the single edits that draw the picture, of the chapter's text for the `right`
    /// task.
    pub(crate) fn drawing_mutants(&self, right: &Task) -> &DrawingMutants {
        let drawn = || search::drawn(right, self.reading, &self.context.sources);
        self.drawn.get_or_init(drawn)
    }

    /// Iterates over the slips that the reader can have made in the task.
    pub(crate) fn slips(&self, task: &Task) -> impl Iterator<Item = &'static Slip> {
        let chapter = task.chapter;
        let unnamed = slips::unnamed().filter(move |slip| slip.is_possible_in(chapter));
        let can_be_made = |slip: &&Slip| self.context.can_be_made.is_none_or(|can_be| can_be(slip));
        let all = task.slips().chain(unnamed).filter(can_be_made);
        all.filter(|slip| self.has_passed(slip))
    }

    /// Returns false if a probe is drawn and a program with that slip spoils the chapter's own
    /// picture, which the reader has drawn right before. True for a slip without a name.
    fn has_passed(&self, slip: &Slip) -> bool {
        if self.task.probe.is_none() || slip.name.is_empty() {
            return true;
        }
        let hidden = || blind_spots::hidden_slips(&self.task, self.task.chapter.book_width());
        let passed = self.passed.get_or_init(hidden);
        passed.iter().any(|it| it.name == slip.name)
    }

    /// Returns true if the reader's files or functions speak against a program: the right line of
    /// one of its slips stands in the files, the program is a step's and the files have the whole
    /// chapter, or more than one in [`REFUTING`] answers differ. The right program of the whole
    /// chapter is never refuted.
    pub(crate) fn refutes(&self, it: &Candidate) -> bool {
        let context = self.context;
        let is_right =
            |slip: &&'static Slip| context.line_status(slip, &it.task) == LineStatus::Right;
        if it.slips.iter().any(is_right) {
            return true;
        }
        let is_further = it.task.step().is_some() && context.sources.is_written();
        let is_right = it.slips.is_empty() && it.task.step().is_none();
        is_further
            || !is_right
                && context.answers.is_some_and(|compare| {
                    let mismatch = compare(&it.task.without_probe().program(&it.slips));
                    mismatch.differing * REFUTING > mismatch.asked
                })
    }

    /// Returns true if fewer answers of the reader's functions differ from the whole chapter's than
    /// from those of this step: the reader is past the step.
    pub(crate) fn is_past(&self, step: &Task) -> bool {
        self.context.answers.is_some_and(|compare| {
            let [whole, step] =
                [self.task, *step].map(|it| compare(&it.without_probe().program(&[])).differing);
            whole < step
        })
    }

    /// Returns true if the wrong line of each slip of the candidate stands in the reader's files.
    pub(crate) fn has_lines_of(&self, it: &Candidate) -> bool {
        let is_found = |slip: &&Slip| self.context.wrong_line(slip, &it.task).is_some();
        it.slips.iter().all(is_found)
    }
}
