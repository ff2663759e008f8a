//! Discriminating tests: the choice of a probe that tells mistakes apart.

use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};

use slips::{PROBES, Probe, Slip};

use crate::task::Task;
use crate::work::{self, Work};

/// The most mistakes that are told apart.
const MOST: usize = 3;
/// One in so many pixels is compared: what a probe shows is large.
const EACH: usize = 11;

/// Chooses the probe in which the mistakes draw most different pictures, the first of equals;
/// `None` if there is one mistake, if all draw the same in each probe, or if no work is left. Never
/// chooses that of the task.
pub(crate) fn telling_probe(
    task: &Task,
    mistakes: &[&[&'static Slip]],
    work: &Work,
) -> Option<Probe> {
    let mistakes = &mistakes[..mistakes.len().min(MOST)];
    let mut best = (1, None);
    for probe in PROBES.into_iter().filter(|_| mistakes.len() > 1) {
        let probed = Task::new(task.chapter, Some(probe)).filter(|it| it.probe != task.probe);
        let pictures = probed.map_or(0, |it| pictures(&it, probe.width, mistakes, work));
        if pictures > best.0 {
            best = (pictures, Some(probe));
        }
    }
    best.1
}

/// Counts the different pictures that the mistakes draw of the task, `width` pixels wide; 0 if no
/// work is left.
fn pictures(task: &Task, width: u32, mistakes: &[&[&'static Slip]], work: &Work) -> usize {
    let mark = |mistake: &&[&'static Slip]| {
        let output = task.program(mistake).run(width);
        let (width, height) = output.size();
        let mut hasher = DefaultHasher::new();
        hasher.write_u32(width);
        for n in (0..width * height).step_by(EACH) {
            if !work.take(work::pixel(task.chapter)) {
                return None;
            }
            output.pixel(n).hash(&mut hasher);
        }
        Some(hasher.finish())
    };
    let marks: Option<HashSet<u64>> = mistakes.iter().map(mark).collect();
    marks.map_or(0, |it| it.len())
}
