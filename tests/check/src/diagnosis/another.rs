//! A right picture of another scene: a change that was forgotten, or is still there.

use super::candidates::distance;
use super::scene::Scene;
use crate::reading::{Cause, Reading};
use crate::slips::PROBES;

impl Scene {
    /// The other scenes of this chapter that the picture shows, to within a level: the
    /// chapter's own first.
    pub(crate) fn others(&self, reading: &Reading) -> Vec<Self> {
        if reading.outside().is_some() {
            return Vec::new();
        }
        let probes = PROBES.iter().filter(|probe| probe.spheres.is_some());
        let scenes = [None].into_iter().chain(probes.map(|&probe| Some(probe)));
        scenes
            .filter(|probe| *probe != self.probe)
            .filter_map(|probe| Self::new(self.chapter, probe))
            .filter(|scene| scene.is_shown_by(reading))
            .collect()
    }

    fn is_shown_by(&self, reading: &Reading) -> bool {
        let output = self.program(&[]).run(reading.width);
        let near = |n: usize| {
            let expected = output.pixel(n as u32).map(|level| level as i16);
            distance(expected, reading.pixels[n]) <= 1
        };
        output.size() == (reading.width, reading.height) && (0..reading.pixels.len()).all(near)
    }

    /// Why a picture of `others`, scenes of this chapter, is not the right one.
    pub(crate) fn but_shown(&self, others: &[Self]) -> Cause {
        let own = self.chapter.name();
        let probes: Vec<&str> = others
            .iter()
            .filter_map(|scene| Some(scene.probe?.name))
            .collect();
        let (problem, fix) = match (self.probe, others[0].probe) {
            (Some(probe), None) => (
                format!(
                    "this is the picture of the chapter itself, {own}: the change for the probe {} is not in it",
                    probe.name
                ),
                format!(
                    "Change your program to\n  {}\nand then: {}",
                    self.change(probe.width).replace('\n', "\n  "),
                    self.command()
                ),
            ),
            (wanted, _) => (
                format!(
                    "this is the picture of the probe {}, not of {}",
                    probes.join(" or "),
                    wanted.map_or("the chapter itself", |wanted| wanted.name)
                ),
                format!(
                    "Is the change still in your program? As what it is, it is right: {}",
                    others[0].command()
                ),
            ),
        };
        Cause::new("another-scene", problem, fix)
    }
}
