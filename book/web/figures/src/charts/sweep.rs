//! Line charts: digits that are left, against distance.

use glam::DVec2;
use speed_vs_accuracy::{METHODS, Method, Precision};

use super::chart::{Chart, DrawnChart, table};
use super::marks::{cross, digits, idea};
use crate::axis::{Axis, ticks};
use crate::number::{number, power_of_ten, printed};
use crate::records::Level;
use crate::svg::{Anchor, Shift, Svg, spot};
use crate::table::{Record, Table};
use crate::text::SMALL;

/// The chart of right digits against the distance of the ray's origin from the sphere.
pub(super) const CHART: Chart = Chart {
    name: "distance",
    title: "Digits that are left when the sphere is far away",
    description: "Lines for some methods, f64 at the left and f32 at the right: how many digits of t \
        are right when the ray starts ever more radii away. The lines of half_b and half_b_q lose a \
        digit for each factor of ten. From ten million radii on, in f64, they decide wrongly, and keep \
        seven digits. The lines of the methods that measure the distance of the ray from the center \
        stay level.",
    caption: "The sphere moves away. half_b and half_b_q lose a digit for each factor of ten, until \
        they decide wrongly (✗). The methods that compute how far from the center the ray passes \
        lose no digits. The table below has all methods.",
    choices: &[],
    files: &[Level::FILE],
    draw: |files| draw(files[0]),
};

/// The accuracy of one method at rising distances; never empty.
type Sweep = Vec<Level>;

fn draw(file: &str) -> Result<DrawnChart, String> {
    let lines = read(file)?;
    let panels = [Precision::Double, Precision::Single].map(|precision| {
        let is_drawn = |line: &&Sweep| line[0].precision == precision && is_drawn(&line[0]);
        let shown: Vec<&Sweep> = lines.iter().filter(is_drawn).collect();
        panel(precision, &shown)
    });
    Ok(DrawnChart {
        panels: panels.into(),
        table: numbers(&lines),
    })
}

/// The width and the height of the grid of a panel.
const WIDE: f64 = 196.0;
const HIGH: f64 = 310.0;

fn panel(precision: Precision, lines: &[&Sweep]) -> String {
    let name = precision.name();
    let mut svg = CHART.panel(1 + precision as usize, name, 420.0);
    cross(&mut svg, spot(12.0, 16.0));
    let words = "from here on, it confuses hits and misses";
    svg.small_label("ink", spot(26.0, 20.5), Anchor::Start, words);
    let low = spot(28.0, 62.0 + HIGH);
    let last = last(lines.iter().copied());
    let [least, most] = [[6, 16], [2, 8]][precision as usize];
    let levels = Axis::new(low.x, low.y, WIDE, 0.0, f64::from(last));
    let right = Axis {
        end: low.down(-HIGH),
        ..Axis::new(low.x, low.y, 0.0, f64::from(least), f64::from(most))
    };
    let powers = (0..=last).step_by(last as usize / 3).map(f64::from);
    let powers = ticks(powers, |level| power_of_ten(level as i32));
    levels.draw_ticks(&mut svg, "grid thin", spot(0.0, -HIGH), &powers);
    let numbers = ticks((least..=most).step_by(2).map(f64::from), number);
    right.draw_ticks(&mut svg, "grid thin", spot(WIDE, 0.0), &numbers);
    let below = low + spot(WIDE, 36.0);
    svg.small_label(
        "ink",
        below,
        Anchor::End,
        "the ray starts so many radii away",
    );
    let title = format!("{name}: digits of *t* that are right, in 999 of 1000 hits");
    svg.small_label("ink", spot(4.0, 50.0), Anchor::Start, &title);
    plot(&mut svg, [&levels, &right], lines);
    svg.finish()
}

/// Returns the last level that any of the methods reaches.
fn last<'a>(lines: impl Iterator<Item = &'a Sweep>) -> i32 {
    lines.flatten().map(|row| row.level).fold(1, i32::max)
}

