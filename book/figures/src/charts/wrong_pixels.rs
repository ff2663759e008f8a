//! A heat map: wrong pixels, scene by scene and method by method.

use glam::DVec2;
use speed_vs_accuracy::Precision;

use super::chart::{Chart, Drawn, table};
use super::heat::cell;
use crate::records::{Timing, WrongPixels};
use crate::svg::{Anchor, Svg};
use crate::table::{Record, Table};
use crate::text::{SMALL, width};

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
    let names: Vec<String> = names.iter().map(|name| name.replace('_', " ")).collect();
    // A line of cells for each method, in the order of the scenes.
    let of = |(method, _): &Method| -> Vec<&WrongPixels> {
        cells.iter().filter(|cell| cell.method == *method).collect()
    };
    let lines: Vec<_> = methods.iter().map(of).collect();
    let heads = [vec!["wrong pixels".to_owned()], names.clone()].concat();
    let rows = lines.iter().map(|line| {
        let counts = line
            .iter()
            .map(|it| format!("{} of {}", it.wrong, it.pixels));
        let name = format!("`{}`", line[0].method);
        [name].into_iter().chain(counts).collect()
    });
    Ok(Drawn {
        table: table(1, &heads, rows),
        panels: vec![heat_map(&names, &lines)],
    })
}

/// Where the first line of cells is, the height of a cell, and from one line to the next:
/// between them stands the name of the method.
const TOP: f64 = 74.0;
const HIGH: f64 = 24.0;
const PITCH: f64 = 42.0;

fn heat_map(scenes: &[String], lines: &[Vec<&WrongPixels>]) -> String {
    let wide = 398.0 / scenes.len() as f64;
    let mut svg = CHART.sheet(TOP + PITCH * lines.len() as f64);
    let title = "pixels of 1000 that differ from the exact picture";
    svg.small_label("faint", DVec2::new(1.0, 16.0), Anchor::Start, title);
    for (scene, column) in scenes.iter().zip(0_u8..) {
        let half = 0.5 * width(scene, SMALL);
        let middle = (1.0 + wide * (f64::from(column) + 0.5)).min(400.0 - half);
        // On two lines in turn, since columns are narrow.
        let y = TOP - 24.0 - 15.0 * f64::from(column % 2);
        svg.small_label("ink", DVec2::new(middle, y), Anchor::Middle, scene);
    }
    let mut found = Vec::new();
    for (line, row) in lines.iter().zip(0_u8..) {
        let left = DVec2::new(1.0, TOP + PITCH * f64::from(row));
        let above = left - DVec2::new(0.0, 5.0);
        svg.small_label("ink", above, Anchor::Start, &line[0].method);
        draw_line(&mut svg, left, wide, line, &mut found);
    }
    svg.finish()
}

/// Draws the cells of a method, with a frame around the first in a precision that is right,
/// unless its scene is `found` already.
fn draw_line(
    svg: &mut Svg,
    left: DVec2,
    wide: f64,
    line: &[&WrongPixels],
    found: &mut Vec<(String, Precision)>,
) {
    for (shown, column) in line.iter().zip(0_u8..) {
        let corner = left + DVec2::new(wide * f64::from(column), 0.0);
        let size = DVec2::new(wide - 3.0, HIGH - 3.0);
        let wrong = shown.wrong as f64 / shown.pixels as f64;
        cell(svg, corner, size, wrong, &per_thousand(wrong));
        let least = (shown.scene.clone(), shown.precision);
        if shown.wrong == 0 && !found.contains(&least) {
            svg.rect("certain bold", corner, size);
            found.push(least);
        }
    }
}

fn per_thousand(part: f64) -> String {
    match 1000.0 * part {
        ..0.095 => "< 0.1".to_owned(),
        few @ ..9.95 => format!("{few:.1}"),
        many => format!("{many:.0}"),
    }
}
