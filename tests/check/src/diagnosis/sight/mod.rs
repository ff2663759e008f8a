//! What can be seen in a picture that no mistake explains.
//!
//! These are observations: each sentence is true of the pixels, and says nothing
//! about the code.

mod disc;
mod placed;
mod tinted;

use common::rtweekend::{Camera, Picture};

use super::Scene;
use super::candidates::{distance, spread};
use crate::chapter::Chapter;
use crate::reading::Reading;
use crate::slips::{PROBES, Program};

/// How many pixels are looked at where all would be too many.
const LOOK: u32 = 5000;

/// What can be seen, the most telling first.
pub(super) fn sights(scene: &Scene, reading: &Reading, right: &Picture) -> Vec<String> {
    let view = View::new(scene, reading, right);
    if view.wrong.is_empty() {
        return Vec::new();
    }
    if let Some(another) = view.another_picture() {
        return vec![another];
    }
    if let Some(plain) = view.plain() {
        return vec![plain];
    }
    [
        view.turned(),
        view.channels(),
        view.moved(),
        view.zoomed(),
        view.disc(),
        view.gray(),
        view.where_it_differs(),
        view.sky(),
        view.power(),
    ]
    .into_iter()
    .flatten()
    .chain(view.tints())
    .collect()
}

/// A reader's picture beside the right one.
struct View<'a> {
    scene: &'a Scene,
    reading: &'a Reading,
    right: &'a Picture,
    /// Pixels to look at.
    places: Vec<u32>,
    /// Those of them that are more than one level off.
    wrong: Vec<u32>,
}

impl<'a> View<'a> {
    fn new(scene: &'a Scene, reading: &'a Reading, right: &'a Picture) -> Self {
        let places: Vec<u32> = spread(LOOK, reading.pixels.len() as u32).collect();
        let mut view = Self {
            scene,
            reading,
            right,
            places: Vec::new(),
            wrong: Vec::new(),
        };
        let is_wrong = |n: &u32| distance(view.expected(*n), view.found(*n)) > 1;
        view.wrong = places.iter().copied().filter(is_wrong).collect();
        view.places = places;
        view
    }
}

impl View<'_> {
    fn found(&self, n: u32) -> [i16; 3] {
        self.reading.pixels[n as usize]
    }

    fn expected(&self, n: u32) -> [i16; 3] {
        let (right, _) = self.right.rgb().as_chunks::<3>();
        right[n as usize].map(i16::from)
    }

    /// Whether the reader's pixels are within a level of these, but for one in
    /// a hundred: edges may differ.
    fn shows(&self, expected: impl Fn(u32) -> [i16; 3]) -> bool {
        let off = |n: &&u32| distance(expected(**n), self.found(**n)) > 1;
        100 * self.places.iter().filter(off).count() <= self.places.len()
    }

    /// The right picture of another chapter, of another scene.
    fn another_picture(&self) -> Option<String> {
        let (width, height) = (self.reading.width, self.reading.height);
        let is = |scene: Scene| {
            let program = scene.shaped(width, height).program(&[]);
            let camera = program.camera(width);
            // All pixels, because a small sphere may be all there is.
            let near = |&n: &u32| distance(color(&program, &camera, n), self.found(n)) <= 1;
            self.places.iter().all(near)
        };
        let name = self.scene.chapter.name();
        if self.scene.probe.is_some() && Scene::new(self.scene.chapter, None).is_some_and(is) {
            return Some(format!(
                "It is the book's picture of {name}, without the probe's changes."
            ));
        }
        for probe in PROBES.into_iter().filter(|probe| probe.spheres.is_some()) {
            let same = self
                .scene
                .probe
                .is_some_and(|asked| asked.name == probe.name);
            let scene = Scene::new(self.scene.chapter, Some(probe)).filter(|_| !same);
            if scene.is_some_and(is) {
                let probe = probe.name;
                return Some(format!(
                    "It is the picture of the probe {probe}: check {name} --probe {probe}."
                ));
            }
        }
        let mut others = Chapter::OF_THE_BOOK
            .into_iter()
            .filter(|&other| other != self.scene.chapter);
        let other = others.find(|&other| Scene::new(other, None).is_some_and(is))?;
        Some(format!(
            "It is the right picture of the chapter {}.",
            other.name()
        ))
    }

    fn plain(&self) -> Option<String> {
        let first = self.found(0);
        let all_same = self.reading.pixels.iter().all(|&pixel| pixel == first);
        all_same.then(|| format!("Every pixel has the same color, {first:?}."))
    }

    /// On the spheres, in the sky, or along the rim.
    fn where_it_differs(&self) -> Option<String> {
        let (spheres, sky): (Vec<u32>, Vec<u32>) =
            self.wrong.iter().partition(|&&n| self.is_hit(n));
        let share = self.wrong.len() as f64 / self.places.len() as f64;
        match (spheres.len(), sky.len()) {
            _ if self.scene.chapter <= Chapter::Gradient => None,
            (_, 0) => Some("Only what is hit is wrong; the sky is right.".to_owned()),
            (0, _) => Some("Only the sky is wrong; what is hit is right.".to_owned()),
            _ if share < 0.03 && self.wrong.iter().all(|&n| self.is_at_rim(n)) => {
                Some("Only the rim of what is hit is wrong.".to_owned())
            }
            _ => None,
        }
    }

    fn program(&self) -> Program {
        self.scene
            .shaped(self.reading.width, self.reading.height)
            .program(&[])
    }

    fn is_hit(&self, n: u32) -> bool {
        let program = self.program();
        let camera = program.camera(self.reading.width);
        let ray = camera.ray(n % self.reading.width, n / self.reading.width);
        (program.search)(&program, &ray).is_some()
    }

    /// Whether a neighbor is hit and this pixel is not, or the other way round.
    fn is_at_rim(&self, n: u32) -> bool {
        let width = self.reading.width;
        let neighbors = [
            n.checked_sub(1),
            n.checked_add(1),
            n.checked_sub(width),
            n.checked_add(width),
        ];
        let total = self.reading.pixels.len() as u32;
        neighbors
            .into_iter()
            .flatten()
            .any(|neighbor| neighbor < total && self.is_hit(neighbor) != self.is_hit(n))
    }
}

fn color(program: &Program, camera: &Camera, n: u32) -> [i16; 3] {
    let (i, j) = (program.order)(n, camera.image_width, camera.image_height);
    let color = (program.color)(program, camera, i, j).to_array();
    color.map(|component| (program.level)(component).clamp(0, 255) as i16)
}
