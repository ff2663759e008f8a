//! Where each method decides wrongly: a map of neighboring numbers.

use std::fmt::Write;

use common::rtweekend::*;
use glam::DVec2;
use speed_vs_accuracy::{Case, METHODS, Precision};

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
const CELLS: i32 = 48;

/// Decisions, cell by cell.
type Map = Vec<bool>;

fn draw() -> Drawn {
    const COLUMNS: usize = 4;
    let rows = METHODS.len().div_ceil(COLUMNS);
    let (pitch, side) = (DVec2::new(178.0, 198.0), 162.0);
    let mut svg = CHART.sheet(34.0 + pitch.y * rows as f64);
    explain(&mut svg);
    let mut table = format!("| method | wrong of {} |\n|---|---:|\n", CELLS * CELLS);
    let truths = [Precision::Double, Precision::Single]
        .map(|precision| (precision, map("exact", precision)));
    for (n, method) in METHODS.iter().enumerate() {
        let precision = Precision::of(method);
        let truth = &truths[usize::from(precision == Precision::Single)].1;
        let found = map(method.name, precision);
        let wrong: Map = truth
            .iter()
            .zip(&found)
            .map(|(truth, found)| truth != found)
            .collect();
        let count = wrong.iter().filter(|wrong| **wrong).count();
        let place = DVec2::new((n % COLUMNS) as f64, (n / COLUMNS) as f64);
        let corner = DVec2::new(12.0, 58.0) + pitch * place;
        let cell = side / f64::from(CELLS);
        let above = corner - DVec2::new(0.0, 6.0);
        svg.small_label("ink", above, Anchor::Start, method.name);
        let above = above + DVec2::new(side, 0.0);
        let idea = if count == 0 { "faint" } else { "wrong" };
        svg.small_label(idea, above, Anchor::End, &count.to_string());
        svg.group("pixels", |svg| {
            svg.cells("sphere wash", corner, cell, CELLS as usize, truth);
            svg.cells("wrong solid", corner, cell, CELLS as usize, &wrong);
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

/// What `method` decides, row by row from the top.
fn map(method: &str, precision: Precision) -> Map {
    let method = speed_vs_accuracy::find(method).expect("it is the name of a method");
    let middle = tangent(precision);
    let step = match precision {
        Precision::Double => f64::EPSILON / 2.0,
        Precision::Single => f64::from(f32::EPSILON) / 2.0,
    };
    let cells = (0..CELLS).flat_map(|j| (0..CELLS).map(move |i| (i - CELLS / 2, CELLS / 2 - j)));
    cells
        .map(|(i, j)| {
            let origin = middle + step * Vec3::new(f64::from(i), f64::from(j), 0.0);
            question(origin)
                .put_to(&method, f64::NEG_INFINITY, f64::INFINITY)
                .is_some()
        })
        .collect()
}

/// A sphere, and a ray that comes slantwise.
fn question(origin: Point3) -> Case {
    Case {
        center: Point3::ZERO,
        radius: 0.5,
        ray: Ray::new(origin, Vec3::new(-0.25, -0.375, 1.0)),
    }
}

/// An origin whose ray is as near to a tangent as numbers of that precision
/// allow, by halving.
///
/// Both its coordinates lie between ½ and 1, where all neighbors are equally far
/// apart.
fn tangent(precision: Precision) -> Point3 {
    let exact = speed_vs_accuracy::find("exact").expect("it is the name of a method");
    let origin = |x| Point3::new(x, 0.75, -1.5);
    let (mut inside, mut outside) = (0.5, 1.0);
    for _ in 0..60 {
        let x = 0.5 * (inside + outside);
        if question(origin(x))
            .put_to(&exact, f64::NEG_INFINITY, f64::INFINITY)
            .is_some()
        {
            inside = x;
        } else {
            outside = x;
        }
    }
    match precision {
        Precision::Double => origin(inside),
        Precision::Single => origin(f64::from(inside as f32)),
    }
}
