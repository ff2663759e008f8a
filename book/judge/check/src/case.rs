//! A picture to be judged, with all that is known and found out of it, each thing once.

use std::cell::OnceCell;

use slips::{Chapter, Probe, Slip, SphereCount};

use crate::blind_spots;
use crate::candidate::{Candidate, Conversion, Drawn, Unexplained};
use crate::context::Context;
use crate::explanation::Explanation;
use crate::generated;
use crate::pixels::{distance, spread};
use crate::reading::Reading;
use crate::repair::Repair;
use crate::sources::LineStatus;
use crate::task::Task;
use crate::work::Work;

/// A picture to be judged. Each explanation is looked for when it is first asked for.
pub(crate) struct Case<'a> {
    /// The task; without its probe, if that is about another width than the picture's.
    pub(crate) task: Task,
    /// True if the task's probe is about another width.
    has_another_width: bool,
    /// The picture as it was read.
    pub(crate) reading: &'a Reading,
    /// How many levels a component of a right picture may be off.
    pub(crate) tolerance: u8,
    /// The context of the picture.
    pub(crate) context: &'a Context<'a>,
    /// The work that is left.
    pub(crate) work: Work,
    conversion: OnceCell<Conversion>,
    is_only_sky: OnceCell<bool>,
    right: OnceCell<Explanation>,
    places: OnceCell<Places>,
    elsewhere: OnceCell<Option<Explanation>>,
    mistake: OnceCell<Option<Explanation>>,
    repair: OnceCell<Option<Repair>>,
    pair: OnceCell<Option<Explanation>>,
    generated: OnceCell<Option<Explanation>>,
    /// The slips that the chapter's own picture hides.
    passed: OnceCell<Vec<&'static Slip>>,
}

/// Samples of pixels by which programs are told apart.
pub(crate) struct Places {
    /// Pixels that the right program draws otherwise.
    pub(crate) wrong: Vec<u32>,
    /// Pixels of the whole picture.
    pub(crate) all: Vec<u32>,
}

/// The size of the sample of wrong pixels.
const WRONG: u32 = 60;
/// The size of the sample of the whole picture.
const ALL: u32 = 2000;
/// A program is refuted if it differs in more than one of this many answers: rounding explains no
/// more.
const REFUTING: usize = 50;

impl Places {
    /// Returns true if a program draws all of these pixels.
    pub(crate) fn are_drawn_by(&self, drawn: &Drawn) -> bool {
        drawn.leaves(&self.wrong, 0, 0) && drawn.leaves(&self.all, 0, 0)
    }
}

impl<'a> Case<'a> {
    /// Makes the case of a picture; nothing is looked for yet.
    pub(crate) fn new(
        task: &Task,
        reading: &'a Reading,
        tolerance: u8,
        context: &'a Context<'a>,
    ) -> Self {
        let has_another_width =
            |probe: Probe| probe.spheres.is_none() && probe.width != reading.width;
        Self {
            task: match task.probe.is_some_and(has_another_width) {
                true => Task::of(task.chapter),
                false => *task,
            },
            has_another_width: task.probe.is_some_and(has_another_width),
            reading,
            tolerance,
            context,
            work: Work::new(),
            conversion: OnceCell::new(),
            is_only_sky: OnceCell::new(),
            right: OnceCell::new(),
            places: OnceCell::new(),
            elsewhere: OnceCell::new(),
            mistake: OnceCell::new(),
            repair: OnceCell::new(),
            pair: OnceCell::new(),
            generated: OnceCell::new(),
            passed: OnceCell::new(),
        }
    }

    /// Returns true if a right program draws the picture, and the reader's functions answer as its
    /// functions do or nothing explains that they do not.
    pub(crate) fn is_right(&self) -> bool {
        let left = self.left_by_right();
        let is_drawn = left.is_nothing() || left.levels <= u16::from(self.tolerance);
        let is_explained = || {
            let mistake = self.mistake();
            mistake.is_some_and(|it| it.is_in_text) || self.repair().is_some()
        };
        is_drawn
            && !self.has_another_width
            && (self.is_answered_by(&self.right().by[0]) || !is_explained())
    }

    /// Returns true if this is the chapter's own picture, where a probe's in another width was asked
    /// for.
    pub(crate) fn has_forgotten_width(&self) -> bool {
        self.has_another_width && self.left_by_right().is_nothing()
    }

    /// Returns true if the picture is another task's: a probe's change was forgotten or is still in
    /// the program, or no known mistake draws it, too.
    pub(crate) fn is_elsewhere(&self) -> bool {
        let elsewhere = self.elsewhere().filter(|_| !self.is_right());
        elsewhere.is_some_and(|it| it.is_forgotten_change(self) || self.mistake().is_none())
    }

    /// Returns true if neither the task nor another one explains the picture.
    pub(crate) fn is_open(&self) -> bool {
        !self.is_right() && !self.is_elsewhere()
    }

    /// Returns the right program that leaves fewest pixels unexplained.
    pub(crate) fn right(&self) -> &Explanation {
        self.right.get_or_init(|| Explanation::right(self))
    }

