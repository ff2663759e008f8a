//! Line charts: digits that are left, against distance and closeness to a tangent.

use glam::DVec2;
use speed_vs_accuracy::{Method, Precision};

use super::chart::{Chart, Drawn, table};
use super::labels::spread;
use super::methods::{cross, digits, idea};
use super::panel::{Measure, Panel};
use crate::axis::ticks;
use crate::number::{raised, short};
use crate::records::Level;
use crate::svg::{Anchor, Svg};
use crate::table::{Record, Table};
use crate::text::SMALL;

const FILES: &[&str] = &[Level::FILE];

/// Error against distance.
pub(super) const DISTANCE: Chart = Chart {
    name: "distance",
    title: "Digits that are left when the sphere is far away",
    description: "Lines for some methods, f64 at the left and f32 at the right: how many digits of t \
        are right when the ray starts ever more radii away. The lines of half_b and half_b_q fall \
        steadily, a digit for each factor of ten, and end in wrong decisions. The lines of the \
        methods that measure the distance of the ray from the center stay level.",
    caption: "The sphere moves away. half_b and half_b_q lose a digit for each factor of ten, and from the \
        cross on they decide wrongly. The methods that compute how far from the center the ray \
        passes lose no digits. The table below has all methods.",
    files: FILES,
    draw: |files| {
        draw(
            &DISTANCE,
            files[0],
            "far",
            "the ray starts so many radii away",
            "10",
        )
    },
};

/// Error against closeness to a tangent.
pub(super) const GRAZING: Chart = Chart {
    name: "grazing",
    title: "Digits that are left when the ray grazes the sphere",
    description: "Lines for some methods, f64 at the left and f32 at the right: how many digits of t \
        are right when the ray passes ever nearer to a tangent. The methods in plain f64 and f32 \
        lose half a digit with each factor of ten. The line of certified_t is at the top from the \
        beginning.",
    caption: "The ray comes closer to a tangent, where the two roots meet. A method that \
        computes with no more digits than the numbers have loses half a digit of t for each factor of \
        ten. certified_t uses more digits where it needs them. The table below has all methods.",
    files: FILES,
    draw: |files| {
        draw(
            &GRAZING,
            files[0],
            "grazing",
            "how far from a tangent, in radii",
            "10⁻",
        )
    },
};

/// A method from level to level.
struct Line {
    method: String,
    precision: Precision,
    levels: Vec<Level>,
}

fn draw(chart: &Chart, file: &str, regime: &str, title: &str, ten: &str) -> Result<Drawn, String> {
    let lines = read(file, regime)?;
    let panels = [Precision::Double, Precision::Single].map(|precision| {
        let is_drawn = |line: &&Line| line.precision == precision && line.is_drawn();
        let shown: Vec<&Line> = lines.iter().filter(is_drawn).collect();
        draw_panel(chart, precision, &shown, levels(title, &shown, ten))
    });
    Ok(Drawn {
        panels: panels.into(),
        table: numbers(&lines, ten),
    })
}

fn draw_panel(chart: &Chart, precision: Precision, lines: &[&Line], levels: Measure) -> String {
    let name = precision.name();
    let mut svg = chart.panel(1 + precision as usize, name, 420.0);
    let at = DVec2::new(12.0, 16.0);
    cross(&mut svg, at);
    let words = "from here on, it confuses hits and misses";
    svg.small_label("ink", at + DVec2::new(14.0, 4.5), Anchor::Start, words);
    let title = format!("{name}: digits of *t* that are right, in 999 of 1000 hits");
    let digits = Measure::linear(&title, 0.0, 16.0, 4.0);
    let (corner, size) = (DVec2::new(28.0, 62.0), DVec2::new(196.0, 310.0));
    let panel = Panel::new(corner, size, levels, digits);
    panel.draw(&mut svg);
    plot(&mut svg, &panel, lines);
    svg.finish()
}

/// All levels of `lines`, with some of them marked.
fn levels(title: &str, lines: &[&Line], ten: &str) -> Measure {
    let levels = lines.iter().flat_map(|line| &line.levels);
    let last = levels.map(|row| row.level).fold(1, i32::max);
    let step = match last {
        ..9 => 2,
        9..13 => 3,
        _ => 5,
    };
    let marked = (0..=last).step_by(step).map(f64::from);
    Measure {
        ticks: ticks(marked, |level| power(ten, level as i32)),
        ..Measure::linear(title, 0.0, f64::from(last), 1.0)
    }
}

