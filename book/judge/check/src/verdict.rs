//! The verdict on a picture: right, wrong, or no picture, with what explains it.

use common::rtweekend::Picture;
use slips::{Edition, Probe, Slip, SphereCount};

use crate::answer::Row;
use crate::candidate::{Candidate, Conversion, Unexplained};
use crate::comparison::{Comparison, Difference};
use crate::context::{Context, Evidence};
use crate::judge::{Explanation, Fit, explain};
use crate::reading::{self, Cause, Reading};
use crate::search::{Drawn, Repair};
use crate::task::Task;
use crate::telling;
use crate::{candidates, causes, seen};

/// What there is to say about a picture.
#[derive(Debug)]
pub enum Verdict {
    /// It is right.
    Right(RightPicture),
    /// It is right but for something that is no mistake.
    AlmostRight(Finding),
    /// It is a picture, and not the right one.
    Wrong(Finding),
    /// It is right, but of another scene: a change was forgotten, or is still there, or
    /// it is another chapter's.
    Another {
        /// Which one it is, and how to go on.
        cause: Cause,
        /// The scenes that it shows: several if their right pictures are the same.
        tasks: Vec<Task>,
    },
    /// It is a picture of another shape than the scene's.
    WrongShape {
        /// The shape that it should have, and what gives this one.
        cause: Cause,
        /// What its pixels show, unless there are more than a million or so.
        finding: Option<Box<Finding>>,
    },
    /// It is no picture, or not a valid one.
    NotAPicture {
        /// Why.
        cause: Cause,
        /// What its pixels show, if there are any.
        finding: Option<Box<Finding>>,
    },
}

/// A right picture.
#[derive(Clone, Debug)]
pub struct RightPicture {
    /// The scene, by the latest edition of the book that draws this picture.
    pub task: Task,
    /// All editions that do.
    pub editions: Vec<Edition>,
    /// Pixels in a row.
    pub width: u32,
    /// Number of rows.
    pub height: u32,
    /// How many pixels are off at all; 0 means equal to the last bit.
    pub off: usize,
    /// The farthest that a component is off, in levels; no more than was
    /// tolerated.
    pub levels: u8,
    /// Slips that give it its shape, if that is not the chapter's: it may have been a
    /// choice, or one of these.
    pub shape_given_by: Vec<&'static Slip>,
}

/// What explains a picture that is not right to the last bit.
#[derive(Debug)]
pub struct Finding {
    /// The scene that it shows, by the edition that explains most.
    pub task: Task,
    /// All editions that explain as much.
    pub editions: Vec<Edition>,
    /// The right picture of that scene in the same size.
    pub right: Picture,
    /// The reader's, as a viewer shows it.
    pub yours: Picture,
    /// Where the two differ; `None` if only the shape is wrong, or only numbers
    /// that are no levels.
    pub difference: Option<Difference>,
    /// What it is, if it is right but for something that is no mistake.
    pub almost_right: Option<AlmostRight>,
    /// The mistakes that draw it, if some are known.
    pub mistakes: Option<Mistakes>,
    /// The single edits of the chapter's text that draw it, where no known mistake does.
    pub drawn: Drawn,
    /// What can be seen, where nothing known draws it.
    pub sights: Vec<String>,
    /// The numbers of the first pixel that differs, as they should be, likewise.
    pub first: Vec<Row>,
    /// What makes the reader's program right, if that was found.
    pub repair: Option<Repair>,
    /// True if it explains all answers of the reader's functions, too.
    pub is_answered: bool,
}

/// A picture that is right, but for something that is no mistake.
#[derive(Clone, Debug)]
pub struct AlmostRight {
    /// The scene.
    pub task: Task,
    /// The pixels that are not explained.
    pub unexplained: Unexplained,
}

