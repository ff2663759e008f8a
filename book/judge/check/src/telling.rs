//! Discriminating tests: the choice of a probe that tells mistakes apart.

use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};

use crate::task::Task;
use slips::{PROBES, Probe, Slip};

/// Chooses the probe in which the mistakes draw most different pictures, the first of equals;
/// `None` if there is one mistake, or all draw the same in each probe. Never chooses that of the
/// task.
pub(crate) fn telling_probe(task: &Task, mistakes: &[Vec<&'static Slip>]) -> Option<Probe> {
    let mut best = (1, None);
    for probe in PROBES.into_iter().filter(|_| mistakes.len() > 1) {
        let probed = Task::new(task.chapter, Some(probe)).filter(|it| it.probe != task.probe);
        let pictures = probed.map_or(0, |it| pictures(&it, probe.width, mistakes));
        if pictures > best.0 {
            best = (pictures, Some(probe));
        }
    }
    best.1
}

/// Counts the different pictures that the mistakes draw of the task, `width` pixels wide.
fn pictures(task: &Task, width: u32, mistakes: &[Vec<&'static Slip>]) -> usize {
    let mark = |mistake: &Vec<&'static Slip>| {
        let output = task.program(mistake).run(width);
        let (width, height) = output.size();
        let mut hasher = DefaultHasher::new();
        hasher.write_u32(width);
        // What a probe shows is large enough to be seen in every third pixel.
        for n in (0..width * height).step_by(3) {
            output.pixel(n).hash(&mut hasher);
        }
        hasher.finish()
    };
    mistakes.iter().map(mark).collect::<HashSet<u64>>().len()
}
