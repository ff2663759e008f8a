//! Mutation testing, turned round: of the mutants of a chapter those that draw a picture, to the
//! last pixel. They tell what a reader may have typed.

use std::collections::HashSet;
use std::rc::Rc;

use laws::answers::Answers;
use slips::{ChapterProgram, Output};

use super::edit::RankedEdit;
use super::functions::ParsedFunction;
use super::goal::answers;
use super::mutation;
use super::tree::squeezed;
use crate::pixels::{distance, spread};
use crate::reading::Reading;
use crate::sources::{CorrectedLine, LineComparison, LineStatus, StatementDiff, Transplant};

/// So many wrong and right pixels are looked at first, and then so many of all.
const FIRST: u32 = 24;
const LOOKED: u32 = 1500;
/// A picture that more edits draw does not tell which was made. So many are shown.
const MOST: usize = 5;
const SHOWN: usize = 3;

/// What was typed before the chapter, or for it, is less likely wrong.
const ELSEWHERE: u32 = 4;

/// The edits that draw a picture.
#[derive(Clone, Debug, Default)]
pub struct DrawingMutants {
    /// The likeliest, in their order.
    pub all: Vec<Mutant>,
    /// How many were found, of those that change the same value in the same way only one.
    pub count: usize,
}

/// An edit of a line.
#[derive(Clone, Debug)]
pub struct Mutant {
    /// The chapter's line.
    pub right: String,
    /// This line with the edit; nothing if it is left out.
    pub wrong: String,
    /// The reader's line that has it, and what should be there.
    pub(crate) yours: Option<CorrectedLine>,
    does: Option<Behavior>,
}

/// What a program does, seen from outside.
#[derive(Clone, Debug)]
struct Behavior {
    program: ChapterProgram,
    answers: Answers,
    /// The pixels of small pictures.
    small: Vec<[i32; 3]>,
}

/// So wide are pictures of other sizes.
const SMALL: [u32; 2] = [24, 33];

/// A picture and the right program of its scene, beside what a reader typed.
pub(super) struct PictureSearch<'a> {
    right: &'a ChapterProgram,
    reading: &'a Reading,
    functions: &'a [ParsedFunction],
    lines: &'a LineComparison<'a>,
    /// The pixels that are looked at, those first that tell most.
    places: Vec<u32>,
}

impl<'a> PictureSearch<'a> {
    pub(super) fn new(
        right: &'a ChapterProgram,
        functions: &'a [ParsedFunction],
        reading: &'a Reading,
        lines: &'a LineComparison<'a>,
    ) -> Self {
        Self {
            right,
            reading,
            functions,
            lines,
            places: places(right, reading),
        }
    }

    /// Finds the reader's line with which the chapter draws the picture. Where several do, as with
    /// one that shows only sky, it is one that stands for what the chapter's stands for.
    pub(super) fn transplanted(&self) -> Option<CorrectedLine> {
        let all = self.lines.transplants().into_iter();
        let found: Vec<_> = all.filter(|it| self.is_drawn_with(it)).collect();
        let is_one = |all: &[Transplant]| all.iter().all(|it| it.yours.line == all[0].yours.line);
        let mut same = found.iter().filter(|it| it.has_same_role);
        let only = || found.first().filter(|_| is_one(&found));
        same.next().or_else(only).map(|it| it.yours.clone())
    }

    fn is_drawn_with(&self, it: &Transplant) -> bool {
        let program = self.right.with_function(&it.function, &it.text);
        program.is_some_and(|it| self.may_draw(&it) && self.draws(&it))
    }

    /// Finds the single edits that draw the picture, as far as the reader's lines can have them.
    /// Where no lines are known and too many do, not all are looked for.
    pub(super) fn mutants(&self) -> DrawingMutants {
        let mut drawn = DrawingMutants::default();
        let mut seen = HashSet::new();
        for (program, number, function, edit) in self.mutated() {
            let mutant = program.code().with_mutant(number);
            if !self.may_draw(&ChapterProgram::typed(self.right.chapter, mutant)) {
                continue;
            }
            let text = edit.applied_to(&function.text);
            if !seen.insert((&function.name, text.clone())) {
                continue;
            }
            let change =
                StatementDiff::of([(&*function.name, &*function.text, &*text)].into_iter());
            let said = self.lines.status(&change);
            if said == LineStatus::Right {
                continue;
            }
            let yours = (said == LineStatus::Wrong).then(|| self.lines.corrected(&change));
            let Some(program) = self.right.with_function(&function.name, &text) else {
                continue;
            };
            drawn.add(Mutant {
                yours: yours.flatten(),
                does: Some(Behavior::of(program)),
                ..Mutant::new(function, &edit)
            });
            if self.lines.is_empty() && drawn.all.len() > MOST {
                break;
            }
        }
        drawn.checked(|it| self.draws(it))
    }

