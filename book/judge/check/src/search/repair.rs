//! Verified repair: the smallest edit with which a reader's program is right.
//!
//! A mistake is a difference between the chapter's text and the reader's, and it is named if
//! putting it right was tried.

use std::cell::Cell;

use common::rtweekend::Picture;
use interpreter::{Program, SourceFile};

use super::backwards::{Fix, RepairSearch};
use super::functions::{RustFn, functions, with};
use super::goal::{self, Goal};
use super::tree::squeezed;
use crate::reading::Reading;
use crate::sources::{SourceLine, Sources};
use crate::task::Task;

/// A set of changes that makes a reader's wrong program right. It was tried: the changed program
/// draws the right picture and, unless a [`Probe`](slips::Probe) is drawn, its functions
/// answer as the chapter's do.
#[derive(Clone, Debug)]
pub struct Repair {
    /// The lines to change, function by function and in each from the top; never empty.
    pub changes: Vec<LineChange>,
    /// The reader's files with all changes, without `main.rs`.
    pub(crate) files: Vec<SourceFile>,
    /// True if the picture was right before, and hid the mistake.
    pub(crate) is_hidden: bool,
    /// The step of the chapter, counted from 0, that the changed program does; `None` for the whole
    /// chapter.
    pub(crate) step: Option<usize>,
}

/// A wrong line of a reader's file, or one above which a line is missing, with the correction.
#[derive(Clone, Debug)]
pub struct LineChange {
    /// The line as the reader typed it. Where several lines are replaced together, the first one's
    /// number with the text of all.
    pub line: SourceLine,
    /// The code that belongs there.
    pub correction: Correction,
}

/// The correction of a wrong [`line`](LineChange::line): code in its place, code above it, or none.
/// Code of several lines is joined to one.
#[derive(Clone, Debug)]
pub enum Correction {
    /// Code that replaces the line.
    Instead(String),
    /// Code to insert above the line, which stays as it is.
    Above(String),
    /// An instruction to delete the line.
    LeaveOut,
}

impl Repair {
    /// Returns true if each change replaces a line by another.
    pub(crate) fn replaces_lines_only(&self) -> bool {
        let mut changes = self.changes.iter();
        changes.all(|it| matches!(it.correction, Correction::Instead(_)))
    }

    /// Finds the smallest change of the reader's files that makes the program right, which now
    /// draws this picture, for the task or for one of the first `steps` steps on the way to it.
    ///
    /// Returns `None` if no file is known, or if the program can't be read, has vectors and rays of
    /// its own, draws another picture, is right, or becomes right by no edit that was tried.
    pub(crate) fn find(
        task: &Task,
        reading: &Reading,
        sources: &Sources,
        steps: usize,
    ) -> Option<Self> {
        let files = sources.of_the_library();
        if files.is_empty() {
            return None;
        }
        let reader = ReaderProgram::read(&files, reading)?;
        let right = slips::ChapterProgram::right(task.chapter);
        let chapter = functions(right.code());
        let (task, goal) = match reader.step(task, reading, &chapter, steps) {
            Some(found) => found,
            // No questions are known about the scene of a probe.
            None if task.probe.is_some() => (*task, goal_of(task, reading)),
            None => (*task, goal_of(task, reading).asking(right.code())),
        };
        let is_hidden = right_picture(&task, reading) == reading.picture();
        if is_hidden && goal.is_answered_by(&reader.program) {
            return None;
        }
        let search = RepairSearch {
            program: &reader.program,
            yours: &reader.functions,
            chapter: &chapter,
            goal: &goal,
            read: Cell::default(),
        };
        let fixes = search.find()?;
        let texts: Vec<_> = fixes.iter().map(|it| (it.yours, &*it.text)).collect();
        let changes = fixes.iter().flat_map(|it| it.changes(&files));
        Some(Self {
            changes: changes.collect(),
            files: with(&files, &texts),
            is_hidden,
            step: task.step(),
        })
    }
}

/// Draws the right picture of a task, as wide as the one that was read.
fn right_picture(task: &Task, reading: &Reading) -> Picture {
    task.right_picture(reading.width, task.height(reading.width))
}

