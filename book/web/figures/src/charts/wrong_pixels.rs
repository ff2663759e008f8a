//! A heat map: wrong pixels, scene by scene and method by method.

use std::iter;

use glam::DVec2;
use speed_vs_accuracy::{METHODS, Method, Precision};

use super::chart::{Chart, DrawnChart, table};
use crate::records::{Timing, WrongPixels};
use crate::svg::{Anchor, Shift, Svg, spot};
use crate::table::{Record, Table};
use crate::text::{SMALL, width};

/// The heat map of wrong pixels: a cell for each method in each scene.
pub(super) const CHART: Chart = Chart {
    name: "scenes",
    title: "Wrong pixels, scene by scene and method by method",
    description: "A table with a row for each method and a column for each scene. A cell says how \
        many pixels of a thousand differ from the exact picture, and is the darker the more they \
        are. A cell without a wrong pixel has a tick. In each column two cells have a frame, one in \
        f64 and one in f32: the method that is the quickest on that scene’s own rays, of those \
        without a wrong pixel.",
    caption: "Pixels of a thousand that differ from the exact picture. Framed: of the methods without \
        a wrong pixel the one that is the quickest on that scene’s own rays, in f64 and in f32.",
    choices: &[],
    files: &[WrongPixels::FILE, Timing::FILE],
    draw: |files| draw(files[0], files[1]),
};

fn draw(scenes: &str, timings: &str) -> Result<DrawnChart, String> {
    let cells = Table::<WrongPixels>::read(scenes)?.rows;
    let timings = Table::<Timing>::read(timings)?;
    let of = |name: &str| cells.iter().filter(|cell| cell.method == name).collect();
    let mut lines: Vec<Vec<&WrongPixels>> = METHODS.iter().map(|it| of(it.name)).collect();
    lines.retain(|line| !line.is_empty());
    let scenes: Vec<&str> = lines[0].iter().map(|cell| &cell.scene[..]).collect();
    let is_whole = |line: &Vec<&WrongPixels>| line.iter().map(|cell| &cell.scene).eq(&scenes);
    if !lines.iter().all(is_whole) {
        return Err(format!("{}: a method lacks a scene", WrongPixels::FILE));
    }
    let frames: Vec<Frames> = scenes
        .iter()
        .map(|scene| Precision::ALL.map(|precision| least(scene, precision, &cells, &timings)))
        .collect();
    let heads: Vec<String> = iter::once("wrong pixels")
        .chain(scenes.iter().copied())
        .map(str::to_owned)
        .collect();
    let rows = lines.iter().map(|line| {
        let counts = line.iter().zip(&frames).map(|(it, frames)| {
            let frame = if is_framed(frames, it) {
                " (least)"
            } else {
                ""
            };
            format!("{} of {}{frame}", it.wrong, it.pixels)
        });
        let name = format!("`{}`", line[0].method);
        iter::once(name).chain(counts).collect()
    });
    Ok(DrawnChart {
        table: table(1, &heads, rows),
        panels: vec![heat_map(&scenes, &lines, &frames)],
    })
}

/// The framed methods of a scene, in `f64` and in `f32`.
type Frames = [Option<Method>; 2];

fn is_framed(frames: &Frames, cell: &WrongPixels) -> bool {
    frames
        .iter()
        .flatten()
        .any(|method| method.name == cell.method)
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

/// The top of the first line of cells, the height of a cell, and the distance from one line to the
/// next; a method's name stands between lines.
const TOP: f64 = 74.0;
const HIGH: f64 = 24.0;
const PITCH: f64 = 42.0;

fn heat_map(scenes: &[&str], lines: &[Vec<&WrongPixels>], frames: &[Frames]) -> String {
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
    for (line, row) in lines.iter().zip(0_u8..) {
        let left = spot(1.0, TOP + PITCH * f64::from(row));
        svg.small_label("ink", left.down(-5.0), Anchor::Start, &line[0].method);
        for ((cell, column), frames) in line.iter().zip(0_u8..).zip(frames) {
            let corner = left.right(wide * f64::from(column));
            let size = spot(wide - 3.0, HIGH - 3.0);
            draw_cell(&mut svg, corner, size, cell);
            if is_framed(frames, cell) {
                svg.rect("certain bold", corner, size);
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
