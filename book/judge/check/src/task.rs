//! The task of a reader: which picture to draw.

use common::rtweekend::Picture;
use slips::{Chapter, ChapterCode, ChapterProgram, Languages, Probe, Slip, width_line};

use crate::names::companion_command;
use crate::programs;

/// The picture that a reader was asked to draw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Task {
    /// The chapter whose program draws the picture.
    pub chapter: Chapter,
    /// The probe, a small change of the chapter's width or spheres; `None` for the book's own
    /// picture.
    pub probe: Option<Probe>,
    /// Width and height in pixels; `None` for the chapter's own shape.
    pub size: Option<(u32, u32)>,
    /// The step on the way to the chapter after which the program is drawn, counted from 0; `None`
    /// for the whole chapter.
    pub step: Option<usize>,
    /// The version of the book.
    pub version: Version,
}

/// A version of the book whose pictures count as right.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Version {
    /// Version 4, which the chapters follow.
    #[default]
    Four,
    /// Version 3, whose pixels lie half a pixel aside.
    Three,
}

impl Task {
    /// Makes the task to draw the whole chapter as version 4 of the book has it, without a probe and
    /// in its own shape.
    pub fn of(chapter: Chapter) -> Self {
        Self {
            chapter,
            probe: None,
            size: None,
            step: None,
            version: Version::Four,
        }
    }

    /// Makes the task to draw the whole chapter as [`of`](Self::of), with the changes of `probe` if
    /// one is given. Returns `None` if the chapter draws fewer spheres than the probe has.
    pub fn new(chapter: Chapter, probe: Option<Probe>) -> Option<Self> {
        let fits = probe.is_none_or(|probe| probe.fits(chapter));
        fits.then_some(Self {
            probe,
            ..Self::of(chapter)
        })
    }

    /// Returns the task for a picture of `width` × `height` pixels: in the chapter's own shape if
    /// that has this height, or else in just this shape.
    pub fn fitting(self, width: u32, height: u32) -> Self {
        let own = Self { size: None, ..self };
        match own.height(width) == height {
            true => own,
            false => Self {
                size: Some((width, height)),
                ..self
            },
        }
    }

    /// Returns the program that draws the task, with these slips (known mistakes) made in it; the
    /// right program for none.
    pub fn program(&self, slips: &[&Slip]) -> ChapterProgram {
        programs::program(self, slips)
    }

    /// Returns the height in pixels of the right picture that is `width` pixels wide.
    pub fn height(&self, width: u32) -> u32 {
        self.program(&[]).run(width).size().1
    }

    /// Draws the right picture `width` pixels wide: in the chapter's own shape if that has this
    /// `height`, or else in the shape of `width` × `height` pixels, with a viewport of this shape.
    pub fn right_picture(&self, width: u32, height: u32) -> Picture {
        let fitting = self.fitting(width, height);
        match (fitting.is_compiled(), fitting.size) {
            (true, None) => self.chapter.picture(width),
            (true, Some((width, height))) => self.chapter.picture_of_size(width, height),
            (false, _) => fitting.program(&[]).run(width).picture(),
        }
    }

    /// Draws the sky of the same version without spheres, `width` × `height` pixels.
    pub(crate) fn sky_picture(&self, width: u32, height: u32) -> Picture {
        let sky = Self::of(Chapter::Gradient);
        let version = self.version;
        Self { version, ..sky }.right_picture(width, height)
    }

    /// Returns true if the task is drawn by compiled functions, at full speed: the whole chapter of
    /// version 4, without other spheres.
    pub(crate) fn is_compiled(&self) -> bool {
        let has_spheres = self.probe.is_some_and(|probe| probe.spheres.is_some());
        let plain = Self {
            probe: self.probe,
            size: self.size,
            ..Self::of(self.chapter)
        };
        *self == plain && !has_spheres
    }

    /// Iterates over the slips (known mistakes) with a name that are possible in the chapter, in
    /// the order of [`slips::all`].
    pub fn slips(&self) -> impl Iterator<Item = &'static Slip> + use<> {
        let chapter = self.chapter;
        slips::all().filter(move |slip| slip.is_possible_in(chapter))
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
        let probe = self
            .probe
            .map_or(String::new(), |it| format!(" --probe {}", it.name));
        format!("{companion} check {chapter}{probe} PICTURE")
    }
}