/// Makes the goal of a task: to draw its right picture.
fn goal_of(task: &Task, reading: &Reading) -> Goal {
    Goal::new(task.chapter, &right_picture(task, reading), reading)
}

/// A reader's program that draws the picture that is judged.
struct ReaderProgram {
    /// The program as the interpreter runs it.
    program: Program,
    /// The functions of the program.
    functions: Vec<RustFn>,
}

impl ReaderProgram {
    /// Reads the program of these files, if it draws this picture.
    fn read(files: &[SourceFile], reading: &Reading) -> Option<Self> {
        // A prelude of the reader's own is left to its laws.
        if files.iter().any(|it| it.text.contains("struct Ray")) {
            return None;
        }
        let program = interpreter::read(files).ok()?;
        goal::draws(&program, reading, goal::LOOKED).then(|| Self {
            functions: functions(&program),
            program,
        })
    }

    /// Finds the first of so many steps on the way to a task that the program is meant to be: with
    /// one function of the chapter it draws the step's picture, and without it does not answer as
    /// it does with it. Returns the step as a task, and its goal.
    fn step(
        &self,
        task: &Task,
        reading: &Reading,
        chapter: &[RustFn],
        steps: usize,
    ) -> Option<(Task, Goal)> {
        (0..steps).find_map(|step| {
            let task = task.at_step(step);
            let goal = goal_of(&task, reading);
            let there = self.with_one_of(chapter).filter(|it| goal.is_met_by(it));
            let mut goals = there.map(|it| goal_of(&task, reading).asking(&it));
            Some((task, goals.find(|goal| !goal.is_met_by(&self.program))?))
        })
    }

    /// Returns the program with one of its functions replaced by the chapter's of the same name,
    /// for each function that both have.
    fn with_one_of(&self, chapter: &[RustFn]) -> impl Iterator<Item = Program> {
        let own = self.functions.iter();
        let pairs = own.flat_map(|own| chapter.iter().map(move |it| (own, it)));
        let same = pairs.filter(|(own, it)| own.name == it.name);
        same.filter_map(|(own, it)| self.program.patched(&own.name, &it.text).ok())
    }
}

impl Fix<'_> {
    /// Compares a function with its repaired text, line by line. If their numbers of lines differ,
    /// all lines from the first to the last difference make one change.
    fn changes(&self, files: &[SourceFile]) -> Vec<LineChange> {
        let line = |files: &[SourceFile], function: &RustFn, n: usize| {
            let (file, start) = function.place(files).unwrap_or_default();
            let SourceFile { name, text } = &files[file];
            let before = text[..start].matches('\n').count();
            SourceLine {
                file: name.clone(),
                number: before + n + 1,
                text: squeezed(text.lines().nth(before + n).unwrap_or_default()),
            }
        };
        let change = |n: usize, correction: Correction| LineChange {
            line: line(files, self.yours, n),
            correction,
        };
        let [old, new] = [&self.yours.text, &self.text].map(|it| lines(it));
        // Only what stands between the first and the last lines that differ is looked at.
        let is_same = |(one, other): &(&String, &String)| one == other;
        let first = old.iter().zip(&new).take_while(is_same).count();
        let back = old[first..].iter().rev().zip(new[first..].iter().rev());
        let last = back.take_while(is_same).count();
        let [old, new] = [&old, &new].map(|it| &it[first..it.len() - last]);
        let correction = |text: String| {
            if text.is_empty() {
                Correction::LeaveOut
            } else {
                Correction::Instead(text)
            }
        };
        if old.is_empty() {
            return vec![change(first, Correction::Above(new.join(" ")))];
        }
        if old.len() == new.len() {
            let pairs = old.iter().zip(new).enumerate();
            let changed = pairs.filter(|(_, pair)| !is_same(pair));
            let changes = changed.map(|(n, (_, new))| change(first + n, correction(new.clone())));
            return changes.collect();
        }
        let mut change = change(first, correction(new.join(" ")));
        change.line.text = old.join(" ");
        vec![change]
    }
}

/// Splits a text into lines, each with single blanks and without comments.
fn lines(text: &str) -> Vec<String> {
    text.lines().map(squeezed).collect()
}
