//! The folder with the chart and the pictures, replaced as a whole.

use std::error::Error;
use std::path::{Path, PathBuf};

use check::png;
use common::rtweekend::*;
use figures::{Point, scene_chart, standalone};
use speed_vs_accuracy::{Precision, Scene};

use crate::draw;
use crate::files;
use measure::needs::{Found, Row};

/// Where the files of a scene go if no other folder is named.
pub(super) fn usual(scene: &Scene) -> Result<PathBuf, Box<dyn Error>> {
    let workspace = draw::workspace()
        .map_err(|error| format!("{error}\nOr name a folder for the files: --output DIR"))?;
    Ok(workspace.join("target").join("needs").join(&scene.name))
}

/// Refuses now what [`write`] would refuse in the end: until then much is drawn.
pub(super) fn check(folder: &Path) -> Result<(), Box<dyn Error>> {
    files::refuse_strangers(folder, KIND)
}

/// Replaces `folder` by one with the chart, the right picture, and the wrong ones.
/// Returns their names.
pub(super) fn write(
    folder: &Path,
    scene: &Scene,
    right: &Picture,
    found: &[Found],
) -> Result<Vec<String>, Box<dyn Error>> {
    let chart = standalone(&scene_chart(&scene.name, &points(found))).into_bytes();
    let mut files = vec![
        ("chart.svg".to_owned(), chart),
        ("right.png".to_owned(), png::encode(right)),
    ];
    for found in found {
        let wrong = found.rows.iter().filter(|row| row.view.wrong > 0);
        files.extend(wrong.map(|Row { view, .. }| {
            let name = format!("{}.png", view.method.name);
            (name, png::encode(&view.picture))
        }));
    }
    files::fill(folder, KIND, &files)?;
    Ok(files.into_iter().map(|(name, _)| name).collect())
}

/// What the folder is called where another one is refused.
const KIND: &str = "report on a scene";

/// The methods that hit anything rightly.
fn points(found: &[Found]) -> Vec<Point> {
    let all = found.iter().flat_map(|found| &found.rows);
    let point = |row: &Row| {
        let precision = row.view.method.precision();
        Some(Point {
            method: row.view.method.name.to_owned(),
            precision,
            ns: row.ns,
            digits: digits(row.view.off?.radii, precision),
            is_wrong: row.view.wrong > 0,
            in_lanes: false,
        })
    };
    all.filter_map(point).collect()
}

/// How many decimal digits an error of so many radii leaves: no more than there are.
fn digits(radii: f64, precision: Precision) -> f64 {
    let least = 0.5 * precision.epsilon();
    (-radii.max(least).log10()).max(0.0)
}
