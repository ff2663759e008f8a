//! Discriminating tests: a probe that tells mistakes apart.

use std::hash::{DefaultHasher, Hasher};

use crate::scene::Scene;
use slips::{PROBES, Probe, Slip};

/// A probe in which mistakes draw different pictures.
#[derive(Clone, Debug)]
pub struct Telling {
    /// The probe.
    pub probe: Probe,
    /// The mistakes that still look alike, as places in the list of mistakes.
    pub groups: Vec<Vec<usize>>,
}

/// The probe that tells most of the mistakes apart, the cheapest change among
/// equals; `None` if all of them draw the same in all of them.
pub(crate) fn apart(scene: &Scene, mistakes: &[Vec<&'static Slip>]) -> Option<Telling> {
    if mistakes.len() < 2 {
        return None;
    }
    let tellings = PROBES
        .into_iter()
        .filter(|probe| Some(*probe) != scene.probe)
        .filter_map(|probe| {
            let scene = Scene::new(scene.chapter, Some(probe))?;
            let groups = groups(&scene, probe.width, mistakes);
            Some(Telling { probe, groups })
        });
    let mut best: Option<Telling> = None;
    for telling in tellings {
        if telling.groups.len() > best.as_ref().map_or(1, |best| best.groups.len()) {
            best = Some(telling);
        }
    }
    best
}

/// The mistakes that draw the same picture of that scene.
fn groups(scene: &Scene, width: u32, mistakes: &[Vec<&'static Slip>]) -> Vec<Vec<usize>> {
    let mut groups: Vec<(u64, Vec<usize>)> = Vec::new();
    for (n, mistake) in mistakes.iter().enumerate() {
        let output = scene.program(mistake).run(width);
        let mut hasher = DefaultHasher::new();
        let (width, height) = output.size();
        hasher.write_u32(width);
        hasher.write_u32(height);
        // What a probe shows is large enough to be seen in every third pixel.
        for n in (0..width * height).step_by(3) {
            let [red, green, blue] = output.pixel(n).map(|level| level.clamp(0, 255) as u8);
            hasher.write_u32(u32::from_be_bytes([0, red, green, blue]));
        }
        let mark = hasher.finish();
        match groups.iter_mut().find(|(same, _)| *same == mark) {
            Some((_, group)) => group.push(n),
            None => groups.push((mark, vec![n])),
        }
    }
    groups.into_iter().map(|(_, group)| group).collect()
}
