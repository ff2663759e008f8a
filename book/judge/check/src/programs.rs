//! The programs of tasks, each made once: the only place that keeps any.

use std::collections::BTreeMap;
use std::sync::{LazyLock, Mutex, PoisonError};

use slips::{Chapter, ChapterProgram, Slip, steps};

use crate::task::{Task, Version};

/// A task without its chapter's name and its probe, those, and the name of a slip.
type Key = (
    Chapter,
    Version,
    Option<usize>,
    Option<(u32, u32)>,
    [&'static str; 2],
);

/// How many programs are kept at most.
const MOST: usize = 2000;

/// The programs that were made, each of a task and with one slip or none.
static KEPT: LazyLock<Mutex<BTreeMap<Key, ChapterProgram>>> = LazyLock::new(Mutex::default);

/// Returns the program that draws a task, with these slips (known mistakes) made in it; the right
/// program for none. The size comes first, then step, probe, version and slips; a slip that can't
/// be made changes nothing.
pub(crate) fn program(task: &Task, slips: &[&Slip]) -> ChapterProgram {
    let right = || kept(task, "", || right_program(task));
    let with = |slip: &Slip| match slip.name {
        // Only some laws know what has no name.
        "" => slip.applied_to(&right()),
        name => kept(task, name, || slip.applied_to(&right())),
    };
    let Some((first, others)) = slips.split_first() else {
        return right();
    };
    others.iter().fold(with(first), |program, slip| {
        let joined = program.merged_with(&with(slip), &right());
        joined.unwrap_or_else(|| slip.applied_to(&program))
    })
}

/// Returns true if two slips change the same function, so that it is read anew for both.
pub(crate) fn are_in_one_function(task: &Task, [one, other]: [&Slip; 2]) -> bool {
    let [one, other] = [one, other].map(|slip| program(task, &[slip]));
    one.merged_with(&other, &program(task, &[])).is_none()
}

fn kept(task: &Task, slip: &'static str, make: impl FnOnce() -> ChapterProgram) -> ChapterProgram {
    let probe = task.probe.map_or("", |probe| probe.name);
    let key = (
        task.chapter,
        task.version,
        task.step,
        task.size,
        [probe, slip],
    );
    let all = || KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(program) = all().get(&key) {
        return program.clone();
    }
    let program = make();
    let mut all = all();
    if all.len() >= MOST {
        all.clear();
    }
    all.insert(key, program.clone());
    program
}

/// Makes the program that draws a task without a mistake.
fn right_program(task: &Task) -> ChapterProgram {
    let mut program = ChapterProgram::right_of_shape(task.chapter, task.size);
    if let Some(step) = task.step {
        program = steps::of_chapter(task.chapter)[step].applied_to(&program);
    }
    if let Some(probed) = task.probe.and_then(|it| it.applied_to(&program)) {
        program = probed;
    }
    match task.version {
        Version::Three => slips::version_3().applied_to(&program),
        Version::Four => program,
    }
}
