//! A heat map: wrong pixels, scene by scene and method by method.

use std::iter;

use glam::DVec2;

use super::chart::{Chart, DrawnChart, table};
use crate::records::{Timing, WrongPixels};
use crate::svg::{Anchor, Shift, Svg, spot};
use crate::table::{Record, Table};
use crate::text::{SMALL, width};

/// The heat map of wrong pixels: a cell for each method in each scene.
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
    choices: &[],
    files: &[WrongPixels::FILE, Timing::FILE],
    draw: |files| draw(files[0], files[1]),
};

fn draw(scenes: &str, timings: &str) -> Result<DrawnChart, String> {
    let mut cells = Table::<WrongPixels>::read(scenes)?.rows;
    let timings = Table::<Timing>::read(timings)?;
    let instructions = |cell: &WrongPixels| {
        let time = timings.find("method", &cell.method, "book");
        time.and_then(|time| time.instructions)
            .unwrap_or(f64::INFINITY)
    };
    cells.sort_by(|one, other| instructions(one).total_cmp(&instructions(other)));
    // A line of cells for each method, in the order of the scenes.
    let lines = cells.chunk_by(|one, other| one.method == other.method);
    let lines: Vec<&[WrongPixels]> = lines.collect();
    let scenes = lines[0].iter().map(|cell| cell.scene.replace('_', " "));
    let heads: Vec<String> = iter::once("wrong pixels".to_owned())
        .chain(scenes)
        .collect();
    let rows = lines.iter().map(|line| {
        let counts = line
            .iter()
            .map(|it| format!("{} of {}", it.wrong, it.pixels));
        let name = format!("`{}`", line[0].method);
        iter::once(name).chain(counts).collect()
    });
    Ok(DrawnChart {
        table: table(1, &heads, rows),
        panels: vec![heat_map(&heads[1..], &lines)],
    })
}

/// The top of the first line of cells, the height of a cell, and the distance from one line to the
/// next; a method's name stands between lines.
const TOP: f64 = 74.0;
const HIGH: f64 = 24.0;
const PITCH: f64 = 42.0;

fn heat_map(scenes: &[String], lines: &[&[WrongPixels]]) -> String {
    let wide = 398.0 / scenes.len() as f64;
    let mut svg = CHART.sheet(TOP + PITCH * lines.len() as f64);
    let title = "pixels of 1000 that differ from the exact picture";
    svg.small_label("faint", spot(1.0, 16.0), Anchor::Start, title);
    for (scene, column) in scenes.iter().zip(0_u8..) {
        let half = 0.5 * width(scene, SMALL);
        let middle = (1.0 + wide * (f64::from(column) + 0.5)).min(400.0 - half);
        // On two lines in turn, since columns are narrow.
        let y = TOP - 24.0 - 15.0 * f64::from(column % 2);
        svg.small_label("ink", spot(middle, y), Anchor::Middle, scene);
    }
    let mut found = Vec::new();
    for (line, row) in lines.iter().zip(0_u8..) {
        let left = spot(1.0, TOP + PITCH * f64::from(row));
        svg.small_label("ink", left.down(-5.0), Anchor::Start, &line[0].method);
        for (cell, column) in line.iter().zip(0_u8..) {
            let corner = left.right(wide * f64::from(column));
            let size = spot(wide - 3.0, HIGH - 3.0);
            draw_cell(&mut svg, corner, size, cell);
            let least = (&cell.scene, cell.precision);
            if cell.wrong == 0 && !found.contains(&least) {
                svg.rect("certain bold", corner, size);
                found.push(least);
            }
        }
    }
    svg.finish()
}

/// Draws a cell that says how many of a thousand pixels are wrong, in a depth of color that grows
/// with their number.
fn draw_cell(svg: &mut Svg, corner: DVec2, size: DVec2, cell: &WrongPixels) {
    let wrong = 1000.0 * cell.wrong as f64 / cell.pixels as f64;
    let (depth, idea, words) = match wrong {
        0.0 => (0, "ink", "✓".to_owned()),
        ..0.095 => (1, "ink", "< 0.1".to_owned()),
        ..9.95 => (1, "ink", format!("{wrong:.1}")),
        ..20.0 => (2, "ink", format!("{wrong:.0}")),
        ..100.0 => (4, "on-heat", format!("{wrong:.0}")),
        _ => (5, "on-heat", format!("{wrong:.0}")),
    };
    svg.rect(&format!("heat depth-{depth}"), corner, size);
    let middle = (corner + 0.5 * size).down(4.5);
    // No halo on a colored ground.
    svg.group("bare", |svg| {
        svg.small_label(idea, middle, Anchor::Middle, &words);
    });
}