/// Draws the lines, and their names beside the panel, in the order in which the
/// lines end. A cross on a line may lie on several: the name of its method has one too.
fn plot(svg: &mut Svg, panel: &Panel, lines: &[&Line]) {
    let mut ends: Vec<(DVec2, &Line)> = Vec::new();
    // The bold ones first, so that they hide no other.
    let mut sorted = lines.to_vec();
    sorted.sort_by_key(|line| STROKES.iter().position(|stroke| *stroke == line.stroke()));
    for line in sorted {
        let at = |row: &Level| panel.at(f64::from(row.level), right_digits(row));
        let points: Vec<DVec2> = line.levels.iter().map(at).collect();
        svg.path(&format!("{} {}", line.idea(), line.stroke()), &points);
        if let Some(row) = line.first_wrong() {
            cross(svg, at(row));
        }
        ends.extend(points.last().map(|end| (*end, line)));
    }
    ends.sort_by(|one, other| one.0.y.total_cmp(&other.0.y));
    let heights: Vec<f64> = ends.iter().map(|end| end.0.y).collect();
    let (top, low) = (panel.corner.y - 6.0, panel.corner.y + panel.size.y);
    let places = spread(&heights, SMALL + 4.0, top, low);
    for ((end, line), y) in ends.into_iter().zip(places) {
        let beside = DVec2::new(panel.corner.x + panel.size.x + 12.0, y);
        svg.line("faint thin", end, beside);
        if line.first_wrong().is_some() {
            cross(svg, beside + DVec2::new(8.0, 0.0));
        }
        let name = beside + DVec2::new(16.0, 4.0);
        svg.small_label(line.idea(), name, Anchor::Start, &line.method);
    }
}

/// The methods that the lesson of chapter 6 is about, from chapter 5 on.
const LESSON: [Method; 4] = [
    Method::HALF_B,
    Method::HALF_B_Q,
    Method::CROSS_Q,
    Method::ADAPTIVE_Q,
];

/// From the back to the front.
const STROKES: [&str; 3] = ["bold", "thin", "line"];

impl Line {
    /// Too many lines hide each other. In `f64` these are the methods of the lesson, and
    /// what is right; in `f32` there are few.
    fn is_drawn(&self) -> bool {
        let mut drawn = LESSON.iter().chain([&Method::CERTIFIED_T]);
        self.precision == Precision::Single || drawn.any(|method| method.name == self.method)
    }

    /// The first level at which it decides wrongly.
    fn first_wrong(&self) -> Option<&Level> {
        self.levels.iter().find(|row| row.wrong_per_million > 0.0)
    }

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

fn right_digits(row: &Level) -> f64 {
    digits(row.p999_ulps, row.precision)
}

fn read(file: &str, regime: &str) -> Result<Vec<Line>, String> {
    let rows = Table::<Level>::read(file)?.rows.into_iter();
    let mut lines: Vec<Line> = Vec::new();
    for row in rows.filter(|row| row.regime == regime) {
        match lines.iter_mut().find(|line| line.method == row.method) {
            Some(line) => line.levels.push(row),
            None => lines.push(Line {
                method: row.method.clone(),
                precision: row.precision,
                levels: vec![row],
            }),
        }
    }
    Ok(lines)
}

fn numbers(lines: &[Line], ten: &str) -> String {
    let longest = lines.iter().max_by_key(|line| line.levels.len());
    let levels: Vec<i32> = longest
        .iter()
        .flat_map(|line| &line.levels)
        .map(|row| row.level)
        .collect();
    let mut heads = vec![format!(
        "digits right, at {ten}ᵏ; ✗ wrong decisions per million"
    )];
    heads.extend(levels.iter().map(|level| format!("k = {level}")));
    let row = |line: &Line| {
        let mut row = vec![format!("`{}`", line.method)];
        row.extend(levels.iter().map(|level| {
            let row = line.levels.iter().find(|row| row.level == *level);
            row.map_or(String::new(), cell)
        }));
        row
    };
    table(1, &heads, lines.iter().map(row))
}

fn cell(row: &Level) -> String {
    let digits = right_digits(row);
    match row.wrong_per_million {
        0.0 => format!("{digits:.1}"),
        wrong => format!("{digits:.1}, ✗ {}", short(wrong)),
    }
}

/// A power of ten; of 10⁰, and of 10⁻⁰, it is 1.
fn power(ten: &str, level: i32) -> String {
    match level {
        0 => "1".to_owned(),
        _ => format!("{ten}{}", raised(level)),
    }
}
