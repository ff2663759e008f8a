//! Digits that are left, against distance and against closeness to a tangent.

use std::fmt::Write;

use glam::DVec2;

use super::axes::{Axis, Panel};
use super::data::Table;
use super::labels::spread;
use super::methods::{cross, digits, idea, short};
use super::{Chart, Drawn};
use crate::svg::{Anchor, SMALL, Svg};

const FILES: &[&str] = &["measured/sweeps.snap.csv"];

/// Error against distance.
pub(super) const DISTANCE: Chart = Chart {
    name: "distance",
    title: "Digits that are left when the sphere is far away",
    description: "Lines for each method, f64 at the left and f32 at the right: how many digits of t \
        are right when the ray starts ever more radii away. The lines of the formulas with b fall \
        steadily, a digit for each factor of ten, and end in wrong decisions. The lines of the \
        methods that measure the distance of the ray from the center stay level.",
    caption: "The sphere moves away. The formulas with b or h lose digits with every step, and at \
        a cross they begin to decide wrongly. Those that measure how far the ray passes from the \
        center do not. Where certified_hit cannot be sure of its decision, it computes again with \
        more digits, and its line jumps up.",
    files: FILES,
    draw: |files| {
        draw(
            &DISTANCE,
            files[0],
            "far",
            "the ray starts so many radii away",
            |level| power("10", level),
        )
    },
};

/// Error against closeness to a tangent.
pub(super) const GRAZING: Chart = Chart {
    name: "grazing",
    title: "Digits that are left when the ray grazes the sphere",
    description: "Lines for each method, f64 at the left and f32 at the right: how many digits of t \
        are right when the ray passes ever nearer to a tangent. The methods in plain f64 and f32 \
        lose half a digit with each factor of ten. The line of certified_hit falls with them at \
        first, then jumps to the top, where the exact methods are from the beginning.",
    caption: "The ray comes closer to a tangent, where the two roots meet. Whoever computes with \
        no more digits than the numbers have loses half a digit of t for each factor of ten. \
        Where certified_hit cannot be sure of its decision, it takes more digits.",
    files: FILES,
    draw: |files| {
        draw(
            &GRAZING,
            files[0],
            "grazing",
            "how far from a tangent, in radii",
            |level| power("10⁻", level),
        )
    },
};

/// A method from level to level.
struct Line {
    method: String,
    single: bool,
    /// Level, digits, and wrong decisions among a million.
    points: Vec<(f64, f64, f64)>,
}

fn draw(
    chart: &Chart,
    file: &str,
    regime: &str,
    title: &str,
    tick: fn(i32) -> String,
) -> Result<Drawn, String> {
    let lines = read(file, regime)?;
    let mut svg = chart.sheet(400.0);
    let words = "digits of *t* that are right, in 999 of 1000 hits";
    svg.small_label("faint", DVec2::new(16.0, 20.0), Anchor::Start, words);
    cross(&mut svg, DVec2::new(424.0, 15.5));
    let words = "from here on, hits and misses are confused";
    svg.small_label("ink", DVec2::new(438.0, 20.0), Anchor::Start, words);
    for (single, x, width) in [(false, 40.0, 190.0), (true, 404.0, 140.0)] {
        let lines: Vec<&Line> = lines.iter().filter(|line| line.single == single).collect();
        let last = lines
            .iter()
            .flat_map(|line| &line.points)
            .map(|point| point.0);
        let last = last.fold(1.0, f64::max) as i32;
        let step = match last {
            ..9 => 2,
            9..13 => 3,
            _ => 5,
        };
        let ticks = (0..=last)
            .step_by(step)
            .map(|level| (f64::from(level), tick(level)));
        let panel = Panel {
            corner: DVec2::new(x, 60.0),
            size: DVec2::new(width, 290.0),
            x: Axis::linear(title, 0.0, f64::from(last), 1.0).with_ticks(ticks.collect()),
            y: Axis::linear(if single { "f32" } else { "f64" }, 0.0, 16.0, 4.0),
        };
        panel.draw(&mut svg);
        plot(&mut svg, &panel, &lines);
    }
    Ok(Drawn {
        svg: svg.finish(),
        table: table(&lines),
    })
}