/// Draws the lines and, beside the grid, their names. A cross marks the first wrong decision; since
/// it may lie on several lines, the name of its method has a cross, too.
fn plot(svg: &mut Svg, [levels, right]: [&Axis; 2], lines: &[&Sweep]) {
    let mut ends: Vec<(DVec2, &Sweep)> = Vec::new();
    for (idea, stroke) in STROKES {
        let has_it = |line: &&&Sweep| self::idea(&line[0].method) == idea;
        for line in lines.iter().filter(has_it) {
            let at = |row: &Level| {
                let x = levels.point(f64::from(row.level)).x;
                spot(x, right.point(right_digits(row)).y)
            };
            let points: Vec<DVec2> = line.iter().map(at).collect();
            svg.path(&format!("{idea} {stroke}"), &points);
            if let Some(row) = first_wrong(line) {
                cross(svg, at(row));
            }
            ends.extend(points.last().map(|end| (*end, *line)));
        }
    }
    ends.sort_by(|one, other| one.0.y.total_cmp(&other.0.y));
    draw_names(svg, levels.end, &ends);
}

/// Writes the names of methods to the right of the grid whose lower left corner is `low`, in the
/// order in which their lines end.
fn draw_names(svg: &mut Svg, low: DVec2, ends: &[(DVec2, &Sweep)]) {
    let heights: Vec<f64> = ends.iter().map(|(end, _)| end.y).collect();
    let places = spread(&heights, SMALL + 4.0, low.y - HIGH - 6.0, low.y);
    for ((end, line), y) in ends.iter().zip(places) {
        let beside = spot(low.x + 12.0, y);
        svg.line("faint thin", *end, beside);
        if first_wrong(line).is_some() {
            cross(svg, beside.right(8.0));
        }
        let (name, method) = (beside + spot(16.0, 4.0), &line[0].method);
        svg.small_label(idea(method), name, Anchor::Start, method);
    }
}

/// Moves `places`, given in rising order, as little as possible so that neighbors are at least
/// `gap` apart and all lie between `least` and `most`.
fn spread(places: &[f64], gap: f64, least: f64, most: f64) -> Vec<f64> {
    let mut moved = places.to_vec();
    let mut next = least;
    for place in &mut moved {
        *place = place.max(next);
        next = *place + gap;
    }
    let mut next = most;
    for place in moved.iter_mut().rev() {
        *place = place.min(next);
        next = *place - gap;
    }
    moved
}

/// The strokes of the lines of each idea, in drawing order: bold lines come first, so that they
/// hide no other.
const STROKES: [(&str, &str); 3] = [("certain", "bold"), ("ink", "thin"), ("reference", "line")];

/// The methods in `f64` that have a line: those of the lesson of chapter 6, and a certified one.
/// More lines would hide each other; in `f32` all have one.
const DRAWN: [Method; 4] = [
    Method::HALF_B,
    Method::HALF_B_Q,
    Method::CROSS_Q,
    Method::CERTIFIED_T,
];

fn is_drawn(row: &Level) -> bool {
    let is_named = DRAWN.iter().any(|method| method.name == row.method);
    is_named || row.precision == Precision::Single
}

/// Returns the first level at which a method decides wrongly, if there is one.
fn first_wrong(line: &Sweep) -> Option<&Level> {
    line.iter().find(|row| row.wrong_per_million > 0.0)
}

fn right_digits(row: &Level) -> f64 {
    digits(row.p999_ulps, row.precision)
}

fn read(file: &str) -> Result<Vec<Sweep>, String> {
    let mut rows = Table::<Level>::read(file)?.rows;
    rows.sort_by_key(|row| METHODS.iter().position(|method| method.name == row.method));
    let lines = rows.chunk_by(|one, other| one.method == other.method);
    Ok(lines.map(Sweep::from).collect())
}

fn numbers(lines: &[Sweep]) -> String {
    let levels = 1..=last(lines.iter());
    let name = "digits right; ✗ wrong decisions per million".to_owned();
    let powers = levels.clone().map(power_of_ten);
    let heads: Vec<String> = [name].into_iter().chain(powers).collect();
    let row = |line: &Sweep| {
        let cells = levels.clone().map(|level| {
            let row = line.iter().find(|row| row.level == level);
            row.map_or(String::new(), cell)
        });
        let name = format!("`{}`", line[0].method);
        [name].into_iter().chain(cells).collect()
    };
    table(1, &heads, lines.iter().map(row))
}

fn cell(row: &Level) -> String {
    let digits = right_digits(row);
    match row.wrong_per_million {
        0.0 => format!("{digits:.1}"),
        wrong => format!("{digits:.1}, ✗ {}", printed(wrong)),
    }
}