/// Mistakes that draw the same picture.
#[derive(Clone, Debug)]
pub struct Mistakes {
    /// The scene that they were made in.
    pub task: Task,
    /// One slip each, or two that were made together; those that more people
    /// reported come first.
    pub all: Vec<Vec<&'static Slip>>,
    /// What becomes of numbers that are no levels.
    pub conversion: Conversion,
    /// True if their lines stand in the reader's files, or no file is known.
    pub is_in_text: bool,
    /// The pixels that they leave unexplained.
    pub unexplained: Unexplained,
    /// A small change of scene that tells them apart, if there is one.
    pub telling: Option<Probe>,
}

/// Judges the picture in the `bytes` of a file, PPM or PNG, as [`judge`] does.
pub fn judge_file(task: &Task, bytes: &[u8], tolerance: u8, context: &Context) -> Verdict {
    match reading::read(bytes) {
        Ok(reading) => judge(task, &reading, tolerance, context),
        Err(cause) => Verdict::NotAPicture {
            cause,
            finding: None,
        },
    }
}

/// Judges a picture that was read.
pub fn judge(task: &Task, reading: &Reading, tolerance: u8, context: &Context) -> Verdict {
    let newest = task.only_by(Edition::V4);
    let task = if context.follows_version_4() {
        &newest
    } else {
        task
    };
    let (width, height) = (reading.width, reading.height);
    let another_width = causes::not_as_wide(task, reading);
    let may_be_right = another_width.is_none();
    let shape = another_width.or_else(|| causes::wrong_shape(task, width, height));
    if let Some(cause) = causes::no_levels(reading) {
        let finding = match Finding::of(task, reading, context) {
            Answer::Of(finding) => Some(finding),
            Answer::Another(_) => None,
        };
        return Verdict::NotAPicture { cause, finding };
    }
    if may_be_right
        && (shape.is_none() || causes::is_a_shape_to_choose(width, height))
        && let Some(right) = RightPicture::of(task, reading, tolerance)
    {
        return of_right(task, reading, context, right, shape.is_some());
    }
    let size = u64::from(width) * u64::from(height);
    let has_own_shape = task.without_probe().height(width) == height;
    match shape {
        Some(cause) if size > causes::MOST_MISSHAPEN && !has_own_shape => Verdict::WrongShape {
            cause,
            finding: None,
        },
        shape => match (Finding::of(task, reading, context), shape) {
            (Answer::Another(tasks), _) => Verdict::Another {
                cause: causes::another(task, &tasks, context.language),
                tasks,
            },
            // In a shape that nobody chooses, a right picture is none.
            (Answer::Of(finding), None) if finding.almost_right.is_some() => {
                Verdict::AlmostRight(*finding)
            }
            (Answer::Of(finding), Some(_))
                if finding
                    .almost_right
                    .as_ref()
                    .is_some_and(AlmostRight::has_odd_pixels) =>
            {
                Verdict::AlmostRight(*finding)
            }
            (Answer::Of(finding), Some(cause)) if finding.mistakes.is_none() => {
                Verdict::WrongShape {
                    cause,
                    finding: Some(finding),
                }
            }
            (Answer::Of(finding), _) => Verdict::Wrong(*finding),
        },
    }
}

/// Judges a picture whose scene was guessed: as one of another scene, if it shows that. Returns
/// the scene, too.
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

