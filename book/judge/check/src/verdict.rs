//! The verdict on a picture as data: right, wrong, or no picture, with what explains it.
//!
//! [`judge`](crate::judge()) makes a [`Verdict`]; an [`Answer`](crate::answer::Answer) puts it into
//! words.

use common::rtweekend::Picture;
use difference::Difference;
use slips::{Probe, Slip, SphereCount};

use crate::answer::Row;
use crate::candidate::{Conversion, Unexplained};
use crate::reading::Cause;
use crate::search::{DrawingMutants, Repair};
use crate::task::Task;

/// The verdict on a picture: right, almost right, wrong, another task's, of a wrong shape, or no
/// picture at all.
#[derive(Debug)]
pub enum Verdict {
    /// The picture is right, to the last bit or within the tolerance.
    Right(RightPicture),
    /// The picture is right but for a few pixels, or shows a step on the way to the chapter;
    /// [`Finding::almost_right`] is set.
    AlmostRight(Finding),
    /// The picture is wrong; or it is right, and the answers of the reader's functions are not.
    Wrong(Finding),
    /// The picture is the right one of another task: a probe's change was forgotten or is still
    /// in the program, or it is another chapter's.
    Another {
        /// Names the task that the picture shows, and how to go on.
        cause: Cause,
        /// The tasks whose right picture this is, at least one; all are of one chapter.
        tasks: Vec<Task>,
    },
    /// Width and height of the picture are not those of the task.
    WrongShape {
        /// Names the size or the width that is expected, and slips (known mistakes) that give this
        /// size.
        cause: Cause,
        /// The explanation of the pixels; `None` for more than 2²⁰ pixels in a shape that is not
        /// the chapter's.
        finding: Option<Box<Finding>>,
    },
    /// The file is no picture, or has numbers that are no levels from 0 to 255.
    NotAPicture {
        /// Names the fault of the file, and its fix.
        cause: Cause,
        /// The explanation of its pixels; `None` if none could be read.
        finding: Option<Box<Finding>>,
    },
}

/// A picture that version 4 or 3 of the book draws, to the last bit or within the tolerance.
#[derive(Clone, Debug)]
pub struct RightPicture {
    /// The task that the picture fulfills, by version 4 if that draws it.
    pub task: Task,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Number of pixels that differ from the right ones; 0 if the picture is right to the last
    /// bit.
    pub off: usize,
    /// Largest difference of a color component, in levels; at most the tolerance.
    pub levels: u8,
    /// Slips (known mistakes) that give the picture its shape, if that is not the chapter's: the
    /// shape is either the reader's choice or the work of one of these. Empty if there are none.
    pub shape_given_by: Vec<&'static Slip>,
}

/// The explanation of a picture that is not right to the last bit.
#[derive(Debug)]
pub struct Finding {
    /// The task beside which the picture is explained, by the version and the step that suit the
    /// picture best.
    pub task: Task,
    /// The right picture of the task, in the size of the reader's.
    pub right: Picture,
    /// The reader's picture, as a viewer shows it.
    pub yours: Picture,
    /// The pixels in which the two pictures differ; `None` if no pixel does.
    pub difference: Option<Difference>,
    /// The few pixels that are wrong, perhaps none, in a picture that otherwise shows the task or a
    /// step of it. `None` if the picture is wrong.
    pub almost_right: Option<Unexplained>,
    /// The known mistakes that draw the picture; `None` if none does.
    pub mistakes: Option<Mistakes>,
    /// The single edits of the chapter's text that draw the picture; empty if a known mistake
    /// does.
    pub drawn: DrawingMutants,
    /// Observations about the picture, a sentence each; empty if a known mistake draws it.
    pub observations: Vec<String>,
    /// One or two rows about the first pixel that differs: its color, and the numbers of its ray as
    /// they should be, if it has any. Empty if a known mistake draws the picture.
    pub first_pixel: Vec<Row>,
    /// The change of the text that is typed in a page that was tried and makes the program right;
    /// `None` if none was found.
    pub repair: Option<Repair>,
    /// True if the reader's functions give the answers of the program that explains the picture,
    /// or were asked nothing.
    pub is_answered: bool,
}

