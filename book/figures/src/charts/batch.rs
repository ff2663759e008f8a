//! Many rays at once, and what the divider of the processor allows.

use std::fmt::Write;

use glam::DVec2;

use super::bars::bar;
use super::chart::{Chart, Drawn, Layout};
use crate::records::Timing;
use crate::svg::{Anchor, Svg};
use crate::table::{Record, Table};

/// Bars and limits.
pub(super) const CHART: Chart = Chart {
    name: "batch",
    title: "Many rays at once, and the limit of the divider",
    description: "Two bars for each method: a long one for one ray after the other, a short one \
        for many at once. Across the short bar stands a line: so much of it the processor's divider \
        takes for the root and the division alone.",
    caption: "Nanoseconds for a test. The line is the limit of the machine: one √ and one ÷ for \
        each ray, and nothing else. No code with a root and a division can be shorter.",
    files: &[Timing::FILE],
    draw: |files| draw(files[0]),
};

/// A method, one by one and many at once, in nanoseconds.
struct Pair {
    name: String,
    alone: Option<f64>,
    together: f64,
    limit: Option<f64>,
}

fn draw(timings: &str) -> Result<Drawn, String> {
    let pairs = read(timings)?;
    Ok(Drawn::new(table(&pairs), |layout| bars(layout, &pairs)))
}

fn bars(layout: Layout, pairs: &[Pair]) -> String {
    let longest = pairs
        .iter()
        .map(|pair| pair.alone.unwrap_or_default().max(pair.together))
        .fold(0.0, f64::max);
    let length = |time: f64| (layout.width() - layout.choose(300.0, 8.0)) * time / longest;
    let pitch = layout.choose(64.0, 114.0);
    let mut svg = CHART.sheet(layout, 40.0 + pitch * pairs.len() as f64);
    let left = layout.choose(12.0, 4.0);
    let title = "nanoseconds for one test, on the rays of the book";
    svg.small_label("faint", DVec2::new(left, 20.0), Anchor::Start, title);
    for (pair, place) in pairs.iter().zip(0..) {
        let corner = DVec2::new(layout.choose(170.0, left), 40.0 + pitch * f64::from(place));
        pair.draw(&mut svg, layout, corner, length);
    }
    svg.finish()
}

impl Pair {
    /// Two bars from `corner` on, of the `length` of their times.
    fn draw(&self, svg: &mut Svg, layout: Layout, corner: DVec2, length: impl Fn(f64) -> f64) {
        let (name, anchor, first, second) = layout.choose(
            (DVec2::new(-10.0, 26.0), Anchor::End, 0.0, 22.0),
            (DVec2::new(0.0, 16.0), Anchor::Start, 20.0, 60.0),
        );
        svg.label("ink", corner + name, anchor, &self.name);
        if let Some(alone) = self.alone {
            let words = format!("{alone:.2} one by one");
            let corner = corner + DVec2::new(0.0, first);
            bar(svg, layout, "faint", corner, length(alone), &words);
        }
        let corner = corner + DVec2::new(0.0, second);
        let mut words = format!("{:.2} many at once", self.together);
        if let Some(limit) = self.limit {
            let percent = 100.0 * limit / self.together;
            words += &format!(", {percent:.0} % of the limit");
        }
        let together = bar(
            svg,
            layout,
            "certain",
            corner,
            length(self.together),
            &words,
        );
        if let Some(limit) = self.limit {
            let at = together + DVec2::new(length(limit), 0.0);
            let [above, beneath] = [-4.0, 20.0].map(|y| at + DVec2::new(0.0, y));
            svg.line("ink bold", above, beneath);
        }
    }
}

fn read(timings: &str) -> Result<Vec<Pair>, String> {
    let timings = Table::<Timing>::read(timings)?;
    let limit = |precision| {
        let packed = |row: &&Timing| row.what == "limit" && row.name == "packed";
        let mut limits = timings.rows.iter().filter(packed);
        limits.find(|row| row.precision == precision)
    };
    let batches = timings.rows.iter().filter(|row| row.what == "batch");
    let pair = |row: &Timing| Pair {
        name: row.name.clone(),
        alone: timings.find("method", &row.name, "book").map(median),
        together: row.median_ns,
        limit: limit(row.precision).map(median),
    };
    Ok(batches.map(pair).collect())
}

fn median(row: &Timing) -> f64 {
    row.median_ns
}

fn table(pairs: &[Pair]) -> String {
    let mut table = "\
| method | one by one, ns | many at once, ns | limit, ns |
|---|---:|---:|---:|
"
    .to_owned();
    let shown = |time: Option<f64>| time.map_or(String::new(), |time| format!("{time:.2}"));
    for pair in pairs {
        let (alone, limit) = (shown(pair.alone), shown(pair.limit));
        let _ = writeln!(
            table,
            "| `{}` | {alone} | {:.2} | {limit} |",
            pair.name, pair.together
        );
    }
    table
}
