//! Dot plots: what each method costs, and how exact it is, in a situation that a reader chooses.

use glam::DVec2;
use speed_vs_accuracy::Method;

use super::chart::{Chart, DrawnChart, table};
use super::marks::{digits, idea, mark};
use crate::axis::{Axis, ticks};
use crate::number::{number, printed};
use crate::records::{Accuracy, Timing};
use crate::svg::{Anchor, Shift, Svg, spot};
use crate::table::{Record, Table};

/// The situations, which the files call regimes, in the order of `CHART.choices`.
const SITUATIONS: [&str; 6] = ["book", "far", "ground", "grazing", "near_surface", "inside"];

/// The chart of speed against accuracy, a panel for each situation.
pub(super) const CHART: Chart = Chart {
    name: "speed_accuracy",
    title: "Speed against accuracy",
    description: "A row for each method, the fastest at the top. At the left a mark on a logarithmic \
        axis says how long a question takes, where that of half_b takes 1. At the right, on an axis \
        of decimal digits, a mark says how many digits of t are right for half of the hits, a thick \
        bar reaches down to those that 999 of 1000 hits have, and a thin line to those of the worst \
        hit. Beside its name stands how many of its decisions are wrong.",
    caption: "Farther to the left is faster, farther to the right more exact. ✗: so many decisions \
        are wrong, a hit for a miss or a miss for a hit. Hollow marks are methods in <code>f32</code>, \
        diamonds are certified. The table below has two more, <code>double_double</code> and \
        <code>exact</code>, which are far slower.",
    choices: &[
        "the book’s rays",
        "a small sphere far away",
        "above a huge ground",
        "grazing rays",
        "leaving a surface",
        "from inside",
    ],
    files: &[Accuracy::FILE, Timing::FILE],
    draw: |files| draw(files[0], files[1]),
};

/// The accuracy of a method in a situation, and its time there.
type Measured = (Accuracy, Timing);

