//! Small multiples: for each method a map of wrong decisions among neighboring numbers.

use glam::DVec2;
use speed_vs_accuracy::{FailureMap, METHODS, failure_map};

use super::chart::{Chart, Drawn, table};
use crate::pixels::Frame;
use crate::svg::{Anchor, Step, Svg, spot};

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
    let mut svg = CHART.sheet(40.0 + PITCH.y * METHODS.len().div_ceil(COLUMNS) as f64);
    svg.key("sphere wash", spot(4.0, 9.0), "hits");
    let words = "wrong decisions, and their number";
    svg.key("wrong solid", spot(66.0, 9.0), words);
    let mut rows = Vec::new();
    for (n, method) in METHODS.iter().enumerate() {
        let place = spot((n % COLUMNS) as f64, (n / COLUMNS) as f64);
        let map = failure_map(method, CELLS);
        let count = map.wrong.iter().filter(|wrong| **wrong).count();
        let corner = spot(4.0, 54.0) + PITCH * place;
        draw_map(&mut svg, corner, method.name, map, count);
        rows.push(vec![format!("`{}`", method.name), count.to_string()]);
    }
    let heads = ["method".to_owned(), format!("wrong of {}", CELLS * CELLS)];
    Drawn {
        panels: vec![svg.finish()],
        table: table(1, &heads, rows.into_iter()),
    }
}

/// Maps beside each other, and from one to the next.
const COLUMNS: usize = 2;
const PITCH: DVec2 = spot(200.0, 216.0);

/// The side of a map.
const SIDE: f64 = 190.0;

fn draw_map(svg: &mut Svg, corner: DVec2, method: &str, map: FailureMap, count: usize) {
    svg.small_label("ink", corner.down(-6.0), Anchor::Start, method);
    let idea = if count == 0 { "faint" } else { "wrong" };
    let right = corner + spot(SIDE, -6.0);
    svg.small_label(idea, right, Anchor::End, &count.to_string());
    let side = SIDE / CELLS as f64;
    let classes = [("sphere wash", map.hits), ("wrong solid", map.wrong)];
    Frame { corner, side }.map(svg, CELLS, &classes);
}
