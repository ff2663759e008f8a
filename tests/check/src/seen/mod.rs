//! What can be seen in a picture that no mistake explains.
//!
//! These are observations: each sentence is true of the pixels, and says nothing
//! about the code.

mod pixel;
mod tinted;
mod view;

use slips::{Chapter, Room};

use crate::reading::Reading;
use crate::scene::Scene;

use crate::bits::{distance, is_grain};
use view::View;

/// Compression and scaling change most pixels by no more than so many levels.
const LITTLE: u16 = 12;

/// So many pixels are two of JPEG's blocks of half colors.
const BLOCKS: usize = 32;

/// Where one pixel in so many is another, nearly all are the same.
const ODD: usize = 32;

/// What can be seen, the most telling first.
pub(crate) fn sights(scene: &Scene, reading: &Reading) -> Vec<String> {
    let right = scene.right(reading.width, reading.height);
    let view = View::new(scene, reading, &right);
    if view.wrong.is_empty() {
        return Vec::new();
    }
    let seen = match view.plain() {
        Some(plain) => vec![plain],
        None => [
            view.unscaled(),
            view.only_sky(),
            view.gray(),
            view.gamma(),
            view.where_it_differs(),
        ]
        .into_iter()
        .flatten()
        .chain(view.tints())
        .collect(),
    };
    seen.into_iter().chain(view.first_pixel()).collect()
}

/// Whether much is off, almost all of it by little, and not alike so far away as another block is.
pub(crate) fn is_blurred(scene: &Scene, reading: &Reading) -> bool {
    let right = Reading::of(&scene.right(reading.width, reading.height)).pixels;
    let off = |least: u16| {
        let pairs = right.iter().zip(&reading.pixels);
        pairs
            .filter(|(right, it)| distance(**right, **it) > least)
            .count()
    };
    let is_much = 4 * off(0) > right.len() && 32 * off(LITTLE) < right.len();
    is_much && is_grain(reading, &right, BLOCKS)
}

impl View<'_> {
    fn plain(&self) -> Option<String> {
        let first = self.found(0);
        let same = self.places.iter().filter(|n| self.found(**n) == first);
        let is_plain = ODD * (self.places.len() - same.count()) <= self.places.len();
        let all = match self.reading.is_plain() {
            true => "Every pixel",
            false => "Nearly every pixel",
        };
        // Numbers that were cut off may have been any.
        let is_cut = first.contains(&i16::MAX);
        (is_plain && !is_cut).then(|| match first {
            [0, 0, 0] => {
                format!("{all} is black: is a component NaN, or is no color ever set?")
            }
            color => format!("{all} has the same color, {color:?}."),
        })
    }

    fn only_sky(&self) -> Option<String> {
        if self.scene.chapter.room() != Room::One || self.scene.probe.is_some() {
            return None;
        }
        let (width, height) = (self.reading.width, self.reading.height);
        let sky = self
            .scene
            .of_chapter(Chapter::Gradient)
            .right(width, height);
        let (sky, _) = sky.rgb().as_chunks::<3>();
        let is_sky = |n: &u32| distance(sky[*n as usize].map(i16::from), self.found(*n)) <= 1;
        let is_all = self.places.iter().all(is_sky);
        is_all.then(|| "There is only sky: no sphere is to be seen.".to_owned())
    }

    fn unscaled(&self) -> Option<String> {
        let levels = self.reading.pixels.iter().flatten();
        let most = levels
            .copied()
            .max()
            .filter(|most| (0..=1).contains(most))?;
        Some(format!(
            "No level is above {most}: is each component multiplied by 255.999?"
        ))
    }

    /// Whether all that differs fills a box that is small beside the picture.
    fn is_in_a_box(&self) -> bool {
        let width = self.reading.width;
        let length = |all: &[u32]| {
            let [low, high] = [all.iter().min(), all.iter().max()].map(|n| n.copied().unwrap_or(0));
            (high - low + 1) as usize
        };
        let columns: Vec<u32> = self.wrong.iter().map(|n| n % width).collect();
        let rows: Vec<u32> = self.wrong.iter().map(|n| n / width).collect();
        // Of places that were looked at, half of those in the box.
        let boxed = length(&columns) * length(&rows) * self.places.len();
        let all = self.reading.pixels.len();
        4 * boxed < all * self.places.len() && 2 * self.wrong.len() * all > boxed
    }

    /// On the spheres, in the sky, or along the rim.
    fn where_it_differs(&self) -> Option<String> {
        let (spheres, sky): (Vec<u32>, Vec<u32>) =
            self.wrong.iter().partition(|&&n| self.is_hit(n));
        let share = self.wrong.len() as f64 / self.places.len() as f64;
        match (spheres.len(), sky.len()) {
            _ if self.scene.chapter.room() == Room::None => None,
            (0, _) if self.is_in_a_box() => Some(
                "All that is wrong lies in one place in the sky: is there another sphere?"
                    .to_owned(),
            ),
            (_, 0) => {
                Some("Only where spheres should be is anything wrong by more than a level.".to_owned())
            }
            (_, rim) if 8 * rim < self.wrong.len() && sky.iter().all(|&n| self.is_at_rim(n)) => Some(
                "Only where spheres should be and at their rim is anything wrong by more than a level. Several rays a pixel, and materials, come in later chapters.".to_owned(),
            ),
            (0, _) => Some(
                "Where spheres should be all is right; only beside them it is wrong.".to_owned(),
            ),
            _ if share < 0.03 && self.wrong.iter().all(|&n| self.is_at_rim(n)) => {
                Some("Only the rim of the spheres is wrong by more than a level.".to_owned())
            }
            _ => None,
        }
    }
}