    /// Writes all mutations of each function into it, each with its number, the likeliest first.
    fn mutated(&self) -> Vec<(Rc<ChapterProgram>, u32, &'a ParsedFunction, RankedEdit)> {
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
        let is_own = |it: &ParsedFunction| files.iter().any(|file| file.text.contains(&it.text));
        all.sort_by_cached_key(|(_, _, function, edit)| {
            let elsewhere = if is_own(function) { 0 } else { ELSEWHERE };
            edit.rank + edit.brackets(&function.text) + elsewhere
        });
        all
    }

    fn may_draw(&self, program: &ChapterProgram) -> bool {
        draws(program, self.reading, self.places.iter().copied())
    }

    fn draws(&self, program: &ChapterProgram) -> bool {
        draws(program, self.reading, 0..self.reading.pixels.len() as u32)
    }
}

impl DrawingMutants {
    /// Returns true if they are so few that the picture tells something of the mistake.
    pub(crate) fn is_told(&self) -> bool {
        (1..=MOST).contains(&self.count)
    }

    /// Adds a mutant, unless one is known that changes the same value in the same way.
    fn add(&mut self, mutant: Mutant) {
        let mut known = self.all.iter_mut();
        match known.find(|it| it.does_as(&mutant)) {
            Some(known) if mutant.yours.is_some() && known.yours.is_none() => *known = mutant,
            Some(_) => {}
            None => self.all.push(mutant),
        }
    }

    /// Keeps those that stand in the reader's files, if some do; and of few those that draw all of
    /// the picture.
    fn checked(mut self, draws: impl Fn(&ChapterProgram) -> bool) -> Self {
        if self.all.iter().any(|it| it.yours.is_some()) {
            self.all.retain(|it| it.yours.is_some());
        }
        self.count = self.all.len();
        if self.is_told() {
            let is_it = |it: &Mutant| it.does.as_ref().is_some_and(|it| draws(&it.program));
            self.all.retain(is_it);
            self.count = self.all.len();
        }
        self.all.truncate(SHOWN);
        self
    }
}

impl Mutant {
    fn new(function: &ParsedFunction, edit: &RankedEdit) -> Self {
        let wrong = edit.applied_to(&function.text);
        let after = function.text.len() - edit.at.end;
        Self {
            right: lines(&function.text, edit.at.start, after),
            wrong: lines(&wrong, edit.at.start, after),
            yours: None,
            does: None,
        }
    }

    fn does_as(&self, other: &Self) -> bool {
        let both = self.does.as_ref().zip(other.does.as_ref());
        both.is_some_and(|(one, other)| {
            one.small == other.small && one.answers.mismatch_with(&other.program, 1).differing == 0
        })
    }
}

impl Behavior {
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

/// Returns the whole lines around a part of a text.
fn lines(text: &str, before: usize, after: usize) -> String {
    let end = text.len() - after;
    let start = text[..before].rfind('\n').map_or(0, |at| at + 1);
    let end = text[end..].find('\n').map_or(text.len(), |at| end + at);
    squeezed(&text[start..end])
}

/// Chooses pixels of which wrong programs draw few: wrong ones, right ones, and some of all.
fn places(right: &ChapterProgram, reading: &Reading) -> Vec<u32> {
    let total = reading.pixels.len() as u32;
    let output = right.run(reading.width);
    let is_whole = output.size() == (reading.width, reading.height);
    let is_fine = |n: u32| is_whole && is_drawn(&output, reading, n);
    let (fine, wrong): (Vec<u32>, Vec<u32>) = spread(LOOKED, total).partition(|n| is_fine(*n));
    let some = |all: &[u32]| -> Vec<u32> {
        let places = spread(FIRST, all.len() as u32);
        places.map(|n| all[n as usize]).collect()
    };
    let (first, next) = (some(&wrong), some(&fine));
    let pairs = (0..FIRST as usize).flat_map(|n| [first.get(n), next.get(n)]);
    let pairs = pairs.flatten().copied();
    pairs.chain(spread(LOOKED, total)).collect()
}

/// Returns true if the program draws these pixels.
fn draws(
    program: &ChapterProgram,
    reading: &Reading,
    mut places: impl Iterator<Item = u32>,
) -> bool {
    let output = program.run(reading.width);
    output.size() == (reading.width, reading.height)
        && places.all(|n| is_drawn(&output, reading, n))
}

/// Returns true if a pixel is printed so, or stored so by what has only levels.
fn is_drawn(output: &Output, reading: &Reading, n: u32) -> bool {
    output.printed(n).is_some_and(|levels| {
        let levels = levels.map(|it| it.clamp(i16::MIN.into(), i16::MAX.into()) as i16);
        let found = reading.pixels[n as usize];
        distance(levels, found) == 0 || levels.map(|it| it.clamp(0, 255)) == found
    })
}
