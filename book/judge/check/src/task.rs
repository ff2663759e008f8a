//! The scene that a picture is meant to show.

use std::collections::BTreeMap;
use std::sync::{LazyLock, Mutex, PoisonError};

use common::rtweekend::Picture;

use crate::names::companion_command;
use crate::pixels::{distance, spread};
use crate::reading::Reading;
use slips::{Chapter, ChapterProgram, Edition, Probe, ReaderLanguage, Slip, steps, width_line};

/// A chapter's scene, or a probe's in that chapter, by one edition of the book.
#[derive(Clone, Copy, Debug)]
pub struct Task {
    /// The chapter.
    pub chapter: Chapter,
    /// The probe, or `None` for the book's own scene.
    pub probe: Option<Probe>,
    /// The edition whose program draws it.
    pub edition: Edition,
    /// True if no other edition will do.
    insists: bool,
    /// A step on the way to the chapter, counted from 0, if it is not the last.
    step: Option<usize>,
    /// Width and height in pixels, if they are not the chapter's own.
    shape: Option<(u32, u32)>,
}

impl Task {
    /// The scene, or `None` if the chapter has no place for the probe's spheres.
    pub fn new(chapter: Chapter, probe: Option<Probe>) -> Option<Self> {
        let has_room = probe.is_none_or(|probe| probe.fits(chapter));
        has_room.then_some(Self {
            chapter,
            probe,
            edition: Edition::V4,
            insists: false,
            step: None,
            shape: None,
        })
    }

    /// Returns this scene by that edition and no other.
    pub fn only_by(self, edition: Edition) -> Self {
        Self {
            edition,
            insists: true,
            ..self
        }
    }

    /// Returns this scene with that probe, or `None` if the chapter has no place for its spheres.
    pub fn with_probe(self, probe: Probe) -> Option<Self> {
        probe.fits(self.chapter).then_some(Self {
            probe: Some(probe),
            shape: None,
            ..self
        })
    }

    /// The chapter's own scene by the same edition.
    pub(crate) fn without_probe(self) -> Self {
        self.of_chapter(self.chapter)
    }

    /// Returns this step of this scene, before a probe's change.
    pub(crate) fn unchanged(self) -> Self {
        Self {
            probe: None,
            ..self
        }
    }

    /// Returns this scene drawn with the whole of b in place of its half, or the other way
    /// round, if it is that of one sphere with its normals.
    pub(crate) fn with_the_other_formula(self) -> Option<Self> {
        let chapter = match (self.chapter, self.step) {
            (Chapter::Normals, None) => Chapter::HalfBSphere,
            (Chapter::HalfBSphere, None) => Chapter::Normals,
            _ => return None,
        };
        Some(Self { chapter, ..self })
    }

    /// The scene of another chapter by the same edition.
    pub(crate) fn of_chapter(self, chapter: Chapter) -> Self {
        Self {
            chapter,
            probe: None,
            step: None,
            shape: None,
            ..self
        }
    }

    /// Returns this scene as far as it is written after a step.
    pub(crate) fn at_step(self, step: usize) -> Self {
        Self {
            step: Some(step),
            ..self
        }
    }

    /// The step that it shows, counted from 0, if it is not the chapter's last.
    pub fn step(&self) -> Option<usize> {
        self.step
    }

    /// Returns true if the picture may be the right one of this scene to within so many levels:
    /// some pixels tell, before all are compared.
    pub(crate) fn may_be_shown_by(&self, reading: &Reading, tolerance: u8) -> bool {
        let output = self.program(&[]).run(reading.width);
        output.size() == (reading.width, reading.height)
            && spread(GLANCE, reading.pixels.len() as u32).all(|n| {
                let expected = output.pixel(n).map(|level| level as i16);
                distance(expected, reading.pixels[n as usize]) <= tolerance.into()
            })
    }

    /// Returns what a reader changes to draw it that wide, a line each.
    pub fn change(&self, width: u32, language: Option<ReaderLanguage>) -> String {
        match self.probe {
            Some(probe) => probe.lines(self.chapter, language),
            None => width_line(width, language),
        }
    }

    /// The command that checks a picture of it.
    pub fn command(&self) -> String {
        let (companion, chapter) = (companion_command(), self.chapter.name());
        match self.probe {
            Some(probe) => self.probed_command(probe),
            None => format!("{companion} check {chapter} PICTURE"),
        }
    }

    /// The command that checks a picture of it with that probe.
    pub fn probed_command(&self, probe: Probe) -> String {
        let (companion, chapter) = (companion_command(), self.chapter.name());
        format!("{companion} check {chapter} --probe {} PICTURE", probe.name)
    }

