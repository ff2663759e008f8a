//! Small multiples: what each method costs and how exact it is, a panel for each situation.

use speed_vs_accuracy::{Method, Precision, REGIMES, Regime};

use super::chart::{Chart, DrawnChart, table};
use super::labels::{self, Bounds, Name};
use super::marks::{cross, digits, idea, mark, ring};
use crate::number::number;
use crate::prelude::*;
use crate::records::{Accuracy, Timing};
use crate::table::{Record, Table};

/// The chart of speed against accuracy: a key, and a panel for each of [`REGIMES`].
pub(super) const CHART: Chart = Chart {
    name: "speed_accuracy",
    title: "Speed against accuracy",
    description: "A mark for each method: farther to the left it takes less time, where half_b takes \
        1, and higher up more digits of t are right, in half of the hits. A whisker reaches down to \
        the digits that 999 of 1000 hits have. A cross marks a method that decides wrongly, with how \
        often. A ring marks the method to take. A line of steps connects the methods that no other \
        beats: what is right of it or below it is slower and no more exact.",
    caption: "Six situations, on the same axes: farther to the left is faster, higher up more exact. \
        Two methods are left out that are far slower, <code>double_double</code> and \
        <code>exact</code>; the table below has them.",
    choices: &[],
    files: &[Accuracy::FILE, Timing::FILE],
    draw: |files| draw(files[0], files[1]),
};

/// The method that the page advises in each of [`REGIMES`], in their order, and on which condition.
/// A test compares them with the records.
pub const ADVICE: [[&str; 2]; 6] = [
    ["half_b_q", ""],
    ["cross_q", ", up to 10¹¹ radii away (✗ beyond)"],
    ["half_b_q", "; for more than 6 digits, compensated"],
    ["certified_hit", ""],
    ["compensated", ", or half_b and a t_min"],
    ["half_b", ", as chapter 5 has it"],
];

/// The accuracy of a method in a situation, and its time there.
type Measured = (Accuracy, Timing);

fn draw(accuracy: &str, timings: &str) -> Result<DrawnChart, String> {
    let (accuracy, timings) = (Table::read(accuracy)?, Table::read(timings)?);
    let read = |regime: &Regime| read(regime.name, &accuracy, &timings);
    let situations: Vec<_> = REGIMES.iter().map(read).collect::<Result<_, _>>()?;
    let mut key = CHART.panel(0, "what the marks mean", 78.0);
    draw_key(&mut key, 16.0);
    let mut panels = vec![key.finish().replacen("drawing", "drawing key", 1)];
    for (place, rows) in situations.iter().enumerate() {
        let mut svg = CHART.panel(place + 1, REGIMES[place].name, FOOT + 24.0);
        draw_panel(&mut svg, place, rows)?;
        panels.push(svg.finish());
    }
    Ok(DrawnChart {
        panels,
        table: numbers(&situations),
    })
}

/// Draws the panel of `place` in [`REGIMES`] with the key below it, for a page that shows no other,
/// from the texts of the chart's files.
///
/// # Errors
/// A message that names the file and the line that is wrong.
pub fn panel_with_key(place: usize, [accuracy, timings]: [&str; 2]) -> Result<String, String> {
    let Regime { name, .. } = REGIMES[place];
    let rows = read(name, &Table::read(accuracy)?, &Table::read(timings)?)?;
    let mut svg = CHART.panel(place + 1, name, FOOT + 106.0);
    draw_panel(&mut svg, place, &rows)?;
    draw_key(&mut svg, FOOT + 46.0);
    Ok(svg.finish())
}

/// Pairs the accuracy and the time of each method in a situation, the fastest first.
fn read(
    situation: &str,
    accuracy: &Table<Accuracy>,
    timings: &Table<Timing>,
) -> Result<Vec<Measured>, String> {
    let errors = accuracy.rows.iter().filter(|row| row.regime == situation);
    let with_time = |row: &Accuracy| {
        let time = timings.find("method", &row.method, situation);
        let time = time.ok_or_else(|| format!("no time of {} in {situation}", row.method))?;
        Ok((row.clone(), time.clone()))
    };
    let mut rows: Vec<Measured> = errors.map(with_time).collect::<Result<_, String>>()?;
    rows.sort_by(|(_, one), (_, other)| one.ratio.total_cmp(&other.ratio));
    Ok(rows)
}

