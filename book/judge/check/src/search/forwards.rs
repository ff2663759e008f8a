//! Inverse mutation testing: finds the mutants of a chapter that draw a given picture, to the last
//! pixel, and so the mistakes that a reader may have typed.

use std::collections::HashSet;
use std::rc::Rc;

use laws::answers::Answers;
use slips::{ChapterCode, ChapterProgram, Output};

use super::edit::RankedEdit;
use super::functions::RustFn;
use super::mutation;
use crate::lawful;
use crate::pixels::{distance, spread};
use crate::reading::Reading;
use crate::sources::{CorrectedLine, LineStatus, Sources, squeezed};

/// The number of wrong pixels, and of right ones, that are compared first.
const FIRST: u32 = 24;
/// The number of pixels of all that are compared then.
const LOOKED: u32 = 1500;
/// The most edits for which a picture tells something of the mistake: many edits draw only sky.
const MOST: usize = 5;
/// The number of edits that are shown.
const SHOWN: usize = 3;

/// The addition to the rank of an edit outside of the chapter's own files: what was typed before,
/// or for the reader, is less likely wrong.
const ELSEWHERE: u32 = 4;

/// The single edits of a chapter's text whose programs draw a reader's picture.
#[derive(Clone, Debug, Default)]
pub struct DrawingMutants {
    /// At most three of these edits, the likeliest first; empty if none was found.
    pub likeliest: Vec<Mutant>,
    /// The number of all edits that were found, where edits with equal effects count once.
    pub count: usize,
}

/// A single edit of a chapter's text, as the edited line before and after.
#[derive(Clone, Debug)]
pub struct Mutant {
    /// The chapter's line in Rust. Where the edit touches several lines, they are joined.
    pub right: String,
    /// The line with the edit made; empty if the edit deletes the line.
    pub wrong: String,
    /// The line of the reader that has the edit, with its correction; `None` if it is not found.
    pub(crate) yours: Option<CorrectedLine>,
    /// The effects of the program with the edit.
    does: Option<Behavior>,
}

/// The effects of a program by which it is told from others.
#[derive(Clone, Debug)]
struct Behavior {
    /// The program.
    program: ChapterProgram,
    /// The answers of its functions to the questions of the laws.
    answers: Answers,
    /// The pixels of its pictures at the widths in [`SMALL`].
    small: Vec<[i32; 3]>,
}

/// The widths in pixels of the pictures by which edits are told apart.
const SMALL: [u32; 2] = [24, 33];

/// The search for the edits of a right program that draw a reader's picture.
pub(super) struct PictureSearch<'a> {
    /// The right program.
    pub(super) right: &'a ChapterProgram,
    /// The picture to draw.
    pub(super) reading: &'a Reading,
    /// The functions of the right program.
    pub(super) functions: &'a [RustFn],
    /// The files of the reader.
    pub(super) sources: &'a Sources,
    /// The pixels that are compared first, from [`places`].
    pub(super) places: Vec<u32>,
}

impl<'a> PictureSearch<'a> {
    /// Finds the single edits that draw the picture and that the reader's lines do not rule out.
    ///
    /// Where no lines are known, the search ends once so many are found that they tell nothing.
    pub(super) fn mutants(&self) -> DrawingMutants {
        let mut drawn = DrawingMutants::default();
        let mut seen = HashSet::new();
        for (program, number, function, edit) in self.mutated() {
            let mutant = program.code().with_mutant(number);
            if !self.may_draw(&ChapterProgram::from_reader(self.right.chapter, mutant)) {
                continue;
            }
            let text = edit.applied_to(&function.text);
            if !seen.insert((&function.name, text.clone())) {
                continue;
            }
            let Some(program) = self.right.with_function(&function.name, &text) else {
                continue;
            };
            let yours = match self.sources.status(self.right, &program) {
                LineStatus::Right => continue,
                LineStatus::Wrong(line) => Some(line),
                LineStatus::NotFound => None,
            };
            drawn.add(Mutant {
                yours,
                does: Some(Behavior::of(program)),
                ..Mutant::new(function, &edit)
            });
            if self.sources.is_empty() && drawn.likeliest.len() > MOST {
                break;
            }
        }
        drawn.checked(|it| self.draws(it))
    }

    /// Lists all mutations, the likeliest first: a program that has all mutations of one function,
    /// the number of the mutation in it, the function, and the edit.
    fn mutated(&self) -> Vec<(Rc<ChapterProgram>, u32, &'a RustFn, RankedEdit)> {
        let mut all = Vec::new();
        for function in self.functions {
            let mutations = mutation::mutations(function);
            let text = mutation::schemata(function, &mutations, 1);
            let Some(program) = self.right.with_function(&function.name, &text) else {
                continue;
            };
            let program = Rc::new(program);
            for (number, it) in (1..).zip(&mutations) {
                let edit = it.edit(&function.text);
                all.push((Rc::clone(&program), number, function, edit));
            }
        }
        // What stands in the chapter itself was typed last.
        let files = self.right.chapter.files();
        let is_own = |it: &RustFn| files.iter().any(|file| file.text.contains(&it.text));
        all.sort_by_cached_key(|(_, _, function, edit)| {
            let elsewhere = if is_own(function) { 0 } else { ELSEWHERE };
            edit.rank + edit.brackets(&function.text) + elsewhere
        });
        all
    }

    /// Returns true if a program draws the chosen pixels.
    fn may_draw(&self, program: &ChapterProgram) -> bool {
        draws(program, self.reading, self.places.iter().copied())
    }