    /// Returns the right programs of other tasks, of one chapter, whose picture this is.
    pub(crate) fn elsewhere(&self) -> Option<&Explanation> {
        let find = || Explanation::elsewhere(self);
        self.elsewhere.get_or_init(find).as_ref()
    }

    /// Returns the known mistakes that draw the picture.
    pub(crate) fn mistake(&self) -> Option<&Explanation> {
        let find = || Explanation::mistake(self);
        self.mistake.get_or_init(find).as_ref()
    }

    /// Returns the change of the text that is typed in a page with which the program is right.
    pub(crate) fn repair(&self) -> Option<&Repair> {
        let typed = self.context.typed.as_ref();
        let find = || Repair::find(self, typed?);
        self.repair.get_or_init(find).as_ref()
    }

    /// Returns the pairs of known mistakes that draw the picture.
    pub(crate) fn pair(&self) -> Option<&Explanation> {
        self.pair.get_or_init(|| Explanation::pair(self)).as_ref()
    }

    /// Returns the single edits of the chapter that draw the picture.
    pub(crate) fn generated(&self) -> Option<&Explanation> {
        let find = || generated::explanation(self);
        self.generated.get_or_init(find).as_ref()
    }

    /// Returns the samples of pixels by which programs are told apart.
    pub(crate) fn places(&self) -> &Places {
        self.places.get_or_init(|| {
            let (reading, total) = (self.reading, self.reading.pixels.len() as u32);
            let right = self.task.fitting(reading.width, reading.height);
            let right = right.right_picture(reading.width, reading.height);
            let (levels, _) = right.rgb().as_chunks::<3>();
            let is_wrong = |n: &u32| {
                let right = levels[*n as usize].map(i16::from);
                distance(right, reading.pixels[*n as usize]) > 0
            };
            let wrong: Vec<u32> = (0..total).filter(is_wrong).collect();
            let some = spread(WRONG, wrong.len() as u32);
            Places {
                wrong: some.map(|n| wrong[n as usize]).collect(),
                all: spread(ALL, total).collect(),
            }
        })
    }

    /// Returns how numbers that are no levels stand in the picture.
    pub(crate) fn conversion(&self) -> Conversion {
        *self
            .conversion
            .get_or_init(|| match self.reading.invalid_levels() {
                Some(_) => Conversion::Printed,
                None => Conversion::Clamped,
            })
    }

    /// Returns true if the picture is the sky alone, and the chapter has a sphere.
    pub(crate) fn is_only_sky(&self) -> bool {
        *self.is_only_sky.get_or_init(|| {
            let (width, height) = (self.reading.width, self.reading.height);
            self.task.chapter.sphere_count() != SphereCount::None
                && self.reading.picture() == self.task.sky_picture(width, height)
        })
    }

    /// Returns true if the reader's functions answer as those of a program.
    pub(crate) fn is_answered_by(&self, by: &Candidate) -> bool {
        self.context.is_answered_by(&without_probe(by))
    }

    /// Iterates over the slips that the reader can have made in a chapter.
    pub(crate) fn slips(&self, chapter: Chapter) -> impl Iterator<Item = &'static Slip> {
        let unnamed = slips::unnamed().filter(move |slip| slip.is_possible_in(chapter));
        let can_be_made = |slip: &&Slip| self.context.can_be_made.is_none_or(|can_be| can_be(slip));
        let all = Task::of(chapter).slips().chain(unnamed);
        all.filter(can_be_made).filter(|slip| self.has_passed(slip))
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
        let is_further = it.task.step.is_some() && context.sources.is_written();
        let is_right = it.slips.is_empty() && it.task.step.is_none();
        is_further
            || !is_right
                && context.answers.is_some_and(|compare| {
                    let mismatch = compare(&without_probe(it));
                    mismatch.differing * REFUTING > mismatch.asked
                })
    }

    /// Returns true if fewer answers of the reader's functions differ from the whole chapter's than
    /// from those of this step: the reader is past the step.
    pub(crate) fn is_past(&self, step: &Task) -> bool {
        self.context.answers.is_some_and(|compare| {
            let [whole, step] = [self.task, *step].map(|task| {
                let right = Candidate::right(task, Conversion::Clamped);
                compare(&without_probe(&right)).differing
            });
            whole < step
        })
    }

    /// Returns true if the wrong line of each slip of the candidate stands in the reader's files.
    pub(crate) fn has_lines_of(&self, it: &Candidate) -> bool {
        let is_found = |slip: &&Slip| self.context.wrong_line(slip, &it.task).is_some();
        it.slips.iter().all(is_found)
    }

    /// Returns the pixels that the right program leaves unexplained.
    pub(crate) fn left_by_right(&self) -> &Unexplained {
        &self.right().left
    }
}

/// Returns the program of a candidate as it is without a probe.
fn without_probe(by: &Candidate) -> slips::ChapterProgram {
    let task = Task {
        probe: None,
        ..by.task
    };
    Candidate { task, ..by.clone() }.program()
}
