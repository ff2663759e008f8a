//! Program repair for a text that is typed in a page: the likeliest single edit of it that makes
//! the program right.

use std::collections::HashSet;

use edits::Defined;
use interpreter::{Program, SourceFile};
use laws::answers::Answers;
use slips::ChapterProgram;

use crate::case::Case;
use crate::generated::{Try, answers, tries};
use crate::lawful;
use crate::pixels::spread;
use crate::sources::{CorrectedLine, SourceLine, squeezed};
use crate::work::{self, Work};

/// A text that a reader types in a page, and the program as which it was read.
#[derive(Clone, Copy)]
pub struct TypedText<'a> {
    /// The files.
    pub files: &'a [SourceFile],
    /// The program, which draws the picture that is judged.
    pub program: &'a Program,
}

/// An edit that makes a reader's wrong program right. It was tried: the edited program draws the
/// right picture, and its functions answer as the chapter's do.
#[derive(Clone, Debug)]
pub struct Repair {
    /// The wrong line, and what should be in its place.
    pub line: CorrectedLine,
    /// True if the picture was right before, and hid the mistake.
    pub is_hidden: bool,
}

/// The number of wrong pixels, and of right ones, that are compared first.
const LOOKED: u32 = 60;

/// What a right program does: the levels of pixels, by their numbers, and the answers of its
/// functions.
struct Goal {
    width: u32,
    sample: Vec<u32>,
    right: Vec<[u8; 3]>,
    answers: Answers,
}

impl Repair {
    /// Finds the likeliest single edit of a function that is not the chapter's word for word with
    /// which the program is right; `None` if it is right, or no edit that was tried makes it so.
    pub(crate) fn find(case: &Case, typed: &TypedText) -> Option<Self> {
        let chapter = case.task.chapter;
        let yours = ChapterProgram::from_reader(chapter, typed.program.clone());
        let goal = Goal::of(case)?;
        let is_hidden = case.left_by_right().is_nothing();
        if is_hidden && goal.is_answered_by(&yours) {
            return None;
        }
        let texts: Vec<&str> = typed.files.iter().map(|it| &*it.text).collect();
        let defined = Defined::by(&texts).ok()?;
        let right = ChapterProgram::right(chapter);
        let right: Vec<&str> = right.functions().map(|it| it.1).collect();
        let is_edited = |text: &str| !right.contains(&text);
        let mut all = tries(
            &yours,
            &defined,
            goal.width,
            is_edited,
            u32::MAX,
            &case.work,
        );
        // An edit that makes a line the chapter's own is likeliest.
        let lines = right.iter().flat_map(|text| text.lines()).map(squeezed);
        let lines: HashSet<String> = lines.collect();
        all.sort_by_cached_key(|it| !lines.contains(&squeezed(&it.edit.lines(it.text).new)));
        let found = all.into_iter().find(|it| goal.is_met_by(it, &case.work))?;
        let line = corrected(&found, typed.files)?;
        Some(Self { line, is_hidden })
    }
}

/// Returns the line of a file that an edit changes.
fn corrected(it: &Try, files: &[SourceFile]) -> Option<CorrectedLine> {
    let mut places = files.iter();
    let (file, start) = places.find_map(|file| Some((file, file.text.find(it.text)?)))?;
    let lines = it.edit.lines(it.text);
    let line = SourceLine {
        file: file.name.clone(),
        number: file.text[..start].matches('\n').count() + lines.number,
        text: squeezed(&lines.old),
    };
    let right = squeezed(&lines.new);
    Some(CorrectedLine { line, right })
}

impl Goal {
    /// Chooses the pixels to compare first: some that differ from the reader's and some of all.
    /// `None` for a probe, of whose scene no questions are known.
    fn of(case: &Case) -> Option<Self> {
        let (reading, task) = (case.reading, case.task);
        let right = task.right_picture(reading.width, task.height(reading.width));
        let (right, _) = right.rgb().as_chunks::<3>();
        let some = spread(LOOKED, right.len() as u32);
        let wrong = case.places().wrong.iter().copied();
        task.probe.is_none().then(|| Self {
            width: reading.width,
            sample: wrong
                .filter(|n| (*n as usize) < right.len())
                .chain(some)
                .collect(),
            right: right.to_vec(),
            answers: answers(&ChapterProgram::right(task.chapter)),
        })
    }

    fn is_answered_by(&self, program: &ChapterProgram) -> bool {
        lawful::mismatch_with(&self.answers, program.chapter, program, 1).differing == 0
    }

    /// Returns true if a program draws the right picture and gives all answers; false if no work is
    /// left.
    fn is_met_by(&self, it: &Try, work: &Work) -> bool {
        let program = it.program();
        let price = it.canvas().map_or(work::START, |_| work::MUTANT);
        let made = || {
            it.canvas()
                .or_else(|| program.code().canvas(self.width).ok())
        };
        let Some(canvas) = work.take(price).then(made).flatten() else {
            return false;
        };
        let (width, height) = canvas.size();
        let is_drawn = |n: u32| {
            let is_inside = work.take(work::pixel(program.chapter)) && n < width * height;
            is_inside
                && canvas
                    .levels(n % width, n / width)
                    .is_ok_and(|it| it == self.right[n as usize])
        };
        width as usize * height as usize == self.right.len()
            && self.sample.iter().all(|n| is_drawn(*n))
            && self.is_answered_by(&program)
            && (0..self.right.len() as u32).all(is_drawn)
    }
}
