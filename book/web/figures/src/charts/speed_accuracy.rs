//! Speed against accuracy: every method on the rays of the book.

use super::chart::{Chart, Drawn, table};
use super::methods::{Measured, Point, in_lanes, lanes, legend, read};
use super::pareto::{Plot, range};
use crate::number::printed;
use crate::records::{Accuracy, Timing};
use crate::svg::{Anchor, Svg, spot};
use crate::table::Record;

const FILES: &[&str] = &[Accuracy::FILE, Timing::FILE];

/// The book's own rays.
pub(super) const BOOK: Chart = Chart {
    name: "speed_accuracy",
    title: "Speed against accuracy, on the rays of the book",
    description: "A point for each method: how long a test takes, from left to right, and how many \
        digits of t are right, upwards. The methods in f32 lie far below those in f64. A line joins \
        the methods that no other beats in both; all others lie below it or to its right. The \
        same methods in SIMD lanes, where that is faster, stand to the left with a line of their own.",
    caption: "Left is faster, up is more exact. No method is both faster and more exact than one \
        on the line: the left line for questions in lanes, the right one for one at a time. The \
        dashed lines meet in half_b; a method that is much slower is at the right edge, with its \
        time.",
    files: FILES,
    draw: |files| {
        let mut shown = with_hits(&read(files[0], files[1])?);
        shown.retain(|(row, _)| row.regime == "book");
        let in_lanes = in_lanes(&shown, files[1])?;
        let table = with_lanes(&shown, &in_lanes);
        // Where lanes are lost, there is nothing to see.
        let is_faster = |lane: &Measured| {
            let alone = shown.iter().find(|(row, _)| row.method == lane.0.method);
            alone.is_some_and(|(_, time)| lane.1.median_ns < time.median_ns)
        };
        let in_lanes: Vec<_> = in_lanes.into_iter().filter(is_faster).collect();
        shown.extend(in_lanes);
        let mut svg = BOOK.sheet(720.0);
        let key = spot(262.0, 33.5);
        lanes(&mut svg, "ink", key);
        svg.small_label("ink", key + spot(18.0, 4.5), Anchor::Start, "in lanes");
        Ok(Drawn {
            panels: vec![one_panel(svg, &points(&shown))],
            table,
        })
    },
};

fn one_panel(mut svg: Svg, shown: &[Point]) -> String {
    legend(&mut svg);
    // More room for the fast ones: what is much slower stands at the right edge.
    let [fastest, slowest] = range(shown);
    let one_by_one = shown.iter().filter(|one| !one.in_lanes);
    let least = one_by_one.map(|one| one.ns).fold(f64::INFINITY, f64::min);
    Plot::new([fastest, slowest.min(8.0 * least)], shown).draw(&mut svg);
    svg.finish()
}

fn points(shown: &[Measured]) -> Vec<Point> {
    shown.iter().map(Point::of).collect()
}

/// What has hit anything.
fn with_hits(measured: &[Measured]) -> Vec<Measured> {
    let has_hit = |(row, _): &&Measured| row.p999_ulps.is_some();
    measured.iter().filter(has_hit).cloned().collect()
}

/// The numbers of one question at a time, and of the same in lanes.
fn with_lanes(shown: &[Measured], in_lanes: &[Measured]) -> String {
    let heads = [
        "method",
        "ns",
        "÷ half_b",
        "instructions",
        "ns in lanes",
        "÷ half_b in lanes",
        "instructions in lanes",
        "digits",
    ];
    let times = |time: Option<&Timing>| {
        let count = time.and_then(|time| time.instructions);
        [
            time.map(|time| time.median_ns),
            time.map(|time| time.ratio),
            count,
        ]
        .map(|number| number.map_or("–".to_owned(), printed))
    };
    let row = |one: &Measured| {
        let lane = in_lanes.iter().find(|lane| lane.0.method == one.0.method);
        let mut cells = vec![format!("`{}`", one.0.method)];
        cells.extend(times(Some(&one.1)));
        cells.extend(times(lane.map(|(_, time)| time)));
        cells.push(format!("{:.1}", Point::of(one).digits));
        cells
    };
    table(1, &heads.map(str::to_owned), shown.iter().map(row))
}
