//! What is known of a reader besides the picture: files, answers of functions, warnings.

use std::cell::OnceCell;

use interpreter::SourceFile;
use laws::Mismatch;
use slips::{ChapterProgram, Edition, ReaderLanguage, Slip, SlipText};

use crate::blind_spots;
use crate::candidate::Candidate;
use crate::reading::Reading;
use crate::search::{self, DrawingMutants, Repair};
pub(crate) use crate::sources::LineStatus;
use crate::sources::{CorrectedLine, Sources};
use crate::task::Task;

/// Compares the answers of the reader's functions with those of a chapter's program.
pub type CompareAnswers<'a> = dyn Fn(&ChapterProgram) -> Mismatch + 'a;

/// What is known besides the picture.
#[derive(Default)]
pub struct Context<'a> {
    /// The language in which the reader writes; `None` means the C++ of the edition.
    pub language: Option<ReaderLanguage>,
    /// True if the reader can have made a slip; any, if nothing is known.
    pub can_be_made: Option<&'a dyn Fn(&Slip) -> bool>,
    /// What the reader wrote.
    pub sources: Sources,
    /// What the reader's functions answered.
    pub answers: Option<&'a CompareAnswers<'a>>,
    /// What the compiler warned of, in its words.
    pub warnings: Vec<String>,
    /// True if each step of the chapter has been done before, if steps are judged.
    pub steps: Vec<bool>,
}

/// More answers than one in fifty are not due to rounding.
const REFUTING: usize = 50;

impl Context<'_> {
    /// Returns true if what the reader wrote follows version 4 of the book, as our chapters do: no
    /// earlier one has such names.
    pub(crate) fn follows_version_4(&self) -> bool {
        let has_names =
            |it: &SourceFile| it.text.contains("pixel_delta") || it.text.contains("pixel00");
        self.sources.are_of_the_chapter() || self.sources.files().iter().any(has_names)
    }

    /// Returns what there is to say of a slip in the scene, in the reader's language.
    pub fn words(&self, slip: &Slip, task: &Task) -> SlipText {
        let is_older = task.edition != Edition::V4;
        let language = match self.language {
            Some(ReaderLanguage::Python(_)) => ReaderLanguage::Python(task.edition),
            // In Rust there are the lines of our chapters, which follow version 4.
            Some(ReaderLanguage::Rust) if is_older && slip.has_older_line(task.chapter) => {
                ReaderLanguage::Cpp(task.edition)
            }
            Some(language) => language,
            None => ReaderLanguage::Cpp(task.edition),
        };
        slip.words(language, task.chapter)
    }

    /// Returns true if the reader can have made the slip, as far as it is known.
    pub fn can_be_made(&self, slip: &Slip, task: &Task) -> bool {
        self.can_be_made.is_none_or(|can_be| can_be(slip))
            && self.said(slip, task) != LineStatus::Right
    }

    /// Returns true if the slip's line is right in the reader's files once they are repaired.
    pub(crate) fn is_mended(&self, slip: &Slip, task: &Task, repair: &Repair) -> bool {
        let repaired = Sources::new(repair.files.clone(), Vec::new());
        self.sources.say(slip, task).0 == LineStatus::Wrong
            && repaired.say(slip, task).0 == LineStatus::Right
    }

    /// Returns what the reader's files say of the slip. A line that an older edition has is wrong
    /// in a mixture only, which no single line tells.
    pub(crate) fn said(&self, slip: &Slip, task: &Task) -> LineStatus {
        self.sources.say(slip, task).0
    }

    /// The reader's line that makes the slip, if it is found.
    pub(crate) fn line_of(&self, slip: &Slip, task: &Task) -> Option<CorrectedLine> {
        self.sources.say(slip, task).1
    }

    /// Returns true if the reader's functions answer as the program would.
    pub(crate) fn is_answered_by(&self, program: &ChapterProgram) -> bool {
        self.answers
            .is_none_or(|compare| compare(program).differing == 0)
    }
}

