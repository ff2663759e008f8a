//! The task of a reader: which picture to draw.

use std::collections::BTreeMap;
use std::sync::{LazyLock, Mutex, PoisonError};

use common::rtweekend::Picture;

use crate::names::companion_command;
use crate::pixels::{distance, spread};
use crate::reading::Reading;
use slips::{Chapter, ChapterCode, ChapterProgram, Languages, Probe, Slip, steps, width_line};

/// The picture that a reader was asked to draw: a chapter's, whole or as far as a step of it, with
/// a [`Probe`] (a changed scene) or without, in the chapter's own shape or in another.
#[derive(Clone, Copy, Debug)]
pub struct Task {
    /// The chapter whose program draws the picture.
    pub chapter: Chapter,
    /// The probe, a small change of the chapter's width or spheres; `None` for the book's own
    /// picture.
    pub probe: Option<Probe>,
    /// True if version 3 of the book draws the picture, and not version 4.
    is_by_version_3: bool,
    /// The step on the way to the chapter after which the program is drawn, counted from 0; `None`
    /// for the whole chapter.
    step: Option<usize>,
    /// Width and height in pixels; `None` for the chapter's own shape.
    shape: Option<(u32, u32)>,
}

impl Task {
    /// Makes the task to draw the whole chapter as version 4 of the book has it, without a probe and
    /// in its own shape.
    pub fn of(chapter: Chapter) -> Self {
        Self {
            chapter,
            probe: None,
            is_by_version_3: false,
            step: None,
            shape: None,
        }
    }

    /// Makes the task to draw the whole chapter as [`of`](Self::of), with the changes of `probe` if
    /// one is given. Returns `None` if the chapter draws fewer spheres than the probe has.
    pub fn new(chapter: Chapter, probe: Option<Probe>) -> Option<Self> {
        let task = Self::of(chapter);
        probe.map_or(Some(task), |probe| task.with_probe(probe))
    }

    /// Returns this task by version 3 of the book; `None` in a shape that is not the chapter's own.
    pub fn by_version_3(mut self) -> Option<Self> {
        self.is_by_version_3 = true;
        self.shape.is_none().then_some(self)
    }

    /// Returns true if version 3 of the book draws the picture.
    pub fn is_by_version_3(&self) -> bool {
        self.is_by_version_3
    }

    /// Returns this task with the given probe in place of an earlier one, and in the chapter's own
    /// shape; step and version are kept. `None` if the chapter draws fewer spheres than the probe
    /// has.
    pub fn with_probe(mut self, probe: Probe) -> Option<Self> {
        (self.probe, self.shape) = (Some(probe), None);
        probe.fits(self.chapter).then_some(self)
    }

    /// Returns the task to draw the whole chapter by the same version, without a probe.
    pub(crate) fn whole_chapter(self) -> Self {
        self.of_chapter(self.chapter)
    }

    /// Returns this task without the probe, with the same step and shape.
    pub(crate) fn without_probe(mut self) -> Self {
        self.probe = None;
        self
    }

    /// Returns this task for chapter 4 in place of 3, or for 3 in place of 4, which draw the same
    /// picture by the whole of b or its half; `None` for other chapters and for steps.
    pub(crate) fn with_the_other_formula(self) -> Option<Self> {
        let chapter = match (self.chapter, self.step) {
            (Chapter::Normals, None) => Chapter::HalfBSphere,
            (Chapter::HalfBSphere, None) => Chapter::Normals,
            _ => return None,
        };
        Some(Self { chapter, ..self })
    }

    /// Returns the task to draw another whole chapter by the same version, without a probe.
    pub(crate) fn of_chapter(mut self, chapter: Chapter) -> Self {
        (self.chapter, self.probe, self.step, self.shape) = (chapter, None, None, None);
        self
    }

    /// Returns this task as far as the program is written after a step, counted from 0.
    pub(crate) fn at_step(mut self, step: usize) -> Self {
        self.step = Some(step);
        self
    }

    /// Returns the step after which the program is drawn, counted from 0; `None` for the whole
    /// chapter.
    pub fn step(&self) -> Option<usize> {
        self.step
    }

    /// Returns true if the picture has the right size, and [`GLANCE`] of its pixels are at most
    /// `tolerance` levels off.
    pub(crate) fn may_be_shown_by(&self, reading: &Reading, tolerance: u8) -> bool {
        let output = self.program(&[]).run(reading.width);
        output.size() == (reading.width, reading.height)
            && spread(GLANCE, reading.pixels.len() as u32).all(|n| {
                let expected = output.pixel(n).map(|level| level as i16);
                distance(expected, reading.pixels[n as usize]) <= tolerance.into()
            })
    }

    /// Returns instructions for a reader to change the chapter's program so that it draws the task
    /// `width` pixels wide, in plain text, one per line; a probe has its own width instead.
    pub fn change_lines(&self, width: u32, languages: Languages) -> String {
        match self.probe {
            Some(probe) => probe.instructions(self.chapter, languages),
            None => width_line(width, languages),
        }
    }

    /// Returns the command that checks a picture of this task's chapter, with its probe if there is
    /// one; it ends with `PICTURE`, which stands for the file. Step and version are not in it.
    pub fn command(&self) -> String {
        let (companion, chapter) = (companion_command(), self.chapter.name());
        match self.probe {
            Some(probe) => self.command_with_probe(probe),
            None => format!("{companion} check {chapter} PICTURE"),
        }
    }

