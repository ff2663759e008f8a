//! Discriminating tests: a probe that tells mistakes apart.

use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};

use crate::scene::Scene;
use slips::{PROBES, Probe, Slip};

/// The probe that tells most of the mistakes apart, the cheapest change among equals;
/// `None` if all of them draw the same in all of them.
pub(crate) fn apart(scene: &Scene, mistakes: &[Vec<&'static Slip>]) -> Option<Probe> {
    let mut best = (1, None);
    for probe in PROBES.into_iter().filter(|_| mistakes.len() > 1) {
        let probed = Scene::new(scene.chapter, Some(probe)).filter(|it| it.probe != scene.probe);
        let pictures = probed.map_or(0, |it| pictures(&it, probe.width, mistakes));
        if pictures > best.0 {
            best = (pictures, Some(probe));
        }
    }
    best.1
}

/// How many pictures of that scene the mistakes draw.
fn pictures(scene: &Scene, width: u32, mistakes: &[Vec<&'static Slip>]) -> usize {
    let mark = |mistake: &Vec<&'static Slip>| {
        let output = scene.program(mistake).run(width);
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