/// All that is known of what a reader did.
pub(crate) struct Evidence<'a> {
    /// The scene that the picture is meant to show; the chapter's own instead of a probe
    /// that is about another width.
    pub(crate) task: Task,
    /// The picture.
    pub(crate) reading: &'a Reading,
    /// True if it has numbers that are no levels.
    pub(crate) has_no_levels: bool,
    /// What is known besides.
    pub(crate) context: &'a Context<'a>,
    repair: OnceCell<Option<Repair>>,
    drawn: OnceCell<DrawingMutants>,
    passed: OnceCell<Vec<&'static Slip>>,
}

impl<'a> Evidence<'a> {
    pub(crate) fn new(task: &Task, reading: &'a Reading, context: &'a Context<'a>) -> Self {
        let is_about_another_width = task
            .probe
            .is_some_and(|probe| probe.spheres.is_none() && probe.width != reading.width);
        Self {
            task: if is_about_another_width {
                task.without_probe()
            } else {
                *task
            },
            reading,
            has_no_levels: reading.outside().is_some(),
            context,
            repair: OnceCell::new(),
            drawn: OnceCell::new(),
            passed: OnceCell::new(),
        }
    }

    /// Returns what makes the reader's program right.
    pub(crate) fn repair(&self) -> Option<&Repair> {
        let before = self.context.steps.len().saturating_sub(1);
        let repair = || Repair::of(&self.task, self.reading, &self.context.sources, before);
        self.repair.get_or_init(repair).as_ref()
    }

    /// The single edits that draw the picture, of the text of the scene that comes nearest.
    pub(crate) fn drawn(&self, right: &Task) -> &DrawingMutants {
        let drawn = || search::drawn(right, self.reading, &self.context.sources);
        self.drawn.get_or_init(drawn)
    }

    /// The slips that the reader can have made in the scene.
    pub(crate) fn slips(&self, task: &Task) -> impl Iterator<Item = &'static Slip> {
        let chapter = task.chapter;
        let unnamed = slips::unnamed().filter(move |slip| slip.is_possible_in(chapter));
        let can_be_made = |slip: &&Slip| self.context.can_be_made.is_none_or(|can_be| can_be(slip));
        let all = task.slips().chain(unnamed).filter(can_be_made);
        all.filter(|slip| self.has_passed(slip))
    }

    /// Returns true if a program with that slip draws the right picture of the chapter, which a
    /// probe follows.
    fn has_passed(&self, slip: &Slip) -> bool {
        if self.task.probe.is_none() || slip.name.is_empty() {
            return true;
        }
        let hidden = || blind_spots::hidden(&self.task, self.task.chapter.book_width());
        let passed = self.passed.get_or_init(hidden);
        passed.iter().any(|it| it.name == slip.name)
    }

    /// Returns true if the reader's text or the answers of its functions speak against a program:
    /// the right line of a slip stands there, or a function that answers so has another mistake or
    /// none.
    pub(crate) fn is_refuted(&self, it: &Candidate) -> bool {
        let context = self.context;
        let is_right = |slip: &&'static Slip| context.said(slip, &it.task) == LineStatus::Right;
        if it.slips.iter().any(is_right) {
            return true;
        }
        let is_further = it.task.step().is_some() && context.sources.is_written();
        let is_right = it.slips.is_empty() && it.task.step().is_none();
        is_further
            || !is_right
                && context.answers.is_some_and(|compare| {
                    let mismatch = compare(&it.task.unchanged().program(&it.slips));
                    mismatch.differing * REFUTING > mismatch.asked
                })
    }

    /// Returns true if the reader's functions answer more like the whole chapter's than like those
    /// of this step: the reader is past it.
    pub(crate) fn is_past(&self, step: &Task) -> bool {
        self.context.answers.is_some_and(|compare| {
            let [whole, step] =
                [self.task, *step].map(|it| compare(&it.unchanged().program(&[])).differing);
            whole < step
        })
    }

    /// Returns true if the wrong line of each of its slips stands in the reader's files.
    pub(crate) fn is_found(&self, it: &Candidate) -> bool {
        let is_found = |slip: &&Slip| self.context.said(slip, &it.task) == LineStatus::Wrong;
        it.slips.iter().all(is_found)
    }
}
