//! A right picture of another scene: a change that was forgotten, or is still there, or
//! another chapter.

use super::candidates::{distance, spread};
use super::scene::Scene;
use super::search::Search;
use crate::reading::{Cause, Reading};
use slips::Chapter;
use slips::{Edition, PROBES};

/// How many pixels a glance is.
const GLANCE: u32 = 64;

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
        self.by_editions(reading.width, reading.height)
            .any(|scene| {
                !scene.has_another_shape()
                    && scene.shows(reading, 0..reading.pixels.len() as u32, 1)
            })
    }

    /// Whether a glance at the picture does not exclude that it is the right one of this
    /// scene, to within so many levels.
    pub(crate) fn may_be_shown_by(&self, reading: &Reading, tolerance: u8) -> bool {
        self.shows(
            reading,
            spread(GLANCE, reading.pixels.len() as u32),
            tolerance,
        )
    }

    fn shows(&self, reading: &Reading, mut places: impl Iterator<Item = u32>, levels: u8) -> bool {
        let output = self.program(&[]).run(reading.width);
        output.size() == (reading.width, reading.height)
            && places.all(|n| {
                let expected = output.pixel(n).map(|level| level as i16);
                distance(expected, reading.pixels[n as usize]) <= levels.into()
            })
    }

    /// The scene of another chapter of which it is the right picture, or one that is
    /// right but for something that is no mistake.
    pub(crate) fn of_another_chapter(&self, reading: &Reading) -> Option<Self> {
        let others = Chapter::OF_THE_BOOK
            .into_iter()
            .filter(|&other| other != self.chapter);
        let others = others.map(|chapter| self.of_chapter(chapter));
        let exact = |scene: &Self| {
            let mut editions = scene.by_editions(reading.width, reading.height);
            editions.find(|scene| scene.shows(reading, 0..reading.pixels.len() as u32, 0))
        };
        let nearly = |scene: &Self| {
            let search = Search::new(scene, reading);
            let near = search.near().or_else(|| search.near_in_colors());
            near.map(|near| near.scene)
        };
        let all: Vec<Self> = others.collect();
        all.iter()
            .find_map(exact)
            .or_else(|| all.iter().find_map(nearly))
    }

    /// Why a picture of `others`, scenes of this chapter, is not the right one.
    pub(crate) fn but_shown(&self, others: &[Self]) -> Cause {
        let own = self.chapter.name();
        let probes: Vec<&str> = others
            .iter()
            .filter_map(|scene| Some(scene.probe?.name))
            .collect();
        if others[0].chapter != self.chapter {
            let other = others[0];
            let by = match other.edition {
                Edition::V4 => String::new(),
                edition => format!(", by {edition}"),
            };
            return Cause::new(
                "another-chapter",
                format!(
                    "this is a picture of the chapter {}{by}, not of {own}",
                    other.chapter.name()
                ),
                format!("Look at it as what it is: {}", other.command()),
            );
        }
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
