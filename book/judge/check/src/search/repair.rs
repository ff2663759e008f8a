//! Verified repair: the smallest edit with which a reader's program is right.
//!
//! A mistake is a difference between the chapter's text and the reader's, and it is named if
//! putting it right was tried.

use std::cell::Cell;

use interpreter::{Program, SourceFile};

use super::backwards::{Fix, RepairSearch};
use super::functions::{ParsedFunction, functions, with};
use super::goal::{self, Goal, program};
use super::searched;
use super::tree::squeezed;
use crate::reading::Reading;
use crate::sources::{SourceLine, Sources};
use crate::task::Task;

/// What makes a program right, tried.
#[derive(Clone, Debug)]
pub struct Repair {
    /// What is to be changed.
    pub changes: Vec<Change>,
    /// The reader's files with all of it.
    pub(crate) files: Vec<SourceFile>,
    /// True if the picture was right before.
    pub(crate) is_hidden: bool,
    /// The step of the chapter, counted from 0, for which it is right, if it is not the last.
    pub(crate) step: Option<usize>,
}

/// A place in the reader's files, and what is right there.
#[derive(Clone, Debug)]
pub struct Change {
    /// The reader's line.
    pub yours: SourceLine,
    /// What should be there.
    pub right: Correction,
}

/// What is right in a place.
#[derive(Clone, Debug)]
pub enum Correction {
    /// This instead.
    Instead(String),
    /// This above it.
    Above(String),
    /// Nothing.
    LeaveOut,
    /// This instead, in the reader's own language: the chapter was tried with the reader's line.
    InOwnLanguage(String),
}

impl Repair {
    /// Returns true if each change is a line in the place of another.
    pub(crate) fn is_of_lines(&self) -> bool {
        let mut changes = self.changes.iter();
        changes.all(|it| matches!(it.right, Correction::Instead(_)))
    }

    /// Finds the line in another language with which the chapter draws the picture.
    fn transplanted(task: &Task, reading: &Reading, sources: &Sources) -> Option<Self> {
        let found = searched(task, reading, sources, |it| it.transplanted())?;
        let (yours, right) = (found.line, Correction::InOwnLanguage(found.right));
        Some(Self {
            changes: vec![Change { yours, right }],
            files: Vec::new(),
            is_hidden: false,
            step: None,
        })
    }

    /// Finds what makes a program right that draws this picture of the scene, or of one of so many
    /// steps on the way to it.
    pub(crate) fn of(
        task: &Task,
        reading: &Reading,
        sources: &Sources,
        steps: usize,
    ) -> Option<Self> {
        let files = sources.in_rust();
        if sources.is_empty() || files.is_empty() && task.probe.is_some() {
            return None;
        }
        if files.is_empty() {
            return Self::transplanted(task, reading, sources);
        }
        let (yours, loops) = drawing(&files, reading)?;
        let chapter = slips::ChapterProgram::right(task.chapter);
        let chapter = chapter.code();
        let (own, theirs) = (functions(&yours), functions(chapter));
        let right = |task: &Task| task.right_picture(reading.width, task.height(reading.width));
        let goal_of = |task: &Task| {
            let goal = Goal::new(task.chapter, &right(task), reading);
            if loops { goal.looping(task) } else { goal }
        };
        let swapped = || with_one_of_the_chapter(&yours, &own, &theirs);
        let on_the_way = (0..steps).find_map(|step| {
            let task = task.at_step(step);
            let goal = goal_of(&task);
            let there = swapped().filter(|it| goal.is_met_by(it));
            let mut goals = there.map(|it| goal_of(&task).asking(&it));
            Some((task, goals.find(|goal| !goal.is_met_by(&yours))?))
        });
        let (task, goal) = match on_the_way {
            Some(found) => found,
            // Of another scene only the picture is known.
            None if task.probe.is_some() => (*task, goal_of(task)),
            None => (*task, goal_of(task).asking(chapter)),
        };
        let is_hidden = right(&task) == reading.picture();
        if is_hidden && goal.is_answered_by(&yours) {
            return None;
        }
        let search = RepairSearch {
            program: &yours,
            yours: &own,
            chapter: &theirs,
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

/// Reads the program of these files, if it draws this picture, and tells whether its own loop
/// over the pixels does.
fn drawing(files: &[SourceFile], reading: &Reading) -> Option<(Program, bool)> {
    let yours = program(files)?;
    let has_a_loop = files.iter().any(|it| it.text.contains("struct Ray"));
    let draws = || {
        let picture = yours.draw(reading.width);
        picture.is_ok_and(|it| it == reading.picture())
    };
    let is_it = goal::draws(&yours, reading, goal::LOOKED) || has_a_loop && draws();
    let loops = has_a_loop && yours.draw(1).is_ok();
    is_it.then_some((yours, loops))
}

/// The reader's program with one function of the chapter's in place of the reader's: on the way
/// to the chapter, it shows what its step does.
fn with_one_of_the_chapter<'a>(
    program: &'a Program,
    yours: &'a [ParsedFunction],
    right: &'a [ParsedFunction],
) -> impl Iterator<Item = Program> + 'a {
    let pairs = yours
        .iter()
        .flat_map(move |own| right.iter().map(move |it| (own, it)));
    let same = pairs.filter(|(own, it)| own.name == it.name);
    same.filter_map(|(own, it)| program.patched(&own.name, &it.text).ok())
}

impl Fix<'_> {
    /// Finds the lines that are changed.
    fn changes(&self, files: &[SourceFile]) -> Vec<Change> {
        let line = |files: &[SourceFile], function: &ParsedFunction, n: usize| {
            let (file, start) = function.place(files).unwrap_or_default();
            let SourceFile { name, text } = &files[file];
            let before = text[..start].matches('\n').count();
            SourceLine {
                file: name.clone(),
                number: before + n + 1,
                text: squeezed(text.lines().nth(before + n).unwrap_or_default()),
            }
        };
        let change = |n: usize, right: Correction| Change {
            yours: line(files, self.yours, n),
            right,
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
        change.yours.text = old.join(" ");
        vec![change]
    }
}

fn lines(text: &str) -> Vec<String> {
    text.lines().map(squeezed).collect()
}
