//! A table of marks: wrong pixels, scene by scene and method by method.

use std::iter;

use speed_vs_accuracy::{METHODS, Method, Precision};

use super::chart::table;
use crate::records::{Timing, WrongPixels};
use crate::table::{Record, Table};

/// Writes a Markdown table with a row for each method and a column for each scene, from the texts of
/// the files of [`WrongPixels`] and [`Timing`]. A cell says how many pixels of a thousand are wrong,
/// or `✓` if none is, or `★` for the method that [`least`] chooses.
///
/// # Errors
/// A message that names the file, and the line that is wrong or the method that lacks a scene.
pub fn scenes_table(scenes: &str, timings: &str) -> Result<String, String> {
    let cells = Table::<WrongPixels>::read(scenes)?.rows;
    let timings = Table::<Timing>::read(timings)?;
    let of_method = |name: &'static str| cells.iter().filter(move |cell| cell.method == name);
    let of_first = of_method(METHODS[0].name);
    let scenes: Vec<&str> = of_first.map(|cell| &cell.scene[..]).collect();
    let is_whole = |method: &&Method| of_method(method.name).map(|cell| &cell.scene).eq(&scenes);
    if let Some(method) = METHODS.iter().find(|method| !is_whole(method)) {
        return Err(format!(
            "{}: {} lacks a scene",
            WrongPixels::FILE,
            method.name
        ));
    }
    let heads = iter::once("wrong pixels").chain(scenes.iter().copied());
    let rows = METHODS.iter().map(|method| {
        let marks = of_method(method.name).map(|cell| {
            let least = least(&cell.scene, cell.precision, &cells, &timings);
            let is_least = least.is_some_and(|least| least.name == method.name);
            if is_least {
                "★".to_owned()
            } else {
                of_a_thousand(cell)
            }
        });
        iter::once(format!("`{}`", method.name))
            .chain(marks)
            .collect()
    });
    Ok(table(
        1,
        &heads.map(str::to_owned).collect::<Vec<_>>(),
        rows,
    ))
}

/// Writes how many pixels of a thousand are wrong.
fn of_a_thousand(cell: &WrongPixels) -> String {
    match 1000.0 * cell.wrong as f64 / cell.pixels as f64 {
        0.0 => "✓".to_owned(),
        ..0.095 => "< 0.1".to_owned(),
        wrong @ ..9.95 => format!("{wrong:.1}"),
        wrong => format!("{wrong:.0}"),
    }
}

/// Returns the method that is the quickest on the rays of `scene`, of those in this precision that
/// draw no pixel of it wrong, as [`Table::quickest`] chooses; `None` if there is none.
pub fn least(
    scene: &str,
    precision: Precision,
    cells: &[WrongPixels],
    timings: &Table<Timing>,
) -> Option<Method> {
    timings.quickest(precision, scene, |method| {
        let is_right = |cell: &WrongPixels| cell.method == method.name && cell.wrong == 0;
        cells
            .iter()
            .any(|cell| cell.scene == scene && is_right(cell))
    })
}
