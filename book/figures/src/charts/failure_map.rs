//! Where each method decides wrongly: a map of neighboring numbers.

use std::fmt::Write;

use glam::DVec2;
use speed_vs_accuracy::{METHODS, failure_map};

use super::chart::{Chart, Drawn, WIDTH};
use crate::svg::{Anchor, SMALL, Svg, width};

/// The map, which is computed by the methods when it is drawn.
pub(super) const CHART: Chart = Chart {
    name: "failure_map",
    title: "Where each method decides wrongly",
    description: "A small square for each method. Each is divided into cells, one for each pair of \
        neighboring numbers, and a straight border parts the hits at the left from the misses at the right. \
        Cells with a wrong decision are marked. With the plain methods they are strewn along the \
        border in a broad band, with the better ones in a narrow band, and with the exact and the \
        certified ones there are none.",
    caption: "Each cell is a ray: from one cell to the next, x or y of its origin changes by the \
        smallest step that there is. Tinted cells are hits. Where a cell is marked the method \
        takes a hit for a miss, or a miss for a hit. Methods in f32 take the smallest steps of f32.",
    files: &[],
    draw: |_| Ok(draw()),
};

/// Cells in a row.
const CELLS: usize = 48;

fn draw() -> Drawn {
    const COLUMNS: usize = 4;
    let rows = METHODS.len().div_ceil(COLUMNS);
    let (pitch, side) = (DVec2::new(178.0, 198.0), 162.0);
    let mut svg = CHART.sheet(34.0 + pitch.y * rows as f64);
    explain(&mut svg);
    let mut table = format!("| method | wrong of {} |\n|---|---:|\n", CELLS * CELLS);
    for (n, method) in METHODS.iter().enumerate() {
        let map = failure_map(method, CELLS);
        let count = map.wrong.iter().filter(|wrong| **wrong).count();
        let place = DVec2::new((n % COLUMNS) as f64, (n / COLUMNS) as f64);
        let corner = DVec2::new(12.0, 58.0) + pitch * place;
        let cell = side / CELLS as f64;
        let above = corner - DVec2::new(0.0, 6.0);
        svg.small_label("ink", above, Anchor::Start, method.name);
        let above = above + DVec2::new(side, 0.0);
        let idea = if count == 0 { "faint" } else { "wrong" };
        svg.small_label(idea, above, Anchor::End, &count.to_string());
        svg.group("pixels", |svg| {
            svg.cells("sphere wash", corner, cell, CELLS, &map.hits);
            svg.cells("wrong solid", corner, cell, CELLS, &map.wrong);
        });
        svg.rect("faint thin", corner, DVec2::splat(side));
        let _ = writeln!(table, "| `{}` | {count} |", method.name);
    }
    Drawn {
        svg: svg.finish(),
        table,
    }
}

fn explain(svg: &mut Svg) {
    let mut x = 12.0;
    for (class, words) in [
        ("sphere wash", "hits"),
        ("wrong solid", "wrong decisions, and their number"),
    ] {
        svg.rect(class, DVec2::new(x, 9.0), DVec2::splat(12.0));
        svg.small_label("ink", DVec2::new(x + 18.0, 20.0), Anchor::Start, words);
        x += 18.0 + width(words, SMALL) + 16.0;
    }
    debug_assert!(x < WIDTH);
}