/// The y of the plot's upper edge, of sixteen digits, of none, and of the words below.
const TOP: f64 = 46.0;
const MOST: f64 = 104.0;
const LEAST: f64 = 290.0;
const FOOT: f64 = 308.0;

/// The axis of times, the same in all panels.
const TIMES: Axis = Axis {
    is_logarithmic: true,
    ..Axis::new(26.0, LEAST, 366.0, 0.6, 42.0)
};

/// The axis of right digits, the same in all panels.
const DIGITS: Axis = Axis {
    end: spot(26.0, MOST),
    ..Axis::new(26.0, LEAST, 0.0, 0.0, 16.0)
};

/// Methods that the chart leaves out: they are so slow that the others would lie in one heap.
const SLOW: [Method; 2] = [Method::DOUBLE_DOUBLE, Method::EXACT];

/// Draws a situation: its names, the axes, and the methods' marks with their names.
fn draw_panel(svg: &mut Svg, place: usize, rows: &[Measured]) -> Result<(), String> {
    draw_frame(svg, place);
    let is_drawn = |(row, _): &&Measured| SLOW.iter().all(|slow| slow.name != row.method);
    let drawn: Vec<&Measured> = rows.iter().filter(is_drawn).collect();
    let is_advised = |row: &Measured| row.0.method == ADVICE[place][0];
    let front = front(&drawn);
    svg.path("front line", &front);
    for row in &drawn {
        draw_method(svg, row, is_advised(row));
    }
    let stretches = front.windows(2);
    let stretches = stretches.map(|ends| Bounds::around(ends[0], ends[1], 1.5));
    let marks = drawn.iter().flat_map(|row| {
        let [at, low] = ends(row);
        let around = if is_advised(row) { 10.0 } else { 6.5 };
        [
            Bounds::around(at, at, around),
            Bounds::around(at, low, 2.0),
            Bounds::around(low.right(-4.0), low.right(4.0), 1.5),
        ]
    });
    let obstacles: Vec<Bounds> = stretches.chain(marks).collect();
    let names: Vec<Name<'_>> = drawn.iter().map(|row| named(row)).collect();
    let sheet = Bounds(spot(28.0, TOP), spot(399.0, LEAST));
    labels::write(svg, &names, &obstacles, &sheet)
}

/// Draws what a situation is called, what to take there, and the axes.
fn draw_frame(svg: &mut Svg, place: usize) {
    let Regime { name, shows, .. } = REGIMES[place];
    let [advised, condition] = ADVICE[place];
    svg.label(
        "ink",
        spot(4.0, 15.0),
        Start,
        &format!("**{name}** {shows}"),
    );
    ring(svg, spot(12.0, 32.0), 6.0);
    let advice = format!("take {advised}{condition}");
    svg.small_label("certain", spot(24.0, 36.0), Start, &advice);
    let grid = spot(0.0, TOP - LEAST);
    let times = [1.0, 2.0, 5.0, 10.0, 20.0, 40.0];
    TIMES.draw_ticks(svg, "grid thin", grid, &ticks(times.into_iter(), number));
    let digits = (0..=16).step_by(4).map(f64::from);
    DIGITS.draw_ticks(svg, "grid thin", spot(366.0, 0.0), &ticks(digits, number));
    let [left, right] = [4.0, 396.0].map(|x| spot(x, FOOT + 18.0));
    svg.small_label("faint", left, Start, "↑ digits of *t* that are right");
    svg.small_label("faint", right, End, "time, if half_b takes 1 →");
}

/// Returns the places of a method's mark, at half of the hits, and of the end of its whisker.
fn ends((row, time): &Measured) -> [DVec2; 2] {
    let [half, nearly_all, _] = right_digits(row);
    let x = TIMES.point(time.ratio).x;
    [half, nearly_all].map(|digits| spot(x, DIGITS.point(digits).y))
}

fn draw_method(svg: &mut Svg, measured: &Measured, is_advised: bool) {
    let [at, low] = ends(measured);
    let (row, _) = measured;
    let idea = shown_idea(row);
    svg.line(&format!("{idea} line"), at, low);
    svg.line(&format!("{idea} line"), low.right(-4.0), low.right(4.0));
    if row.wrong_per_million > 0.0 {
        cross(svg, at);
    } else {
        mark(svg, idea, row.precision, at);
    }
    if is_advised {
        ring(svg, at, 9.5);
    }
}

