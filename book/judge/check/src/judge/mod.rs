//! The judge: comes to a [`Verdict`] on a picture, in one order of questions.
//!
//! First it looks at the picture's numbers, then at its shape, then whether the picture is right.
//! Only of other pictures [`explain`] asks which program draws them.

mod explain;
mod finding;

use difference::Comparison;

use crate::causes;
use crate::context::Context;
use crate::reading::{self, Reading};
use crate::task::Task;
use crate::verdict::{Finding, RightPicture, Verdict};

/// Judges the picture in the bytes of a file, PPM or PNG, as [`judge`] does. Bytes that can't be
/// read get the verdict [`Verdict::NotAPicture`].
pub fn judge_file(task: &Task, bytes: &[u8], tolerance: u8, context: &Context) -> Verdict {
    match reading::read(bytes) {
        Ok(reading) => judge(task, &reading, tolerance, context),
        Err(cause) => Verdict::NotAPicture {
            cause,
            finding: None,
        },
    }
}

/// Judges a picture that was read: whether it fulfills the task, and if not, what explains that.
///
/// The picture is right if version 4 or 3 of the book draws it with every color component at most
/// `tolerance` levels off (0 asks for equality), unless the reader's functions answer otherwise
/// than the chapter's and a mistake or a repair explains that. A reader's files are judged by
/// version 4 alone.
pub fn judge(task: &Task, reading: &Reading, tolerance: u8, context: &Context) -> Verdict {
    if let Some(cause) = causes::invalid_levels(reading) {
        let finding = Finding::of(task, reading, context).ok();
        return Verdict::NotAPicture { cause, finding };
    }
    let (width, height) = (reading.width, reading.height);
    let another_width = causes::not_as_wide(task, reading);
    let may_be_right = another_width.is_none();
    let shape = another_width.or_else(|| causes::wrong_shape(task, width, height));
    if may_be_right
        && (shape.is_none() || causes::is_a_shape_to_choose(width, height))
        && let Some(right) = RightPicture::of(task, reading, tolerance, context)
    {
        return of_right(task, reading, context, right, shape.is_some());
    }
    let size = u64::from(width) * u64::from(height);
    let has_own_shape = task.whole_chapter().height(width) == height;
    match shape {
        Some(cause) if size > causes::MOST_MISSHAPEN && !has_own_shape => Verdict::WrongShape {
            cause,
            finding: None,
        },
        shape => match Finding::of(task, reading, context) {
            Err(tasks) => Verdict::Another {
                cause: causes::another(task, &tasks, context.languages),
                tasks,
            },
            Ok(finding) => match (shape, &finding.almost_right) {
                (None, Some(_)) => Verdict::AlmostRight(*finding),
                // In a shape that nobody chooses, no picture is right to the last bit.
                (Some(_), Some(few)) if !few.is_nothing() => Verdict::AlmostRight(*finding),
                (Some(cause), _) if finding.mistakes.is_none() => Verdict::WrongShape {
                    cause,
                    finding: Some(finding),
                },
                _ => Verdict::Wrong(*finding),
            },
        },
    }
}

/// Judges a picture whose task was guessed. If the picture is the right one of another task, it is
/// judged as that. Returns the task as which it was judged, and the verdict.
pub fn judge_guessed(
    task: &Task,
    reading: &Reading,
    tolerance: u8,
    context: &Context,
) -> (Task, Verdict) {
    let verdict = judge(task, reading, tolerance, context);
    let Verdict::Another { tasks, .. } = &verdict else {
        return (*task, verdict);
    };
    let other = task.of_chapter(tasks[0].chapter);
    let probed = tasks[0].probe.and_then(|probe| other.with_probe(probe));
    let other = probed.unwrap_or(other);
    (other, judge(&other, reading, tolerance, context))
}

/// Returns the verdict on a right picture: wrong only if the reader's functions give other answers
/// than the chapter's, and a mistake or a repair explains these.
fn of_right(
    task: &Task,
    reading: &Reading,
    context: &Context,
    right: RightPicture,
    has_another_shape: bool,
) -> Verdict {
    if !context.is_answered_by(&right.task.program(&[]))
        && let Ok(finding) = Finding::of(task, reading, context)
        && (finding.mistakes.is_some() || finding.repair.is_some())
    {
        return Verdict::Wrong(*finding);
    }
    let shape_given_by = if has_another_shape {
        causes::slips_giving(task, right.width, right.height)
    } else {
        Vec::new()
    };
    Verdict::Right(RightPicture {
        shape_given_by,
        ..right
    })
}

impl RightPicture {
    /// Finds the first version that draws the picture to the last bit, or else the first that
    /// draws it within the tolerance; `None` if none does.
    fn of(task: &Task, reading: &Reading, tolerance: u8, context: &Context) -> Option<Self> {
        let (width, height) = (reading.width, reading.height);
        let within = |tolerance| {
            let tasks = context.versions(task, width, height).into_iter();
            let off = |task: Task| {
                let is_near = task.may_be_shown_by(reading, tolerance);
                let right = is_near.then(|| task.right_picture(width, height))?;
                let (off, levels) = match Comparison::of(&right, &reading.picture()) {
                    Comparison::Pixels(difference) => (difference.count, difference.levels),
                    _ => (0, 0),
                };
                (levels <= tolerance).then_some((task, off, levels))
            };
            let mut near = tasks.filter_map(off);
            let (task, off, levels) = near.next()?;
            Some(Self {
                task,
                width,
                height,
                off,
                levels,
                shape_given_by: Vec::new(),
            })
        };
        within(0).or_else(|| within(tolerance))
    }
}
