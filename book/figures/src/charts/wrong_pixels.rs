//! A heat map: wrong pixels, scene by scene and method by method.

use std::fmt::Write;

use glam::DVec2;
use speed_vs_accuracy::Precision;

use super::chart::{Chart, Drawn, Layout};
use super::heat::cell;
use crate::records::{Timing, WrongPixels};
use crate::svg::{Anchor, SMALL, width};
use crate::table::{Record, Table};

/// A heat map.
pub(super) const CHART: Chart = Chart {
    name: "scenes",
    title: "Wrong pixels, scene by scene and method by method",
    description: "A table with a row for each method, the cheapest at the top, and a column for each \
        scene. A cell says how many pixels of a thousand differ from the exact picture, and is \
        the darker the more they are. A cell without a wrong pixel has a tick. In each column \
        the first of them in f64 has a frame, and the first in f32: the least that this scene \
        needs.",
    caption: "Pixels of a thousand that differ from the exact picture. Methods are in order of \
        the instructions that they take for a ray of the book. Framed: the first one without a wrong \
        pixel, in f32 and in f64, which is the least that this scene needs.",
    files: &[WrongPixels::FILE, Timing::FILE],
    draw: |files| draw(files[0], files[1]),
};

/// A method, and what it computes with.
type Method = (String, Precision);

fn draw(scenes: &str, timings: &str) -> Result<Drawn, String> {
    let cells = Table::<WrongPixels>::read(scenes)?.rows;
    let timings = Table::<Timing>::read(timings)?;
    let (mut names, mut methods): (Vec<String>, Vec<Method>) = (Vec::new(), Vec::new());
    for row in &cells {
        let method = (row.method.clone(), row.precision);
        if !names.contains(&row.scene) {
            names.push(row.scene.clone());
        }
        if !methods.contains(&method) {
            methods.push(method);
        }
    }
    let time = |(method, _): &Method| {
        let time = timings.find("method", method, "book");
        time.and_then(|time| time.instructions)
            .unwrap_or(f64::INFINITY)
    };
    methods.sort_by(|one, other| time(one).total_cmp(&time(other)));
    Ok(Drawn::new(table(&cells, &names, &methods), |layout| {
        heat_map(layout, &cells, &names, &methods)
    }))
}

fn find<'a>(cells: &'a [WrongPixels], scene: &str, method: &str) -> Option<&'a WrongPixels> {
    let is_wanted = |cell: &&WrongPixels| cell.scene == scene && cell.method == method;
    cells.iter().find(is_wanted)
}

fn heat_map(
    layout: Layout,
    cells: &[WrongPixels],
    scenes: &[String],
    methods: &[Method],
) -> String {
    let (top, high) = (62.0, 24.0);
    // Names stand before their row, or where that takes too much room above it.
    let (left, right, pitch) = layout.choose((166.0, 12.0, high), (1.0, 0.0, high + 18.0));
    let wide = (layout.width() - left - right) / scenes.len() as f64;
    let mut svg = CHART.sheet(layout, top + pitch * methods.len() as f64 + 12.0);
    let title = "pixels of 1000 that differ from the exact picture";
    svg.small_label("faint", DVec2::new(12.0, 20.0), Anchor::Start, title);
    for (column, scene) in scenes.iter().enumerate() {
        let x = left + wide * column as f64;
        let words = scene.replace('_', " ");
        let half = 0.5 * width(&words, SMALL);
        let middle = (x + 0.5 * wide).min(layout.width() - half);
        // Narrow columns have their names on two lines in turn.
        let up = layout.choose(0.0, 15.0 * (column % 2) as f64);
        let at = DVec2::new(middle, top - 8.0 - up);
        svg.small_label("ink", at, Anchor::Middle, &words);
        let mut found = Vec::new();
        for (row, (method, precision)) in methods.iter().enumerate() {
            let corner = DVec2::new(x, top + pitch * (row + 1) as f64 - high);
            let Some(shown) = find(cells, scene, method) else {
                continue;
            };
            let size = DVec2::new(wide - 3.0, high - 3.0);
            let wrong = shown.wrong as f64 / shown.pixels as f64;
            cell(&mut svg, corner, size, wrong, &per_thousand(wrong));
            if shown.wrong == 0 && !found.contains(precision) {
                svg.rect("certain bold", corner, size);
                found.push(*precision);
            }
        }
    }
    for (row, (method, _)) in methods.iter().enumerate() {
        let below = top + pitch * (row + 1) as f64;
        let (at, anchor) = layout.choose(
            (DVec2::new(left - 10.0, below - 9.0), Anchor::End),
            (DVec2::new(left, below - high - 5.0), Anchor::Start),
        );
        svg.small_label("ink", at, anchor, method);
    }
    svg.finish()
}

fn per_thousand(part: f64) -> String {
    match 1000.0 * part {
        ..0.095 => "< 0.1".to_owned(),
        few @ ..9.95 => format!("{few:.1}"),
        many => format!("{many:.0}"),
    }
}

fn table(cells: &[WrongPixels], scenes: &[String], methods: &[Method]) -> String {
    let mut table = "| wrong pixels |".to_owned();
    for scene in scenes {
        let _ = write!(table, " {} |", scene.replace('_', " "));
    }
    table += "\n|---|";
    table += &"---:|".repeat(scenes.len());
    table.push('\n');
    for (method, _) in methods {
        let _ = write!(table, "| `{method}` |");
        for scene in scenes {
            let _ = match find(cells, scene, method) {
                Some(cell) => write!(table, " {} of {} |", cell.wrong, cell.pixels),
                None => write!(table, " |"),
            };
        }
        table.push('\n');
    }
    table
}