fn shown_idea(row: &Accuracy) -> &'static str {
    if row.wrong_per_million > 0.0 {
        "wrong"
    } else {
        idea(&row.method)
    }
}

fn named<'a>(measured: &Measured) -> Name<'a> {
    let (row, _) = measured;
    let wrong = match row.wrong_per_million {
        0.0 => String::new(),
        wrong => format!(" ✗ {}", one_in(wrong)),
    };
    Name {
        mark: ends(measured)[0],
        idea: shown_idea(row),
        words: row.method.clone() + &wrong,
    }
}

/// Returns the steps through the marks of those methods, among the ones that decide rightly, that
/// none which is as fast is more exact than: from the fastest to the right end of the plot.
fn front(rows: &[&Measured]) -> Vec<DVec2> {
    let right = rows.iter().filter(|(row, _)| row.wrong_per_million == 0.0);
    let mut steps: Vec<DVec2> = Vec::new();
    for row in right {
        let [at, _] = ends(row);
        match steps.last() {
            // A tenth of a digit less is not less.
            Some(last) if at.y > last.y - 1.2 => continue,
            Some(last) => steps.push(spot(at.x, last.y)),
            None => {}
        }
        steps.push(at);
    }
    steps.extend(steps.last().map(|last| spot(TIMES.end.x, last.y)));
    steps
}

/// Draws what the marks mean, in three columns.
fn draw_key(svg: &mut Svg, top: f64) {
    let at = |x: f64, row: u8| spot(x, top + 24.0 * f64::from(row));
    let [left, middle, end] = [12.0, 140.0, 252.0];
    for (place, words) in [
        (at(left, 0), "half of the hits"),
        (at(left, 1), "999 of 1000 hits"),
        (at(left, 2), "take this"),
        (at(middle, 0), "chapter 5"),
        (at(middle, 1), "certified"),
        (at(middle, 2), "in f32"),
        (at(end, 0), "wrong decisions"),
        (at(end + 12.0, 1), "nothing beats these"),
    ] {
        svg.small_label("ink", place + spot(14.0, 4.0), Start, words);
    }
    let [half, nearly_all] = [at(left, 0), at(left, 1)];
    mark(svg, "ink", Precision::Double, half);
    svg.line("ink line", half, nearly_all);
    svg.line("ink line", nearly_all.right(-4.0), nearly_all.right(4.0));
    ring(svg, at(left, 2), 8.0);
    mark(svg, "reference", Precision::Double, at(middle, 0));
    mark(svg, "certain", Precision::Double, at(middle, 1));
    mark(svg, "ink", Precision::Single, at(middle, 2));
    cross(svg, at(end, 0));
    svg.line("front line", at(end - 10.0, 1), at(end + 12.0, 1));
}

/// Returns the number of right digits of t in half of the hits, in 999 of 1000, and in all.
fn right_digits(row: &Accuracy) -> [f64; 3] {
    [row.median_ulps, row.p999_ulps, row.largest_ulps].map(|ulps| digits(ulps, row.precision))
}

/// Writes a rate of wrong decisions, given per million, as one of so many, with two digits.
fn one_in(per_million: f64) -> String {
    let times = format!("{:.1e}", 1e6 / per_million);
    match times.parse().unwrap_or(f64::NAN) {
        1e6.. => "1 of a million".to_owned(),
        times => format!("1 of {}", printed(times)),
    }
}

/// Writes the table of all methods in all situations.
fn numbers(situations: &[Vec<Measured>]) -> String {
    let heads = [
        "situation",
        "method",
        "ns",
        "÷ half_b",
        "wrong of 10⁶",
        "digits: half",
        "999 of 1000",
        "all",
    ];
    table(
        2,
        &heads.map(str::to_owned),
        situations.iter().flatten().map(cells),
    )
}

fn cells((row, time): &Measured) -> Vec<String> {
    let numbers = [time.median_ns, time.ratio, row.wrong_per_million].map(printed);
    let digits = right_digits(row).map(|digits| format!("{digits:.1}"));
    [row.regime.clone(), format!("`{}`", row.method)]
        .into_iter()
        .chain(numbers)
        .chain(digits)
        .collect()
}