/// A right picture, unless the reader's functions answer as with a mistake that it hides.
fn of_right(
    task: &Task,
    reading: &Reading,
    context: &Context,
    right: RightPicture,
    has_another_shape: bool,
) -> Verdict {
    if !context.is_answered_by(&right.task.program(&[]))
        && let Answer::Of(finding) = Finding::of(task, reading, context)
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

/// What an explanation says.
enum Answer {
    /// It is a picture of these scenes.
    Another(Vec<Task>),
    /// It is a picture of the scene, or of nothing that is known.
    Of(Box<Finding>),
}

impl Finding {
    /// Returns what explains the picture.
    fn of(task: &Task, reading: &Reading, context: &Context) -> Answer {
        let evidence = Evidence::new(task, reading, context);
        let finding = match explain(&evidence) {
            Explanation::Another(tasks) => return Answer::Another(tasks),
            // The width that a probe is about was forgotten.
            Explanation::AlmostRight(fit)
                if fit.unexplained.is_nothing() && evidence.task.probe != task.probe =>
            {
                return Answer::Another(vec![evidence.task]);
            }
            Explanation::AlmostRight(fit) => {
                let almost_right = AlmostRight {
                    task: fit.candidates[0].task,
                    unexplained: fit.unexplained,
                };
                Self {
                    almost_right: Some(almost_right),
                    editions: fit.editions(reading),
                    ..Self::beside(&evidence, &fit.candidates[0])
                }
            }
            Explanation::Mistakes(fit) => Self {
                editions: fit.editions(reading),
                mistakes: Some(Mistakes::of(&fit)),
                ..Self::beside(&evidence, &fit.candidates[0])
            },
            Explanation::Nothing(right) => Self::unknown(&evidence, &right),
        };
        Answer::Of(Box::new(finding.repaired(&evidence)))
    }

    /// Adds what makes the reader's program right, and keeps of the mistakes that draw its picture
    /// only the one that goes with it.
    fn repaired(mut self, evidence: &Evidence) -> Self {
        let (sources, context) = (&evidence.context.sources, evidence.context);
        let is_exact = |it: &Self| it.almost_right.as_ref().is_some_and(AlmostRight::is_exact);
        let step = evidence.repair().and_then(|it| it.step);
        if self.task.step() != step
            && (sources.is_written() || !is_exact(&self))
            && evidence.repair().is_some_and(Repair::is_of_lines)
        {
            // A line is wrong in what is written: in all of the chapter, or as far as a step.
            let rights = candidates::rights(evidence);
            let right = rights.iter().find(|it| it.task.step() == step);
            self = Self::beside(evidence, right.unwrap_or(&rights[0]));
        }
        if self.task.step() != step || is_exact(&self) && self.is_answered {
            return self;
        }
        // A slip's line in another language is said in that.
        let is_found = |slip: &&Slip| context.line_of(slip, &self.task).is_some();
        if sources.in_rust().is_empty() && self.single().iter().any(is_found) {
            return self;
        }
        let Some(repair) = evidence.repair().cloned() else {
            return self;
        };
        self.almost_right = None;
        if let Some(mistakes) = &mut self.mistakes {
            let task = mistakes.task;
            let is_mended = |slip: &&'static Slip| context.is_mended(slip, &task, &repair);
            mistakes.all.retain(|slips| slips.iter().all(is_mended));
        }
        self.mistakes = self.mistakes.filter(|it| it.all.len() == 1);
        self.repair = Some(repair);
        self
    }

    /// Returns a finding with what every explanation shares.
    fn beside(evidence: &Evidence, by: &Candidate) -> Self {
        let (reading, task) = (evidence.reading, by.task);
        let right = task.right(reading.width, reading.height);
        let yours = reading.picture();
        let difference = match Comparison::of(&right, &yours) {
            Comparison::Pixels(difference) => Some(difference),
            _ => None,
        };
        let program = by.task.unchanged().program(&by.slips);
        Self {
            task,
            editions: vec![task.edition],
            right,
            yours,
            difference,
            almost_right: None,
            mistakes: None,
            drawn: Drawn::default(),
            sights: Vec::new(),
            first: Vec::new(),
            repair: None,
            is_answered: evidence.context.is_answered_by(&program),
        }
    }

    /// Returns what can be seen, where no program that is known draws it.
    fn unknown(evidence: &Evidence, right: &Candidate) -> Self {
        let finding = Self::beside(evidence, right);
        let (sights, first) = seen::seen(&finding.task, evidence.reading, &finding.right);
        Self {
            sights,
            first,
            drawn: match evidence.repair() {
                Some(_) => Drawn::default(),
                None => evidence.drawn(&right.task).clone(),
            },
            ..finding
        }
    }

    /// Returns true if nothing explains a picture most of which is another.
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

    /// Returns true if the reader's picture shows the sky of the scene and no sphere.
    pub(crate) fn shows_only_sky(&self) -> bool {
        let (width, height) = (self.yours.width(), self.yours.height());
        self.task.chapter.sphere_count() != SphereCount::None
            && self.yours == self.task.of_sky(width, height)
    }

    /// The farthest that a component is off, in levels.
    pub fn levels(&self) -> u8 {
        self.difference.as_ref().map_or(0, |it| it.levels)
    }

    /// The slips that draw it together, if no others do.
    pub fn single(&self) -> &[&'static Slip] {
        match &self.mistakes {
            Some(Mistakes { all, .. }) if all.len() == 1 => &all[0],
            _ => &[],
        }
    }
}

impl Fit {
    /// The editions in which the same leaves the same.
    fn editions(&self, reading: &Reading) -> Vec<Edition> {
        let it = &self.candidates[0];
        let own = it.task.edition;
        if own == Edition::V4 {
            return vec![own];
        }
        let tasks = it.task.by_editions(reading.width, reading.height);
        let is_same = |task: &Task| {
            let candidate = Candidate {
                task: *task,
                ..it.clone()
            };
            candidate.unexplained(reading, self.unexplained.off) == Some(self.unexplained)
        };
        let same = tasks.filter(is_same).map(|task| task.edition);
        let others = same.filter(|edition| *edition != own);
        [own].into_iter().chain(others).collect()
    }
}

impl Mistakes {
    fn of(fit: &Fit) -> Self {
        let first = &fit.candidates[0];
        let all: Vec<Vec<&'static Slip>> =
            fit.candidates.iter().map(|it| it.slips.clone()).collect();
        Self {
            task: first.task,
            telling: telling::apart(&first.task, &all),
            all,
            conversion: first.conversion,
            is_in_text: fit.is_in_text,
            unexplained: fit.unexplained,
        }
    }
}

impl AlmostRight {
    /// Returns true if it is right to the last bit: a step on the way.
    pub(crate) fn is_exact(&self) -> bool {
        self.unexplained.is_nothing()
    }

    fn has_odd_pixels(&self) -> bool {
        !self.is_exact()
    }
}

impl RightPicture {
    /// Counts the pixels of the picture.
    pub(crate) fn total(&self) -> usize {
        self.width as usize * self.height as usize
    }

    /// The first edition that draws the picture to the last bit, or else the first that
    /// draws it within the tolerance.
    fn of(task: &Task, reading: &Reading, tolerance: u8) -> Option<Self> {
        let (width, height) = (reading.width, reading.height);
        let within = |tolerance| {
            let tasks = task.by_editions(width, height);
            let off = |task: Task| {
                let is_near = task.may_be_shown_by(reading, tolerance);
                let right = is_near.then(|| task.right(width, height))?;
                let (off, levels) = match Comparison::of(&right, &reading.picture()) {
                    Comparison::Pixels(difference) => (difference.count, difference.levels),
                    _ => (0, 0),
                };
                (levels <= tolerance).then_some((task, off, levels))
            };
            let near: Vec<_> = tasks.filter_map(off).collect();
            let &(task, off, levels) = near.first()?;
            Some(Self {
                task,
                editions: near.iter().map(|(task, ..)| task.edition).collect(),
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

impl Verdict {
    /// The exit code: 0 for right, 1 for wrong, 2 for not a picture. Right is what an
    /// edition of the book draws, to the last bit or within the tolerance, in a shape that
    /// no slip gives.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Right(right) if right.shape_given_by.is_empty() => 0,
            Self::NotAPicture { .. } => 2,
            _ => 1,
        }
    }

    /// Why it is not the picture that was asked for, where that is no matter of pixels.
    pub fn cause(&self) -> Option<&Cause> {
        match self {
            Self::Another { cause, .. }
            | Self::WrongShape { cause, .. }
            | Self::NotAPicture { cause, .. } => Some(cause),
            Self::Right(_) | Self::AlmostRight(_) | Self::Wrong(_) => None,
        }
    }

    /// Returns what is to be seen, if there are pixels to judge and they are not right.
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
