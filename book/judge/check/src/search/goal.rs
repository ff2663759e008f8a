//! Differential testing: whether a program draws the right pixels and answers as the chapter's
//! functions do.
//!
//! Pixels alone take some nonsense for right. The questions of the laws, which no pixel asks,
//! settle it, and find what the picture hides.

use common::rtweekend::*;
use interpreter::{ExpectedPixel, Program, SourceFile};
use laws::answers::Answers;
use slips::{Chapter, lawful};

use crate::pixels::spread;
use crate::reading::Reading;
use crate::task::Task;

/// So many wrong and right pixels are looked at, the wrong ones first.
pub(super) const LOOKED: u32 = 100;
/// A picture is drawn whole up to this size; of a larger one so many pixels are.
pub(super) const DRAWN: u32 = 100_000;
/// So wide is a picture that a reader's own loop draws for each text that is tried.
const SMALL: u32 = 24;
/// One in so many of the questions that tell mistakes apart is asked.
const ASKED: usize = 3;

/// What a right program does.
pub(super) struct Goal {
    width: u32,
    sample: Vec<ExpectedPixel>,
    all: Vec<ExpectedPixel>,
    chapter: Chapter,
    /// What the chapter answers; nothing where it is not asked.
    answers: Answers,
    /// What a reader's own loop over all pixels is to draw, at [`SMALL`].
    small: Option<Picture>,
}

/// Reads a program, if the interpreter takes it.
pub(super) fn program(files: &[SourceFile]) -> Option<Program> {
    interpreter::read(files).ok()
}

/// Returns true if the program draws this picture, by the look of so many pixels.
pub(super) fn draws(program: &Program, reading: &Reading, count: u32) -> bool {
    let pixel = |index: u32| ExpectedPixel {
        index,
        levels: reading.pixels[index as usize].map(|it| it.clamp(0, 255) as u8),
    };
    let sample = spread(count, reading.pixels.len() as u32);
    let sample: Vec<ExpectedPixel> = sample.map(pixel).collect();
    program.count_matching(reading.width, &sample).ok() == Some(sample.len())
}

impl Goal {
    /// Takes the right picture, and so many of its pixels.
    pub(super) fn new(chapter: Chapter, right: &Picture, reading: &Reading) -> Self {
        let (width, total) = (right.width(), right.width() * right.height());
        let rgb = right.rgb();
        let pixel = |index: u32| ExpectedPixel {
            index,
            levels: [0, 1, 2].map(|it| rgb[3 * index as usize + it]),
        };
        let has_same_shape = (reading.width, reading.height) == (width, right.height());
        let is_wrong = |n: &u32| {
            let right = pixel(*n).levels.map(i16::from);
            !has_same_shape || reading.pixels[*n as usize] != right
        };
        let (wrong, fine): (Vec<u32>, Vec<u32>) = (0..total).partition(is_wrong);
        let some = |all: &[u32]| -> Vec<u32> {
            spread(LOOKED, all.len() as u32)
                .map(|n| all[n as usize])
                .collect()
        };
        let sample = [some(&wrong), some(&fine)].concat().into_iter();
        Self {
            width,
            sample: sample.map(pixel).collect(),
            all: spread(DRAWN, total).map(pixel).collect(),
            chapter,
            answers: Answers::default(),
            small: None,
        }
    }

    /// Adds what a reader's own loop over all pixels is to draw.
    pub(super) fn looping(self, task: &Task) -> Self {
        let small = task.right_picture(SMALL, task.height(SMALL));
        Self {
            small: Some(small),
            ..self
        }
    }

    /// Adds questions to which a right program has the answers.
    pub(super) fn asking(self, right: &Program) -> Self {
        let right = slips::ChapterProgram::typed(self.chapter, right.clone());
        let answers = answers(&right);
        Self { answers, ..self }
    }

    /// Returns true if the program answers all questions as the chapter does.
    pub(super) fn is_answered_by(&self, program: &Program) -> bool {
        let program = slips::ChapterProgram::typed(self.chapter, program.clone());
        self.answers.mismatch_with(&program, 1).differing == 0
    }

    /// Returns true if the program is right, by its answers and by what it draws.
    pub(super) fn is_met_by(&self, program: &Program) -> bool {
        let has = |sample: &[ExpectedPixel]| {
            program.count_matching(self.width, sample).ok() == Some(sample.len())
        };
        let loops = |small: &Picture| program.draw(SMALL).is_ok_and(|it| it == *small);
        has(&self.sample)
            && self.small.as_ref().is_none_or(loops)
            && self.is_answered_by(program)
            && has(&self.all)
    }
}

/// Returns what a program answers to questions about all of its functions.
pub(super) fn answers(program: &slips::ChapterProgram) -> Answers {
    let questions = lawful::questions(program.chapter).into_iter();
    Answers::of(program, questions.step_by(ASKED).collect())
}
