//! Differential testing: compares a program with a right one by the pixels that it draws and by the
//! answers of its functions.
//!
//! By pixels alone some wrong programs are right. The questions of the laws, which no pixel asks,
//! find what the picture hides.

use common::rtweekend::*;
use interpreter::{Fault, Program};
use laws::answers::Answers;
use slips::Chapter;

use crate::lawful;
use crate::pixels::spread;
use crate::reading::Reading;

/// The number of wrong pixels, and of right ones, that are compared first.
pub(super) const LOOKED: u32 = 100;
/// The most pixels of a picture that a repaired program has to draw; of a larger picture they are a
/// sample.
pub(super) const DRAWN: u32 = 100_000;
/// One in so many questions of [`lawful::questions`] is asked.
const ASKED: usize = 3;

/// A pixel and the color that it should have.
#[derive(Clone, Copy)]
struct ExpectedPixel {
    /// The number of the pixel: `j * width + i` in column `i` and row `j`, from 0 at the top left.
    index: u32,
    /// The levels of red, green and blue, 0 to 255.
    levels: [u8; 3],
}

/// The test that a right program passes: pixels, and answers.
pub(super) struct Goal {
    /// The width of the picture in pixels.
    width: u32,
    /// Pixels that are compared first.
    sample: Vec<ExpectedPixel>,
    /// Pixels that are compared last: all, or a sample of [`DRAWN`].
    all: Vec<ExpectedPixel>,
    /// The chapter of the program.
    chapter: Chapter,
    /// The answers of the right program; empty if no questions are asked.
    answers: Answers,
}

/// Returns true if a program draws a picture, judged by `count` of its pixels.
pub(super) fn draws(program: &Program, reading: &Reading, count: u32) -> bool {
    let pixel = |index: u32| ExpectedPixel {
        index,
        levels: reading.pixels[index as usize].map(|it| it.clamp(0, 255) as u8),
    };
    let sample = spread(count, reading.pixels.len() as u32);
    has_pixels(
        program,
        reading.width,
        &sample.map(pixel).collect::<Vec<_>>(),
    )
}

/// Returns true if a program draws these pixels of a picture `width` pixels wide.
fn has_pixels(program: &Program, width: u32, pixels: &[ExpectedPixel]) -> bool {
    let has_all = || -> Result<bool, Fault> {
        let canvas = program.canvas(width)?;
        let (width, height) = canvas.size();
        for &ExpectedPixel { index, levels } in pixels {
            let is_outside = index >= width * height;
            if is_outside || canvas.levels(index % width, index / width)? != levels {
                return Ok(false);
            }
        }
        Ok(true)
    };
    has_all().unwrap_or(false)
}

/// Chooses `count` of these pixels, evenly spread.
pub(super) fn some_of(pixels: &[u32], count: u32) -> Vec<u32> {
    let places = spread(count, pixels.len() as u32);
    places.map(|n| pixels[n as usize]).collect()
}

impl Goal {
    /// Makes the goal to draw a right picture, whose pixels that differ from those of a reader's
    /// picture are compared first. No questions are asked yet.
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
        let sample = [wrong, fine].map(|it| some_of(&it, LOOKED)).concat();
        Self {
            width,
            sample: sample.into_iter().map(pixel).collect(),
            all: spread(DRAWN, total).map(pixel).collect(),
            chapter,
            answers: Answers::default(),
        }
    }

    /// Adds that questions have to be answered as by this right program.
    pub(super) fn asking(self, right: &Program) -> Self {
        let right = slips::ChapterProgram::from_reader(self.chapter, right.clone());
        let answers = answers(&right);
        Self { answers, ..self }
    }

    /// Returns true if a program answers all questions as the right program does, or none are
    /// asked.
    pub(super) fn is_answered_by(&self, program: &Program) -> bool {
        let program = slips::ChapterProgram::from_reader(self.chapter, program.clone());
        lawful::mismatch_with(&self.answers, self.chapter, &program, 1).differing == 0
    }

    /// Returns true if a program reaches the goal: it draws the pixels and gives the answers.
    pub(super) fn is_met_by(&self, program: &Program) -> bool {
        let has = |pixels: &[ExpectedPixel]| has_pixels(program, self.width, pixels);
        has(&self.sample) && self.is_answered_by(program) && has(&self.all)
    }
}

/// Asks a program questions about all of its functions, and returns them with its answers.
pub(super) fn answers(program: &slips::ChapterProgram) -> Answers {
    let questions = lawful::questions(program.chapter).into_iter();
    lawful::answers_of(program, questions.step_by(ASKED))
}