/// The known mistakes of readers, each of which alone draws the reader's picture, exactly or
/// nearly.
#[derive(Clone, Debug)]
pub struct Mistakes {
    /// The task in whose program the mistakes are made.
    pub task: Task,
    /// The mistakes, at least one; each is one slip, or two that are made together. The likeliest
    /// is the first.
    pub all: Vec<Vec<&'static Slip>>,
    /// The treatment of numbers that are no levels from 0 to 255, with which the mistakes draw the
    /// picture.
    pub conversion: Conversion,
    /// True if the wrong lines stand in the reader's files, or no file is known.
    pub is_in_text: bool,
    /// The pixels that the mistakes don't explain; its counts are 0 if they draw exactly the
    /// picture.
    pub unexplained: Unexplained,
    /// The probe (a changed scene) that tells most of the mistakes apart; `None` if there is only
    /// one mistake, or no probe does.
    pub telling: Option<Probe>,
}

impl Verdict {
    /// Returns the exit code of a command: 0 for a right picture in a shape that no slip gives, 2
    /// for no picture, 1 for everything else.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Right(right) if right.shape_given_by.is_empty() => 0,
            Self::NotAPicture { .. } => 2,
            _ => 1,
        }
    }

    /// Returns the cause for which the picture was refused; `None` for a picture that is right,
    /// almost right or wrong.
    pub fn cause(&self) -> Option<&Cause> {
        match self {
            Self::Another { cause, .. }
            | Self::WrongShape { cause, .. }
            | Self::NotAPicture { cause, .. } => Some(cause),
            Self::Right(_) | Self::AlmostRight(_) | Self::Wrong(_) => None,
        }
    }

    /// Returns the explanation of a picture that is wrong or almost right; `None` if the picture is
    /// right, is another task's, or has no pixels or too many to explain.
    pub fn finding(&self) -> Option<&Finding> {
        match self {
            Self::Right(_) | Self::Another { .. } => None,
            Self::AlmostRight(finding) | Self::Wrong(finding) => Some(finding),
            Self::WrongShape { finding, .. } | Self::NotAPicture { finding, .. } => {
                finding.as_deref()
            }
        }
    }
}

impl RightPicture {
    /// Counts the pixels of the picture.
    pub(crate) fn total(&self) -> usize {
        self.width as usize * self.height as usize
    }
}

impl Finding {
    /// Returns true if no program explains the picture, more than half of its pixels differ from
    /// the right ones, and some of them by more than a level.
    pub(crate) fn is_unlike(&self) -> bool {
        let is_explained = self.almost_right.is_some() || self.mistakes.is_some();
        let difference = self.difference.as_ref();
        let is_most = difference.is_some_and(|it| 2 * it.count > it.total);
        !is_explained && is_most && self.levels() > 1
    }

    /// Counts the pixels of the picture.
    pub(crate) fn total(&self) -> usize {
        self.right.rgb().len() / 3
    }

    /// Returns true if the reader's picture is the sky alone, and the chapter has a sphere.
    pub(crate) fn shows_only_sky(&self) -> bool {
        let (width, height) = (self.yours.width(), self.yours.height());
        self.task.chapter.sphere_count() != SphereCount::None
            && self.yours == self.task.sky_picture(width, height)
    }

    /// Returns the largest difference of a color component from the right picture, in levels; 0 if
    /// no pixel differs.
    pub fn levels(&self) -> u8 {
        self.difference.as_ref().map_or(0, |it| it.levels)
    }

    /// Returns the slips of the only known mistake that draws the picture; empty if there is none,
    /// or more than one.
    pub fn only_mistake(&self) -> &[&'static Slip] {
        match &self.mistakes {
            Some(Mistakes { all, .. }) if all.len() == 1 => &all[0],
            _ => &[],
        }
    }
}