/// Draws the lines, and their names beside the panel, in the order in which the
/// lines end.
fn plot(svg: &mut Svg, panel: &Panel, lines: &[&Line]) {
    let mut ends: Vec<(DVec2, &Line)> = Vec::new();
    // The bold ones first, so that they hide no other.
    let mut sorted = lines.to_vec();
    sorted.sort_by_key(|line| STROKES.iter().position(|stroke| *stroke == line.stroke()));
    for line in sorted {
        let points: Vec<DVec2> = line
            .points
            .iter()
            .map(|point| panel.at(point.0, point.1))
            .collect();
        svg.path(&format!("{} {}", line.idea(), line.stroke()), &points);
        if let Some(at) = line.points.iter().find(|point| point.2 > 0.0) {
            cross(svg, panel.at(at.0, at.1));
        }
        ends.extend(points.last().map(|end| (*end, line)));
    }
    ends.sort_by(|one, other| one.0.y.total_cmp(&other.0.y));
    let heights: Vec<f64> = ends.iter().map(|end| end.0.y).collect();
    let edge = panel.corner.x + panel.size.x;
    let places = spread(
        &heights,
        SMALL + 4.0,
        panel.corner.y - 6.0,
        panel.corner.y + panel.size.y,
    );
    for ((end, line), y) in ends.into_iter().zip(places) {
        svg.line("faint thin", end, DVec2::new(edge + 12.0, y));
        svg.small_label(
            line.idea(),
            DVec2::new(edge + 16.0, y + 4.0),
            Anchor::Start,
            &line.method,
        );
    }
}

/// From the back to the front.
const STROKES: [&str; 3] = ["bold", "thin", "line"];

impl Line {
    fn idea(&self) -> &'static str {
        idea(&self.method)
    }

    fn stroke(&self) -> &'static str {
        match self.idea() {
            "ink" => "thin",
            "reference" => "line",
            _ => "bold",
        }
    }
}

fn read(file: &str, regime: &str) -> Result<Vec<Line>, String> {
    let table = Table::read("sweeps.snap.csv", file)?;
    let mut lines: Vec<Line> = Vec::new();
    for row in table.rows() {
        if row.text("regime")? != regime {
            continue;
        }
        let method = row.text("method")?;
        let single = row.text("precision")? == "f32";
        let ulps = row.number("p999_ulps")?;
        let known = lines.iter().position(|line| line.method == method);
        let place = known.unwrap_or_else(|| {
            lines.push(Line {
                method: method.to_owned(),
                single,
                points: Vec::new(),
            });
            lines.len() - 1
        });
        let left = if ulps.is_nan() {
            0.0
        } else {
            digits(ulps, single)
        };
        let point = (row.number("level")?, left, row.number("wrong_per_million")?);
        lines[place].points.push(point);
    }
    Ok(lines)
}

fn table(lines: &[Line]) -> String {
    let levels = |line: &Line| {
        line.points
            .iter()
            .map(|point| point.0 as i32)
            .collect::<Vec<_>>()
    };
    let all = lines
        .iter()
        .map(levels)
        .max_by_key(Vec::len)
        .unwrap_or_default();
    let mut table = "| digits right, at 10ᵏ; ✗ wrong decisions per million |".to_owned();
    for level in &all {
        let _ = write!(table, " k = {level} |");
    }
    table += "\n|---|";
    table += &"---:|".repeat(all.len());
    table.push('\n');
    for line in lines {
        let _ = write!(table, "| `{}` |", line.method);
        for level in &all {
            let point = line
                .points
                .iter()
                .find(|point| point.0 == f64::from(*level));
            let _ = match point {
                None => write!(table, " |"),
                Some((_, digits, 0.0)) => write!(table, " {digits:.1} |"),
                Some((_, digits, wrong)) => write!(table, " {digits:.1}, ✗ {} |", short(*wrong)),
            };
        }
        table.push('\n');
    }
    table
}

/// A power of ten; of 10⁰, and of 10⁻⁰, it is 1.
fn power(ten: &str, level: i32) -> String {
    match level {
        0 => "1".to_owned(),
        _ => format!("{ten}{}", raised(level)),
    }
}

/// A number as an exponent.
pub(super) fn raised(number: i32) -> String {
    let digit = |digit: char| {
        digit
            .to_digit(10)
            .map(|digit| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit as usize))
    };
    number
        .to_string()
        .chars()
        .filter_map(digit)
        .flatten()
        .collect()
}
