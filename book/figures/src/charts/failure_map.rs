//! Small multiples: for each method a map of wrong decisions among neighboring numbers.

use std::fmt::Write;

use glam::DVec2;
use speed_vs_accuracy::{FailureMap, METHODS, Method, failure_map};

use super::chart::{Chart, Drawn, Layout};
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

/// The map of a method, and how many of its cells are wrong.
struct Judged {
    method: &'static str,
    map: FailureMap,
    count: usize,
}

fn draw() -> Drawn {
    let judge = |method: &Method| {
        let map = failure_map(method, CELLS);
        let count = map.wrong.iter().filter(|wrong| **wrong).count();
        let method = method.name;
        Judged { method, map, count }
    };
    let maps: Vec<Judged> = METHODS.iter().map(judge).collect();
    Drawn::new(table(&maps), |layout| panels(layout, &maps))
}

fn panels(layout: Layout, maps: &[Judged]) -> String {
    let columns = layout.choose(4, 2);
    let rows = maps.len().div_ceil(columns);
    let (pitch, side) = layout.choose(
        (DVec2::new(178.0, 198.0), 162.0),
        (DVec2::new(172.0, 212.0), 162.0),
    );
    let mut svg = CHART.sheet(layout, 34.0 + pitch.y * rows as f64);
    explain(&mut svg, layout);
    for (n, Judged { method, map, count }) in maps.iter().enumerate() {
        let place = DVec2::new((n % columns) as f64, (n / columns) as f64);
        let corner = layout.choose(DVec2::new(12.0, 58.0), DVec2::new(2.0, 74.0)) + pitch * place;
        let cell = side / CELLS as f64;
        let above = corner - DVec2::new(0.0, layout.choose(6.0, 20.0));
        svg.small_label("ink", above, Anchor::Start, method);
        let above = corner + DVec2::new(side, -6.0);
        let idea = if *count == 0 { "faint" } else { "wrong" };
        svg.small_label(idea, above, Anchor::End, &count.to_string());
        svg.group("pixels", |svg| {
            svg.cells("sphere wash", corner, cell, CELLS, &map.hits);
            svg.cells("wrong solid", corner, cell, CELLS, &map.wrong);
        });
        svg.rect("faint thin", corner, DVec2::splat(side));
    }
    svg.finish()
}

fn table(maps: &[Judged]) -> String {
    let mut table = format!("| method | wrong of {} |\n|---|---:|\n", CELLS * CELLS);
    for Judged { method, count, .. } in maps {
        let _ = writeln!(table, "| `{method}` | {count} |");
    }
    table
}

fn explain(svg: &mut Svg, layout: Layout) {
    let mut x = layout.choose(12.0, 2.0);
    for (class, words) in [
        ("sphere wash", "hits"),
        ("wrong solid", "wrong decisions, and their number"),
    ] {
        svg.rect(class, DVec2::new(x, 9.0), DVec2::splat(12.0));
        svg.small_label("ink", DVec2::new(x + 18.0, 20.0), Anchor::Start, words);
        x += 18.0 + width(words, SMALL) + 16.0;
    }
}
