//! How many pixels each method gets wrong, and what is the least that a scene
//! needs.
//!
//! `scenes.snap.csv` in book/notes/measured has a row for each scene and method:
//!
//! | column | |
//! |---|---|
//! | `scene` | the name of the scene |
//! | `precision`, `method` | who drew it |
//! | `pixels` | how many there are |
//! | `wrong` | how many are more than one level off, in some component, from the exact picture of the same precision |
//! | `off_by_one` | how many are one level off: the eye does not see them |
//!
//! `least.snap.csv` is what follows from that and from `timings.csv`: for each
//! `scene` and `precision` the `method` that takes the fewest nanoseconds on the
//! book's camera rays, `book_ns`, of those without a wrong pixel; empty if there
//! is none.

use std::fmt::Write;

use common::rtweekend::Picture;
use speed_vs_accuracy::{METHODS, Precision, SCENES, Scene};

use crate::accuracy::in_parallel;
use crate::timings::Timings;

/// The table of wrong pixels, in pictures `width` pixels wide.
pub fn table(width: u32) -> String {
    let tasks = SCENES
        .into_iter()
        .flat_map(|scene| Precision::ALL.map(|precision| (scene, precision)));
    "scene,precision,method,pixels,wrong,off_by_one\n".to_owned()
        + &in_parallel(tasks, |(scene, precision)| rows(scene, precision, width))
}

/// The table of the cheapest method without a wrong pixel, from the other one.
pub fn least(table: &str, timings: &Timings) -> String {
    let mut text = "scene,precision,method,book_ns\n".to_owned();
    for scene in SCENES {
        for precision in ["f64", "f32"] {
            let cheapest = table
                .lines()
                .filter_map(|line| match line.split(',').collect::<Vec<_>>()[..] {
                    [name, of, method, _, "0", _] if name == scene.name && of == precision => {
                        timings.find("method", method, "book")
                    }
                    _ => None,
                })
                .min_by(|one, other| one.median.total_cmp(&other.median));
            let found = cheapest.map_or(",".to_owned(), |row| {
                format!("{},{:.2}", row.name, row.median)
            });
            let _ = writeln!(text, "{},{precision},{found}", scene.name);
        }
    }
    text
}

fn rows(scene: Scene, precision: Precision, width: u32) -> String {
    let right = scene.right_picture(precision, width).rgb_with_threads(1);
    let mut text = String::new();
    for method in METHODS {
        if method.precision() == precision {
            let drawn: Picture = scene.picture(*method, width);
            let [wrong, off_by_one] = differences(&right, &drawn.rgb_with_threads(1));
            let _ = writeln!(
                text,
                "{},{},{},{},{wrong},{off_by_one}",
                scene.name,
                precision.name(),
                method.name,
                right.len() / 3,
            );
        }
    }
    text
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
