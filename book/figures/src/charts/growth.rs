//! The nearest hit among ever more spheres.

use std::fmt::Write;

use glam::DVec2;

use super::axes::{Axis, Panel};
use super::chart::{Chart, Drawn, Layout};
use super::labels::{Labels, Place, spread};
use crate::records::Timing;
use crate::svg::{Anchor, SMALL, Svg};
use crate::table::{Record, Table};

/// Lines, and where they cross.
pub(super) const CHART: Chart = Chart {
    name: "growth",
    title: "The nearest hit among ever more spheres",
    description: "A line for each way to keep spheres, on logarithmic scales: how long a ray takes \
        to find the nearest of so many. The lists rise in proportion to the number of spheres, the \
        batch only where it has more than one block of 64. The tree begins higher than the lists \
        and rises slowly. Rings mark where it overtakes one.",
    caption: "A list takes twice as long for twice as many spheres, a tree hardly longer. The batch \
        asks 64 spheres at once, whether it has them or not. A ring marks the number of spheres \
        from which the tree is faster.",
    files: &[Timing::FILE],
    draw: |files| draw(files[0]),
};

/// A way to keep spheres: how many, and nanoseconds for a ray.
struct Line {
    name: String,
    points: Vec<(f64, f64)>,
}

fn draw(timings: &str) -> Result<Drawn, String> {
    let lines = read(timings)?;
    Ok(Drawn::new(table(&lines), |layout| plot(layout, &lines)))
}

fn plot(layout: Layout, lines: &[Line]) -> String {
    let all = || lines.iter().flat_map(|line| &line.points);
    let panel = Panel {
        corner: DVec2::new(layout.choose(64.0, 58.0), 50.0),
        size: DVec2::new(layout.width() - layout.choose(190.0, 146.0), 310.0),
        x: Axis::logarithmic("spheres", all().map(|point| point.0)),
        y: Axis::logarithmic("nanoseconds for one ray", all().map(|point| point.1)),
    };
    let mut svg = CHART.sheet(layout, 410.0);
    panel.draw(&mut svg);
    for line in lines {
        let points = line.places(&panel);
        svg.path(&format!("{} line", line.idea()), &points);
        for point in points {
            svg.circle(&format!("{} solid", line.idea()), point, 3.0);
        }
    }
    name(&mut svg, &panel, lines);
    mark_crossings(&mut svg, &panel, lines);
    svg.finish()
}

/// Writes the names where the lines end.
fn name(svg: &mut Svg, panel: &Panel, lines: &[Line]) {
    let end = |line: &Line| line.points.last().map(|point| panel.at(point.0, point.1));
    let mut ends: Vec<(DVec2, &Line)> = lines
        .iter()
        .filter_map(|line| Some((end(line)?, line)))
        .collect();
    ends.sort_by(|one, other| one.0.y.total_cmp(&other.0.y));
    let heights: Vec<f64> = ends.iter().map(|end| end.0.y).collect();
    let (least, most) = (panel.corner.y, panel.corner.y + panel.size.y);
    let edge = panel.corner.x + panel.size.x;
    for ((end, line), y) in ends.iter().zip(spread(&heights, SMALL + 5.0, least, most)) {
        svg.line("faint thin", *end, DVec2::new(edge + 10.0, y));
        let at = DVec2::new(edge + 14.0, y + 4.0);
        svg.small_label(line.idea(), at, Anchor::Start, &line.name.replace('_', " "));
    }
}

/// Rings where the tree becomes faster than a list.
fn mark_crossings(svg: &mut Svg, panel: &Panel, lines: &[Line]) {
    let Some(tree) = lines.iter().find(|line| line.name == TREE) else {
        return;
    };
    let others = lines.iter().filter(|line| line.name != TREE);
    let crossings: Vec<(f64, f64)> = others.filter_map(|line| crossing(line, tree)).collect();
    let places: Vec<DVec2> = crossings
        .iter()
        .map(|point| panel.at(point.0, point.1))
        .collect();
    let rings = places.iter().map(|place| Place::around(*place, 8.0));
    let drawn: Vec<Vec<DVec2>> = lines.iter().map(|line| line.places(panel)).collect();
    let pairs = drawn.iter().flat_map(|points| points.windows(2));
    let along = pairs.flat_map(|ends| Place::along(ends[0], ends[1]));
    let room = Place::new(panel.corner, panel.size);
    let mut labels = Labels::new(room, along.collect(), rings.collect());
    for ((count, _), place) in crossings.iter().zip(&places) {
        svg.circle("ink line", *place, 7.0);
        let plural = if count.round() == 1.0 { "" } else { "s" };
        labels.put(svg, "ink", *place, &format!("{count:.0} sphere{plural}"));
    }
}

const TREE: &str = "bvh";

impl Line {
    /// Its points on the sheet.
    fn places(&self, panel: &Panel) -> Vec<DVec2> {
        self.points
            .iter()
            .map(|point| panel.at(point.0, point.1))
            .collect()
    }

    fn idea(&self) -> &'static str {
        match &self.name[..] {
            TREE => "certain",
            "batch" => "front",
            "boxed_list" => "reference",
            _ => "ink",
        }
    }
}

/// Where `tree` begins to be faster than `list`: both are straight between
/// neighboring counts, on logarithmic scales.
fn crossing(list: &Line, tree: &Line) -> Option<(f64, f64)> {
    let both: Vec<(f64, f64, f64)> = list
        .points
        .iter()
        .filter_map(|&(count, time)| {
            let other = tree.points.iter().find(|point| point.0 == count)?;
            Some((count.ln(), time.ln(), other.1.ln()))
        })
        .collect();
    let pair = both
        .windows(2)
        .rfind(|pair| pair[0].1 <= pair[0].2 && pair[1].1 > pair[1].2)?;
    let [before, after] = [pair[0], pair[1]].map(|point| point.2 - point.1);
    let part = before / (before - after);
    let between = |from: f64, to: f64| (from + part * (to - from)).exp();
    Some((between(pair[0].0, pair[1].0), between(pair[0].1, pair[1].1)))
}

fn read(timings: &str) -> Result<Vec<Line>, String> {
    let rows = Table::<Timing>::read(timings)?.rows.into_iter();
    let mut lines: Vec<Line> = Vec::new();
    for row in rows.filter(|row| row.what == "growth") {
        let point = (row.n as f64, row.median_ns);
        match lines.iter_mut().find(|line| line.name == row.name) {
            Some(line) => line.points.push(point),
            None => lines.push(Line {
                name: row.name,
                points: vec![point],
            }),
        }
    }
    Ok(lines)
}

fn table(lines: &[Line]) -> String {
    let mut table = "| spheres |".to_owned();
    for line in lines {
        let _ = write!(table, " {}, ns |", line.name.replace('_', " "));
    }
    table += "\n|---:|";
    table += &"---:|".repeat(lines.len());
    table.push('\n');
    let mut counts: Vec<f64> = lines
        .iter()
        .flat_map(|line| &line.points)
        .map(|point| point.0)
        .collect();
    counts.sort_by(f64::total_cmp);
    counts.dedup();
    for count in counts {
        let _ = write!(table, "| {count} |");
        for line in lines {
            let _ = match line.points.iter().find(|point| point.0 == count) {
                Some((_, time)) => write!(table, " {time:.1} |"),
                None => write!(table, " |"),
            };
        }
        table.push('\n');
    }
    table
}
