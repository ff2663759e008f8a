//! Discriminating tests: a probe that tells mistakes apart.

use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};

use crate::task::Task;
use slips::{PROBES, Probe, Slip};

/// The probe that tells most of the mistakes apart, the cheapest change among equals;
/// `None` if all of them draw the same in all of them.
pub(crate) fn apart(task: &Task, mistakes: &[Vec<&'static Slip>]) -> Option<Probe> {
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

/// How many pictures of that scene the mistakes draw.
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