    /// Returns the command that checks a picture of this task's chapter with the given probe in
    /// place of the task's own; it ends with `PICTURE`, which stands for the file.
    pub fn command_with_probe(&self, probe: Probe) -> String {
        let (companion, chapter) = (companion_command(), self.chapter.name());
        format!("{companion} check {chapter} --probe {} PICTURE", probe.name)
    }

    /// Returns this task for a picture of `width` × `height` pixels, in place of an earlier shape:
    /// in the chapter's own shape if that has this height, or else in just this shape. All else is
    /// kept.
    pub fn fitting(mut self, width: u32, height: u32) -> Self {
        let has_own_height = self.in_own_shape().height(width) == height;
        self.shape = (!has_own_height).then_some((width, height));
        self
    }

    /// Returns this task in the chapter's own shape.
    pub(crate) fn in_own_shape(mut self) -> Self {
        self.shape = None;
        self
    }

    /// Returns true if the shape is not the chapter's own.
    pub(crate) fn has_another_shape(&self) -> bool {
        self.shape.is_some()
    }

    /// Returns the program that draws the task, with these slips (known mistakes) made in it; the
    /// right program for none. The shape comes first, then step, probe, version and slips; a slip
    /// that can't be made changes nothing.
    pub fn program(&self, slips: &[&Slip]) -> ChapterProgram {
        let right = || self.kept("", || self.right_program());
        let with = |slip: &Slip| self.kept(slip.name, || slip.applied_to(&right()));
        match slips {
            [] => right(),
            // Only some laws know what has no name.
            [slip] if slip.name.is_empty() => slip.applied_to(&right()),
            [slip] => with(slip),
            [first, others @ ..] => others.iter().fold(with(first), |program, slip| {
                let joined = program.merged_with(&with(slip), &right());
                joined.unwrap_or_else(|| slip.applied_to(&program))
            }),
        }
    }

    /// Returns the program of this task with the slip of that name, or the right one for an empty
    /// name: one that was made before, or that `make` makes now.
    fn kept(&self, slip: &'static str, make: impl FnOnce() -> ChapterProgram) -> ChapterProgram {
        type Key = (
            Chapter,
            bool,
            Option<usize>,
            Option<(u32, u32)>,
            [&'static str; 2],
        );
        static KEPT: LazyLock<Mutex<BTreeMap<Key, ChapterProgram>>> = LazyLock::new(Mutex::default);
        let probe = self.probe.map_or("", |probe| probe.name);
        let key = (
            self.chapter,
            self.is_by_version_3,
            self.step,
            self.shape,
            [probe, slip],
        );
        let kept = || KEPT.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(program) = kept().get(&key) {
            return program.clone();
        }
        let program = make();
        let mut kept = kept();
        if kept.len() > MOST {
            kept.clear();
        }
        kept.insert(key, program.clone());
        program
    }

    /// Makes the program that draws the task without a mistake.
    fn right_program(&self) -> ChapterProgram {
        let mut program = ChapterProgram::right_of_shape(self.chapter, self.shape);
        if let Some(step) = self.step {
            program = steps::of_chapter(self.chapter)[step].applied_to(&program);
        }
        if let Some(probed) = self.probe.and_then(|it| it.applied_to(&program)) {
            program = probed;
        }
        match self.is_by_version_3 {
            true => slips::version_3().applied_to(&program),
            false => program,
        }
    }

    /// Iterates over the slips (known mistakes) with a name that are possible in the chapter, in
    /// the order of [`slips::all`].
    pub fn slips(&self) -> impl Iterator<Item = &'static Slip> + use<> {
        let chapter = self.chapter;
        slips::all().filter(move |slip| slip.is_possible_in(chapter))
    }

    /// Returns the height in pixels of the right picture that is `width` pixels wide.
    pub fn height(&self, width: u32) -> u32 {
        self.program(&[]).run(width).size().1
    }

    /// Draws the sky of the same version without spheres, `width` × `height` pixels.
    pub(crate) fn sky_picture(&self, width: u32, height: u32) -> Picture {
        self.of_chapter(Chapter::Gradient)
            .right_picture(width, height)
    }

    /// Draws the right picture `width` pixels wide: in the chapter's own shape if that has this
    /// `height`, or else in the shape of `width` × `height` pixels, with a viewport of this shape.
    pub fn right_picture(&self, width: u32, height: u32) -> Picture {
        let fitting = self.fitting(width, height);
        if fitting.is_as_compiled() {
            return self.chapter.picture(width);
        }
        fitting.program(&[]).run(width).picture()
    }

    /// Returns true if the task is drawn by the chapter's compiled functions: the whole chapter of
    /// version 4, in its own shape and without other spheres.
    pub(crate) fn is_as_compiled(&self) -> bool {
        let is_changed = self.step.is_some() || self.shape.is_some();
        let has_spheres = self.probe.is_some_and(|probe| probe.spheres.is_some());
        !self.is_by_version_3 && !is_changed && !has_spheres
    }
}

/// How many programs are kept at most.
const MOST: usize = 5000;
/// How many pixels are compared to tell a task from most others.
const GLANCE: u32 = 64;