    /// Returns true if a program draws the whole picture.
    fn draws(&self, program: &ChapterProgram) -> bool {
        draws(program, self.reading, 0..self.reading.pixels.len() as u32)
    }
}

impl DrawingMutants {
    /// Returns true if there are edits, and so few that the picture tells something of the mistake.
    pub(crate) fn is_informative(&self) -> bool {
        (1..=MOST).contains(&self.count)
    }

    /// Adds a mutant, unless one has the same effects; one that is found in the reader's files
    /// replaces it.
    fn add(&mut self, mutant: Mutant) {
        let mut known = self.likeliest.iter_mut();
        match known.find(|it| it.behaves_like(&mutant)) {
            Some(known) if mutant.yours.is_some() && known.yours.is_none() => *known = mutant,
            Some(_) => {}
            None => self.likeliest.push(mutant),
        }
    }

    /// Keeps the mutants that are found in the reader's files, if some are, and counts them; if
    /// they are few, drops those that do not draw every pixel. Keeps at most [`SHOWN`] of the rest.
    fn checked(mut self, draws: impl Fn(&ChapterProgram) -> bool) -> Self {
        if self.likeliest.iter().any(|it| it.yours.is_some()) {
            self.likeliest.retain(|it| it.yours.is_some());
        }
        self.count = self.likeliest.len();
        if self.is_informative() {
            let is_it = |it: &Mutant| it.does.as_ref().is_some_and(|it| draws(&it.program));
            self.likeliest.retain(is_it);
            self.count = self.likeliest.len();
        }
        self.likeliest.truncate(SHOWN);
        self
    }
}

impl Mutant {
    /// Makes the mutant of an edit of a function, with nothing known of its effects.
    fn new(function: &RustFn, edit: &RankedEdit) -> Self {
        let wrong = edit.applied_to(&function.text);
        let after = function.text.len() - edit.at.end;
        Self {
            right: lines(&function.text, edit.at.start, after),
            wrong: lines(&wrong, edit.at.start, after),
            yours: None,
            does: None,
        }
    }

    /// Returns true if two mutants draw the same small pictures and give the same answers.
    fn behaves_like(&self, other: &Self) -> bool {
        let both = self.does.as_ref().zip(other.does.as_ref());
        both.is_some_and(|(one, other)| {
            let program = &other.program;
            let mismatch = || lawful::mismatch_with(&one.answers, program.chapter, program, 1);
            one.small == other.small && mismatch().differing == 0
        })
    }
}

impl Behavior {
    /// Runs a program to see its effects.
    fn of(program: ChapterProgram) -> Self {
        Self {
            answers: answers(&program),
            small: SMALL
                .iter()
                .flat_map(|&width| program.run(width).pixels().collect::<Vec<_>>())
                .collect(),
            program,
        }
    }
}

/// Returns the whole lines around a part of a text, on one line; `before` and `after` are the bytes
/// before and behind the part.
pub(super) fn lines(text: &str, before: usize, after: usize) -> String {
    let end = text.len() - after;
    let start = text[..before].rfind('\n').map_or(0, |at| at + 1);
    let end = text[end..].find('\n').map_or(text.len(), |at| end + at);
    squeezed(&text[start..end])
}

/// Chooses the pixels to compare: in turn one that the right program draws otherwise and one that
/// it draws, then some of all.
pub(super) fn places(right: &ChapterProgram, reading: &Reading) -> Vec<u32> {
    let total = reading.pixels.len() as u32;
    let output = right.run(reading.width);
    let is_whole = output.size() == (reading.width, reading.height);
    let is_fine = |n: u32| is_whole && is_drawn(&output, reading, n);
    let (fine, wrong): (Vec<u32>, Vec<u32>) = spread(LOOKED, total).partition(|n| is_fine(*n));
    let [first, next] = [wrong, fine].map(|it| some_of(&it, FIRST));
    let pairs = (0..FIRST as usize).flat_map(|n| [first.get(n), next.get(n)]);
    let pairs = pairs.flatten().copied();
    pairs.chain(spread(LOOKED, total)).collect()
}

/// Returns true if a program draws a picture of the same size with these pixels, by their indices.
fn draws(
    program: &ChapterProgram,
    reading: &Reading,
    mut places: impl Iterator<Item = u32>,
) -> bool {
    let output = program.run(reading.width);
    output.size() == (reading.width, reading.height)
        && places.all(|n| is_drawn(&output, reading, n))
}

/// Returns true if a program prints the `n`th pixel of the picture, or would after its levels are
/// clamped to 0 to 255.
fn is_drawn(output: &Output, reading: &Reading, n: u32) -> bool {
    output.printed(n).is_some_and(|levels| {
        let levels = levels.map(|it| it.clamp(i16::MIN.into(), i16::MAX.into()) as i16);
        let found = reading.pixels[n as usize];
        distance(levels, found) == 0 || levels.map(|it| it.clamp(0, 255)) == found
    })
}

/// Chooses `count` of these pixels, evenly spread.
pub(super) fn some_of(pixels: &[u32], count: u32) -> Vec<u32> {
    let places = spread(count, pixels.len() as u32);
    places.map(|n| pixels[n as usize]).collect()
}

/// One in so many questions of [`lawful::questions`] is asked.
const ASKED: usize = 3;

/// Asks a program questions about all of its functions, and returns them with its answers.
pub(super) fn answers(program: &ChapterProgram) -> Answers {
    let questions = lawful::questions(program.chapter).into_iter();
    lawful::answers_of(program, questions.step_by(ASKED))
}