fn draw(accuracy: &str, timings: &str) -> Result<DrawnChart, String> {
    let (accuracy, timings) = (Table::read(accuracy)?, Table::read(timings)?);
    let situations = SITUATIONS.map(|situation| read(situation, &accuracy, &timings));
    let situations: Vec<_> = situations.into_iter().collect::<Result<_, _>>()?;
    let all = situations.iter().zip(CHART.choices);
    Ok(DrawnChart {
        panels: all
            .clone()
            .zip(1..)
            .map(|((rows, shows), place)| panel(place, shows, rows))
            .collect(),
        table: numbers(all),
    })
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

/// The y of the first row, and the distance from one row to the next.
const TOP: f64 = 66.0;
const PITCH: f64 = 36.0;

/// Methods that the chart leaves out: they are so slow that the others would lie in one heap.
const SLOW: [Method; 2] = [Method::DOUBLE_DOUBLE, Method::EXACT];

fn panel(place: usize, shows: &str, rows: &[Measured]) -> String {
    let is_drawn = |(row, _): &&Measured| SLOW.iter().all(|method| method.name != row.method);
    let drawn: Vec<&Measured> = rows.iter().filter(is_drawn).collect();
    let high = PITCH * drawn.len() as f64;
    let mut svg = CHART.panel(place, shows, TOP + high + 44.0);
    let [costs, right] = [costs(&drawn), digits_axis(&drawn)];
    for (axis, title) in [
        (&costs, "time, if half_b takes 1"),
        (&right, "decimal digits of *t* that are right"),
    ] {
        let from = axis.start.down(-20.0);
        svg.small_label("ink", from, Anchor::Start, title);
        axis.draw_ticks(&mut svg, "grid thin", spot(0.0, high + 14.0), &marked(axis));
    }
    let half_b = costs.point(1.0);
    svg.line(
        "reference dashed",
        half_b.down(24.0),
        half_b.down(high + 14.0),
    );
    for (row, n) in drawn.iter().zip(0_u8..) {
        draw_row(&mut svg, TOP + PITCH * f64::from(n), [&costs, &right], row);
    }
    key(&mut svg, spot(right.start.x, TOP + high + 20.0));
    svg.finish()
}

/// Makes an axis of times that all rows fit on.
fn costs(rows: &[&Measured]) -> Axis {
    let ratios = rows.iter().map(|(_, time)| time.ratio);
    let [least, most] = ratios.fold([1.0; 2], |[least, most], it| [it.min(least), it.max(most)]);
    Axis {
        is_logarithmic: true,
        ..Axis::new(10.0, 30.0, 140.0, 0.9 * least, 1.6 * most)
    }
}

/// Makes an axis of right digits that all rows fit on.
fn digits_axis(rows: &[&Measured]) -> Axis {
    let least = rows.iter().map(|(row, _)| right_digits(row)[2]);
    let least = least.fold(12.0, f64::min);
    Axis::new(176.0, 30.0, 216.0, 2.0 * (0.5 * least).floor(), 16.0)
}

/// Returns the ticks of an axis. On a logarithmic one these are powers of ten, and where these are
/// few, 2 and 5 times these; on a linear one, every second or fourth digit.
fn marked(axis: &Axis) -> Vec<(f64, String)> {
    let holds = |it: &f64| (axis.least..=axis.most).contains(it);
    if !axis.is_logarithmic {
        let step = if axis.most - axis.least > 8.0 { 4 } else { 2 };
        return ticks((0..=16).step_by(step).map(f64::from).filter(holds), number);
    }
    let factors: &[f64] = if axis.most > 20.0 {
        &[1.0]
    } else {
        &[1.0, 2.0, 5.0]
    };
    let all = [1.0, 10.0, 100.0].into_iter();
    let all = all.flat_map(|power| factors.iter().map(move |factor| factor * power));
    ticks(all.filter(holds), number)
}

fn draw_row(svg: &mut Svg, y: f64, [costs, right]: [&Axis; 2], (row, time): &Measured) {
    let idea = idea(&row.method);
    svg.small_label(idea, spot(10.0, y), Anchor::Start, &row.method);
    if row.wrong_per_million > 0.0 {
        let words = format!("✗ {}", one_in(row.wrong_per_million));
        svg.small_label("wrong", spot(392.0, y), Anchor::End, &words);
    }
    let at = |axis: &Axis, value| spot(axis.point(value).x, y + 13.0);
    let cost = at(costs, time.ratio);
    mark(svg, idea, row.precision, cost);
    svg.small_label(
        idea,
        cost + spot(9.0, 4.0),
        Anchor::Start,
        &printed(time.ratio),
    );
    let [typical, nearly_all, all] = right_digits(row).map(|digits| at(right, digits));
    svg.line(&format!("{idea} thin"), all, typical);
    svg.line(&format!("{idea} thin"), all.down(-4.0), all.down(4.0));
    svg.line(&format!("{idea} bold"), nearly_all, typical);
    mark(svg, idea, row.precision, typical);
}

/// Draws the key to the bars.
fn key(svg: &mut Svg, at: DVec2) {
    let [all, nearly_all, half] = [20.0, 96.0, 180.0].map(|x| at.right(x));
    svg.line("faint thin", all, half);
    svg.line("faint thin", all.down(-4.0), all.down(4.0));
    svg.line("faint bold", nearly_all, half);
    svg.circle("faint solid", half, 4.5);
    for (at, words) in [
        (all, "all hits"),
        (nearly_all, "999 of 1000"),
        (half, "half"),
    ] {
        svg.small_label("faint", at.down(17.0), Anchor::Middle, words);
    }
}

/// Returns the number of right digits of t in half of the hits, in 999 of 1000, and in all.
fn right_digits(row: &Accuracy) -> [f64; 3] {
    [row.median_ulps, row.p999_ulps, row.largest_ulps].map(|ulps| digits(ulps, row.precision))
}

/// Writes a rate of wrong decisions, given per million, as one in so many, with two digits.
fn one_in(per_million: f64) -> String {
    let times = format!("{:.1e}", 1e6 / per_million)
        .parse()
        .unwrap_or(f64::NAN);
    format!("wrong in 1 of {}", number(times))
}

/// Writes the table of all methods in all situations.
fn numbers<'a>(all: impl Iterator<Item = (&'a Vec<Measured>, &'a &'static str)>) -> String {
    let heads = [
        "situation",
        "method",
        "ns",
        "÷ half_b",
        "instructions",
        "wrong of 10⁶",
        "digits: half",
        "999 of 1000",
        "all",
    ];
    let rows = all.flat_map(|(rows, shows)| rows.iter().map(move |row| cells(shows, row)));
    table(2, &heads.map(str::to_owned), rows)
}

fn cells(shows: &str, (row, time): &Measured) -> Vec<String> {
    let numbers = [
        Some(time.median_ns),
        Some(time.ratio),
        time.instructions,
        Some(row.wrong_per_million),
    ];
    let numbers = numbers.map(|number| number.map_or("–".to_owned(), printed));
    let digits = right_digits(row).map(|digits| format!("{digits:.1}"));
    [shows.to_owned(), format!("`{}`", row.method)]
        .into_iter()
        .chain(numbers)
        .chain(digits)
        .collect()
}
