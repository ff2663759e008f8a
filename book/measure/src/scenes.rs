//! Image comparison: how many pixels each method gets wrong, and what is the least
//! that a scene needs.

use common::rtweekend::Picture;
use figures::records::{Least, Timing, WrongPixels};
use figures::table::Table;
use rayon::prelude::*;
use speed_vs_accuracy::{METHODS, Precision, SCENES, Scene};

/// The wrong pixels of all methods in all scenes, in pictures `width` pixels wide.
pub fn table(width: u32) -> Table<WrongPixels> {
    let rows = both_precisions()
        .into_par_iter()
        .flat_map_iter(|(scene, precision)| rows(scene, precision, width));
    rows.collect::<Vec<_>>().into()
}

/// The cheapest method without a wrong pixel, from what was measured.
pub fn least(pixels: &Table<WrongPixels>, timings: &Table<Timing>) -> Table<Least> {
    let row = |(scene, precision): (Scene, Precision)| {
        let is_right = |row: &&WrongPixels| {
            row.scene == scene.name && row.precision == precision && row.wrong == 0
        };
        let cheapest = pixels
            .rows
            .iter()
            .filter(is_right)
            .filter_map(|row| timings.find("method", &row.method, "book"))
            .min_by(|one, other| one.median_ns.total_cmp(&other.median_ns));
        Least {
            scene: scene.name.to_owned(),
            precision,
            method: cheapest.map(|timing| timing.name.clone()),
            book_ns: cheapest.map(|timing| timing.median_ns),
        }
    };
    let rows = both_precisions().into_iter().map(row);
    rows.collect::<Vec<_>>().into()
}

fn both_precisions() -> Vec<(Scene, Precision)> {
    let both = |scene| Precision::ALL.map(|precision| (scene, precision));
    SCENES.into_iter().flat_map(both).collect()
}

fn rows(scene: Scene, precision: Precision, width: u32) -> impl Iterator<Item = WrongPixels> {
    let right = scene.right_picture(precision, width).rgb_with_threads(1);
    let methods = METHODS.iter();
    methods
        .filter(move |method| method.precision() == precision)
        .map(move |method| {
            let drawn: Picture = scene.picture(*method, width);
            let [wrong, off_by_one] = differences(&right, &drawn.rgb_with_threads(1));
            WrongPixels {
                scene: scene.name.to_owned(),
                precision,
                method: method.name.to_owned(),
                pixels: right.len() / 3,
                wrong,
                off_by_one,
            }
        })
}

/// How many pixels have a component that is more than a level off, and how many
/// one that is a level off.
fn differences(right: &[u8], drawn: &[u8]) -> [usize; 2] {
    let farthest = |(right, drawn): (&[u8; 3], &[u8; 3])| {
        let levels = right
            .iter()
            .zip(drawn)
            .map(|(one, other)| one.abs_diff(*other));
        levels.max().unwrap_or(0)
    };
    let pixels = right.as_chunks().0.iter().zip(drawn.as_chunks().0);
    let off: Vec<u8> = pixels.map(farthest).collect();
    let count = |wanted: fn(&u8) -> bool| off.iter().copied().filter(wanted).count();
    [count(|&levels| levels > 1), count(|&levels| levels == 1)]
}
