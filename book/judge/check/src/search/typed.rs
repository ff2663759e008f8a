//! Program repair for a text that is typed in a page: the likeliest single edit of it that makes
//! the program right.

use common::rtweekend::Picture;
use interpreter::{Program, SourceFile};
use laws::answers::Answers;
use slips::ChapterProgram;

use super::edit::RankedEdit;
use super::forwards::{answers, lines, some_of};
use super::functions::{RustFn, functions};
use super::mutation::{mutations, schemata};
use crate::lawful;
use crate::pixels::spread;
use crate::reading::Reading;
use crate::sources::{CorrectedLine, SourceLine};
use crate::task::Task;

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
const LOOKED: u32 = 100;
/// The most pixels of a picture that an edited program has to draw.
const DRAWN: u32 = 100_000;
/// The greatest rank of an edit that is shown: in one of a greater rank a reader would not
/// recognize the mistake.
const READABLE: u32 = 16;

/// What a right program does: the levels of pixels, by their numbers, and the answers of its
/// functions.
struct Goal {
    right: ChapterProgram,
    width: u32,
    sample: Vec<(u32, [u8; 3])>,
    all: Vec<(u32, [u8; 3])>,
    answers: Answers,
}

impl Repair {
    /// Finds the likeliest single edit of a function that is not the chapter's word for word with
    /// which the program is right; `None` if it is right, or no edit makes it so.
    pub(crate) fn find(task: &Task, reading: &Reading, typed: &TypedText) -> Option<Self> {
        let right = task.right_picture(reading.width, reading.height);
        let goal = Goal::new(task, reading, &right);
        let is_hidden = right == reading.picture();
        if task.probe.is_some() || is_hidden && goal.is_answered_by(typed.program) {
            return None;
        }
        let chapter: Vec<&str> = goal.right.functions().map(|it| it.1).collect();
        let yours = functions(typed.program);
        let yours = yours.iter().filter(|it| !chapter.contains(&&*it.text));
        let mut tries: Vec<(&RustFn, Program, RankedEdit)> = Vec::new();
        for function in yours {
            let all = mutations(function);
            let text = schemata(function, &all, 1);
            let Ok(program) = typed.program.patched(&function.name, &text) else {
                continue;
            };
            tries.extend((1..).zip(&all).map(|(number, it)| {
                (
                    function,
                    program.with_mutant(number),
                    it.edit(&function.text),
                )
            }));
        }
        tries.sort_by_key(|(function, _, edit)| edit.rank + edit.brackets(&function.text));
        let mut tries = tries.into_iter().filter(|(.., edit)| edit.rank <= READABLE);
        let (function, _, edit) = tries.find(|(_, program, _)| goal.is_met_by(program))?;
        let line = corrected(function, &edit, typed.files)?;
        Some(Self { line, is_hidden })
    }
}

/// Returns the line of a file that an edit of a function changes.
fn corrected(function: &RustFn, edit: &RankedEdit, files: &[SourceFile]) -> Option<CorrectedLine> {
    let (file, start) = function.place(files)?;
    let SourceFile { name, text } = &files[file];
    let after = function.text.len() - edit.at.end;
    let line = SourceLine {
        file: name.clone(),
        number: text[..start + edit.at.start].matches('\n').count() + 1,
        text: lines(&function.text, edit.at.start, after),
    };
    let right = lines(&edit.applied_to(&function.text), edit.at.start, after);
    Some(CorrectedLine { line, right })
}

impl Goal {
    /// Chooses the pixels to compare: first some that differ from the reader's and some that do
    /// not, then all.
    fn new(task: &Task, reading: &Reading, right: &Picture) -> Self {
        let (levels, _) = right.rgb().as_chunks::<3>();
        let all = spread(DRAWN, levels.len() as u32);
        let is_wrong = |n: &u32| levels[*n as usize].map(i16::from) != reading.pixels[*n as usize];
        let (wrong, fine): (Vec<u32>, Vec<u32>) = all.clone().partition(is_wrong);
        let sample = [wrong, fine].map(|it| some_of(&it, LOOKED)).concat();
        let pixel = |n: u32| (n, levels[n as usize]);
        let program = ChapterProgram::right(task.chapter);
        Self {
            width: reading.width,
            sample: sample.into_iter().map(pixel).collect(),
            all: all.map(pixel).collect(),
            answers: answers(&program),
            right: program,
        }
    }

    fn is_answered_by(&self, program: &Program) -> bool {
        let chapter = self.right.chapter;
        let program = ChapterProgram::from_reader(chapter, program.clone());
        lawful::mismatch_with(&self.answers, chapter, &program, 1).differing == 0
    }

    fn is_met_by(&self, program: &Program) -> bool {
        let Ok(canvas) = program.canvas(self.width) else {
            return false;
        };
        let (width, height) = canvas.size();
        let is_drawn = |&(n, right): &(u32, [u8; 3])| {
            let levels = canvas.levels(n % width.max(1), n / width.max(1));
            n < width * height && levels.is_ok_and(|it| it == right)
        };
        self.sample.iter().all(is_drawn)
            && self.is_answered_by(program)
            && self.all.iter().all(is_drawn)
    }
}