    /// Returns this scene by each edition that will do, in a picture of that size: the latest
    /// edition first. A reader who draws in the shape that came with version 3.1 reads no earlier
    /// one; but many keep the rays and the factor of the first.
    pub(crate) fn by_editions(self, width: u32, height: u32) -> impl Iterator<Item = Self> {
        Edition::ALL
            .into_iter()
            .filter(move |edition| !self.insists || edition.name() == self.edition.name())
            .map(move |edition| Self { edition, ..self }.fitting(width, height))
            .filter(move |it| it.edition.is_first() || !it.is_in_a_later_shape(width, height))
    }

    /// Returns true if the picture has the shape of version 4, which its edition has not; never
    /// where the reader insists on that edition.
    pub(crate) fn is_in_a_later_shape(&self, width: u32, height: u32) -> bool {
        let latest = Self {
            edition: Edition::V4,
            ..self.in_own_shape()
        };
        !self.insists && self.has_another_shape() && latest.height(width) == height
    }

    /// Returns this scene in a picture of that size, whose shape may be the scene's own.
    pub fn fitting(self, width: u32, height: u32) -> Self {
        let own = self.in_own_shape();
        if own.height(width) == height {
            own
        } else {
            Self {
                shape: Some((width, height)),
                ..self
            }
        }
    }

    /// Returns this scene in the chapter's own shape.
    pub(crate) fn in_own_shape(self) -> Self {
        Self {
            shape: None,
            ..self
        }
    }

    /// Returns true if the shape is not that of the chapter.
    pub(crate) fn has_another_shape(&self) -> bool {
        self.shape.is_some()
    }

    /// The program that draws the scene, with these slips in it.
    pub fn program(&self, slips: &[&Slip]) -> ChapterProgram {
        let right = || self.kept("", || self.right_program());
        let with = |slip: &Slip| self.kept(slip.name, || slip.applied_to(&right()));
        match slips {
            [] => right(),
            // Only some laws know what has no name.
            [slip] if slip.name.is_empty() => slip.applied_to(&right()),
            [slip] => with(slip),
            [first, others @ ..] => others.iter().fold(with(first), |program, slip| {
                let joined = program.joined(&with(slip), &right());
                joined.unwrap_or_else(|| slip.applied_to(&program))
            }),
        }
    }

    /// The program of the scene with that slip, made once.
    fn kept(&self, slip: &'static str, make: impl FnOnce() -> ChapterProgram) -> ChapterProgram {
        type Key = (
            Chapter,
            Edition,
            Option<usize>,
            Option<(u32, u32)>,
            &'static str,
            &'static str,
        );
        static KEPT: LazyLock<Mutex<BTreeMap<Key, ChapterProgram>>> = LazyLock::new(Mutex::default);
        let probe = self.probe.map_or("", |probe| probe.name);
        let key = (
            self.chapter,
            self.edition,
            self.step,
            self.shape,
            probe,
            slip,
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

    fn right_program(&self) -> ChapterProgram {
        let mut program = self.edition.shaped(self.chapter, self.shape);
        if let Some(step) = self.step {
            program = steps::of_chapter(self.chapter)[step].applied_to(&program);
        }
        match self.probe {
            Some(probe) => probe.applied_to(&program).unwrap_or(program),
            None => program,
        }
    }

    /// The slips that can be made here: those whose lines stand in the chapter.
    pub fn slips(&self) -> impl Iterator<Item = &'static Slip> + use<> {
        let chapter = self.chapter;
        slips::all().filter(move |slip| slip.is_possible_in(chapter))
    }

    /// The height of the right picture that is `width` pixels wide.
    pub fn height(&self, width: u32) -> u32 {
        self.program(&[]).run(width).size().1
    }

    /// The sky of the same edition alone, in the size of the reader's picture.
    pub(crate) fn of_sky(&self, width: u32, height: u32) -> Picture {
        self.of_chapter(Chapter::Gradient).right(width, height)
    }

    /// The right picture in the size of the reader's.
    pub fn right(&self, width: u32, height: u32) -> Picture {
        let fitting = self.fitting(width, height);
        if fitting.is_as_compiled() {
            return self.chapter.picture(width);
        }
        fitting.program(&[]).run(width).picture()
    }

    /// Returns true if it is the chapter's own picture, which this program has compiled.
    pub(crate) fn is_as_compiled(&self) -> bool {
        let is_changed = self.step.is_some() || self.shape.is_some();
        let has_spheres = self.probe.is_some_and(|probe| probe.spheres.is_some());
        self.edition == Edition::V4 && !is_changed && !has_spheres
    }
}

/// So many programs are kept at most.
const MOST: usize = 5000;
/// How many pixels tell a scene from most others.
const GLANCE: u32 = 64;
