//! Three kinds of error side by side: digits, places and decisions.

use std::fmt::Write;

use glam::DVec2;
use speed_vs_accuracy::{Method, Precision, REGIMES, Regime};

use super::axes::{Axis, Panel};
use super::chart::{Chart, Drawn, Layout};
use super::methods::{digits, idea, mark};
use crate::number::short;
use crate::records::Accuracy;
use crate::svg::{Anchor, Svg};
use crate::table::{Record, Table};

/// The methods of the lesson, situation by situation, in three panels.
pub(super) const CHART: Chart = Chart {
    name: "seen",
    title: "Three kinds of error, situation by situation",
    description: "Four methods in each of seven situations. At the left how many digits of t are \
        right, in the middle how far the hit point is from the surface, at the right how many \
        decisions of a million are wrong. Rays that leave the surface lose all digits of t by all \
        methods but adaptive_q, and their hit points are as near the surface as any. Of a sphere far \
        away, half_b and half_b_q put the hit point millions of radii beside it.",
    caption: "Digits of t, distance of the hit point from the surface, and wrong decisions: the \
        first two as 999 of 1000 hits have them or better. Only the second and the third can be seen \
        in a picture.",
    files: &[Accuracy::FILE],
    draw: |files| draw(files[0]),
};

/// The methods that the lesson of chapter 6 is about, from chapter 5 on.
pub(super) const LESSON: [Method; 4] = [
    Method::HALF_B,
    Method::HALF_B_Q,
    Method::CROSS_Q,
    Method::ADAPTIVE_Q,
];

const TOP: f64 = 44.0;
const LINE: f64 = 16.0;
const SITUATION: f64 = 26.0 + LINE * LESSON.len() as f64;

fn draw(file: &str) -> Result<Drawn, String> {
    let rows = Table::<Accuracy>::read(file)?.rows;
    let of = |regime: &str, method: &Method| {
        rows.iter()
            .find(|row| row.regime == regime && row.method == method.name)
            .cloned()
            .ok_or_else(|| format!("{}: no {} in {regime}", Accuracy::FILE, method.name))
    };
    let mut situations: Vec<Situation> = Vec::new();
    for Regime { name, title, .. } in REGIMES {
        let rows = LESSON.iter().map(|method| of(name, method));
        situations.push((title, rows.collect::<Result<_, _>>()?));
    }
    let rows = situations.iter().flat_map(|(_, rows)| rows);
    let table = TABLE_HEAD.to_owned() + &rows.map(table_row).collect::<String>();
    Ok(Drawn::new(table, |layout| drawn(layout, &situations)))
}

/// The title of a regime, and a row for each method of the lesson.
type Situation = (&'static str, Vec<Accuracy>);

/// The panels beside each other with one column of names, or each below the other with
/// its own.
fn drawn(layout: Layout, situations: &[Situation]) -> String {
    let height = SITUATION * situations.len() as f64;
    let below = TOP + height + 42.0;
    let mut svg = CHART.sheet(layout, layout.choose(below, 3.0 * below));
    let corners = layout.choose(
        [(150.0, TOP), (345.0, TOP), (540.0, TOP)],
        [
            (100.0, TOP),
            (100.0, below + TOP),
            (100.0, 2.0 * below + TOP),
        ],
    );
    let size = DVec2::new(layout.choose(160.0, 220.0), height);
    for (n, panel) in panels(corners.map(DVec2::from), size).iter().enumerate() {
        panel.draw(&mut svg);
        let is_named = n == 0 || layout == Layout::Narrow;
        for ((title, rows), place) in situations.iter().zip(0..) {
            let y = panel.corner.y + SITUATION * f64::from(place);
            if is_named {
                let at = DVec2::new(layout.choose(12.0, 4.0), y + 14.0);
                svg.label("ink", at, Anchor::Start, title);
            }
            for (row, place) in rows.iter().zip(0..) {
                let y = y + 18.0 + LINE * (f64::from(place) + 0.5);
                line(&mut svg, panel, row, errors(row)[n], y, is_named);
            }
        }
    }
    svg.finish()
}

/// Digits, radii on a logarithmic scale, and decisions of a million on another, whose
/// left end is none.
fn panels(corners: [DVec2; 3], size: DVec2) -> [Panel; 3] {
    let power = |exponent: i32, words: &str| (10_f64.powi(exponent), words.to_owned());
    let ends = |least: i32, most: i32| [10_f64.powi(least), 10_f64.powi(most)].into_iter();
    let radii = [(-16, "10⁻¹⁶"), (-8, "10⁻⁸"), (0, "1"), (8, "10⁸")];
    let decisions = [(-1, "none"), (1, "10"), (3, "1000"), (5, "100 000")];
    let titled = |title: &str| Axis::linear(title, 0.0, 1.0, 1.0).with_ticks(Vec::new());
    let axes = [
        (
            titled("digits of *t* that are right"),
            Axis::linear("of sixteen", 0.0, 17.0, 4.0),
        ),
        (
            titled("hit point off the surface by"),
            Axis::logarithmic("radii", ends(-18, 8))
                .with_ticks(radii.map(|(exponent, words)| power(exponent, words)).into()),
        ),
        (
            titled("decisions that are wrong"),
            Axis::logarithmic("of a million", ends(-1, 6)).with_ticks(
                decisions
                    .map(|(exponent, words)| power(exponent, words))
                    .into(),
            ),
        ),
    ];
    let mut corners = corners.into_iter();
    axes.map(|(y, x)| Panel {
        corner: corners.next().unwrap_or_default(),
        size,
        x,
        y,
    })
}

/// A method in one situation: a mark at its `value`, and its name if it is wanted.
fn line(svg: &mut Svg, panel: &Panel, row: &Accuracy, value: f64, y: f64, is_named: bool) {
    let idea = idea(&row.method);
    if is_named {
        let name = DVec2::new(panel.corner.x - 12.0, y + 4.0);
        svg.small_label(idea, name, Anchor::End, &row.method);
    }
    let end = DVec2::new(panel.at(value, 0.0).x, y);
    svg.line("faint thin", DVec2::new(panel.corner.x, y), end);
    mark(svg, idea, Precision::Double, end);
}

/// Digits, radii, and wrong decisions.
fn errors(row: &Accuracy) -> [f64; 3] {
    [
        digits(row.p999_ulps, row.precision),
        row.surface_p999_radii.unwrap_or(f64::INFINITY),
        row.wrong_per_million,
    ]
}

const TABLE_HEAD: &str = "\
| situation | method | digits of *t* | radii off the surface | ✗ per million |
|---|---|---:|---:|---:|
";

fn table_row(row: &Accuracy) -> String {
    let [digits, radii, wrong] = errors(row);
    let mut line = String::new();
    let _ = writeln!(
        line,
        "| {} | `{}` | {digits:.1} | {radii:.1e} | {} |",
        row.regime.replace('_', " "),
        row.method,
        short(wrong)
    );
    line
}
