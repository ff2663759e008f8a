//! The verdict on a picture as data: what rule holds for it, and what explains it.
//!
//! [`judge`](crate::judge()) makes a [`Verdict`]; an [`Answer`](crate::answer::Answer) puts it into
//! words.

use common::rtweekend::Picture;
use difference::Difference;
use slips::{Probe, Slip};

use crate::answer::Row;
use crate::explanation::Explanation;
use crate::reading::Cause;
use crate::repair::Repair;
use crate::rules::{RIGHT, Rule, SEEN};
use crate::task::Task;

/// The verdict on a picture.
#[derive(Debug)]
pub struct Verdict {
    /// Why the picture is refused whatever it shows; `None` if it is not.
    pub refusal: Option<Refusal>,
    /// What the pixels show; `None` if none could be read, or too many in a shape that is not the
    /// chapter's.
    pub finding: Option<Box<Finding>>,
}

/// Why a picture is refused.
#[derive(Debug)]
pub struct Refusal {
    /// What is refused.
    pub kind: RefusalKind,
    /// Names the fault, and its fix.
    pub cause: Cause,
}

/// What is refused of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RefusalKind {
    /// The file is no picture, or has numbers that are no levels from 0 to 255.
    NotAPicture,
    /// Width and height are not those of the task.
    WrongShape,
    /// It is the right picture of another task: a probe's change was forgotten or is still in the
    /// program, or it is another chapter's.
    Another,
}

/// What the pixels of a picture show, and what explains them.
#[derive(Debug)]
pub struct Finding {
    /// The rule that holds.
    pub rule: &'static Rule,
    /// The task beside which the picture is explained, by the version and the step that suit the
    /// picture best.
    pub task: Task,
    /// The programs that draw the picture, or all but a few pixels of it; `None` if none does.
    pub explanation: Option<Explanation>,
    /// The right picture of the task, in the size of the reader's.
    pub right: Picture,
    /// The reader's picture, as a viewer shows it.
    pub yours: Picture,
    /// The pixels in which the two pictures differ; `None` if no pixel does.
    pub difference: Option<Difference>,
    /// Slips (known mistakes) that give the picture its shape, if that is not the chapter's: the
    /// shape is either the reader's choice or the work of one of these. Empty if there are none.
    pub shape_given_by: Vec<&'static Slip>,
    /// The probe (a changed scene) that tells most of the mistakes apart; `None` if there is only
    /// one mistake, or no probe does.
    pub telling: Option<Probe>,
    /// Observations about the picture, a sentence each; empty if it is explained.
    pub observations: Vec<String>,
    /// One or two rows about the first pixel that differs: its color, and the numbers of its ray as
    /// they should be, if it has any. Empty if the picture is explained.
    pub first_pixel: Vec<Row>,
    /// The change of the text that is typed in a page with which the program is right; `None` if
    /// none was found.
    pub repair: Option<Repair>,
    /// True if the reader's functions give the answers of the program that explains the picture,
    /// or were asked nothing.
    pub is_answered: bool,
    /// True if the picture is the sky alone, and the chapter has a sphere.
    pub is_only_sky: bool,
}

impl Verdict {
    /// Makes the verdict on a file that is no picture.
    pub fn not_a_picture(cause: Cause) -> Self {
        let kind = RefusalKind::NotAPicture;
        Self {
            refusal: Some(Refusal { kind, cause }),
            finding: None,
        }
    }

    /// Returns the exit code of a command: 0 for a right picture in a shape that no slip gives, 2
    /// for no picture, 1 for everything else.
    pub fn exit_code(&self) -> u8 {
        match (&self.refusal, &self.finding) {
            (Some(refusal), _) if refusal.kind == RefusalKind::NotAPicture => 2,
            (None, Some(it)) if it.is_right() && it.shape_given_by.is_empty() => 0,
            _ => 1,
        }
    }

    /// Returns true if the picture is right: the whole chapter, by a version, to the last bit or
    /// within the tolerance.
    pub fn is_right(&self) -> bool {
        self.refusal.is_none() && self.finding().is_some_and(Finding::is_right)
    }

    /// Returns the cause for which the picture is refused; `None` if it is not.
    pub fn cause(&self) -> Option<&Cause> {
        self.refusal.as_ref().map(|it| &it.cause)
    }

    /// Returns what the pixels show, if they were judged.
    pub fn finding(&self) -> Option<&Finding> {
        self.finding.as_deref()
    }
}

impl Finding {
    /// Returns true if the rule of right pictures holds for the whole chapter.
    pub fn is_right(&self) -> bool {
        self.rule.number == RIGHT && self.task.step.is_none()
    }

    /// Returns true if no program explains the picture, more than half of its pixels differ from
    /// the right ones, and some of them by more than a level.
    pub(crate) fn is_unlike(&self) -> bool {
        let difference = self.difference.as_ref();
        let is_most = difference.is_some_and(|it| 2 * it.count > it.total);
        self.rule.number == SEEN && is_most && self.levels() > 1
    }

    /// Counts the pixels of the picture.
    pub(crate) fn total(&self) -> usize {
        self.yours.rgb().len() / 3
    }

    /// Counts the pixels that differ from the right ones.
    pub(crate) fn off(&self) -> usize {
        self.difference.as_ref().map_or(0, |it| it.count)
    }

    /// Returns the largest difference of a color component from the right picture, in levels; 0 if
    /// no pixel differs.
    pub fn levels(&self) -> u8 {
        self.difference.as_ref().map_or(0, |it| it.levels)
    }

    /// Returns the mistakes that draw the picture, each one slip or two that are made together, the
    /// likeliest first; empty if no known mistake does.
    pub fn mistakes(&self) -> Vec<&[&'static Slip]> {
        let by = self.explanation.iter().flat_map(|it| &it.by);
        let slips = by.map(|it| &*it.slips);
        slips.filter(|it| !it.is_empty()).collect()
    }

    /// Returns the slips of the only known mistake that draws the picture; empty if there is none,
    /// or more than one.
    pub fn only_mistake(&self) -> &[&'static Slip] {
        let explanation = self.explanation.as_ref();
        explanation.map_or(&[], |it| it.only_mistake())
    }
}
