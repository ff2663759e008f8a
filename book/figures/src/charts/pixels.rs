//! Order statistics as ranges: median, 99.9th percentile and largest error over all
//! pixels.

use std::fmt::Write;

use glam::DVec2;
use speed_vs_accuracy::{METHODS, Method};

use super::axes::{Axis, Panel};
use super::chart::{Chart, Drawn, Layout};
use super::methods::{idea, mark};
use crate::number::short;
use crate::records::Accuracy;
use crate::svg::{Anchor, Svg};
use crate::table::{Record, Table};

/// All methods on the two spheres of the book.
pub(super) const CHART: Chart = Chart {
    name: "pixels",
    title: "How far off t is, over all pixels of the book's picture",
    description: "A line for each method on the ball, and one on the ground, from the median error \
        to the largest, with a mark between at what 999 of 1000 hits do not exceed. On the ball all \
        in plain f64 are alike. On the ground the line of half_b_q begins a digit before that of \
        half_b and ends where that ends; those of haines, haines_q and cross_q go on for two digits \
        more.",
    caption: "Each line begins at the median error of a method and ends at the largest; at the mark \
        are 999 of 1000 hits. The unit is that of the method's own numbers: an ulp of an f32 is 2²⁹ of \
        an f64.",
    files: &[Accuracy::FILE],
    draw: |files| draw(files[0]),
};

const SPHERES: [(&str, &str); 2] = [("book_ball", "the ball"), ("book_ground", "the ground")];

const TOP: f64 = 44.0;
const LINE: f64 = 19.0;

/// A method, and its row for each of the spheres.
type Line = (&'static str, [Accuracy; 2]);

fn draw(file: &str) -> Result<Drawn, String> {
    let rows = Table::<Accuracy>::read(file)?.rows;
    let of = |sphere: &str, method: &str| {
        rows.iter()
            .find(|row| row.regime == sphere && row.method == method)
            .cloned()
            .ok_or_else(|| format!("{}: no {method} in {sphere}", Accuracy::FILE))
    };
    let [ball, ground] = SPHERES.map(|(sphere, _)| sphere);
    let line = |method: &Method| -> Result<Line, String> {
        let rows = [of(ball, method.name)?, of(ground, method.name)?];
        Ok((method.name, rows))
    };
    let lines: Vec<Line> = METHODS.iter().map(line).collect::<Result<_, _>>()?;
    Ok(Drawn::new(table(&lines), |layout| panels(layout, &lines)))
}

/// The spheres beside each other, or one below the other.
fn panels(layout: Layout, lines: &[Line]) -> String {
    let height = LINE * lines.len() as f64;
    let below = TOP + height + 42.0;
    let mut svg = CHART.sheet(layout, layout.choose(below, 2.0 * below));
    let corners = layout.choose(
        [(170.0, TOP), (450.0, TOP)],
        [(152.0, TOP), (152.0, below + TOP)],
    );
    for (n, (corner, (_, title))) in corners.into_iter().zip(SPHERES).enumerate() {
        let panel = panel(
            corner.into(),
            DVec2::new(layout.choose(250.0, 176.0), height),
        );
        panel.draw(&mut svg);
        let above = panel.corner + DVec2::new(0.0, -12.0);
        svg.label("ink", above, Anchor::Start, title);
        for ((method, rows), place) in lines.iter().zip(0..) {
            let y = panel.corner.y + LINE * (f64::from(place) + 0.5);
            if n == 0 || layout == Layout::Narrow {
                let name = DVec2::new(panel.corner.x - layout.choose(10.0, 6.0), y + 4.0);
                svg.small_label(idea(method), name, Anchor::End, method);
            }
            range(&mut svg, &panel, &rows[n], y);
        }
    }
    svg.finish()
}

fn table(lines: &[Line]) -> String {
    let mut table = TABLE_HEAD.to_owned();
    for (method, rows) in lines {
        let _ = write!(table, "| `{method}` |");
        for ulps in rows.iter().flat_map(errors) {
            let _ = write!(table, " {} |", short(ulps));
        }
        table.push('\n');
    }
    table
}

/// From a tenth of an ulp to a hundred thousand.
fn panel(corner: DVec2, size: DVec2) -> Panel {
    let ticks = [(0, "1"), (1, "10"), (2, "100"), (3, "1000"), (4, "10 000")];
    let ticks = ticks.map(|(exponent, words)| (10_f64.powi(exponent), words.to_owned()));
    Panel {
        corner,
        size,
        x: Axis::logarithmic("ulps", [0.2, 1e5].into_iter()).with_ticks(ticks.into()),
        y: Axis::linear("", 0.0, 1.0, 1.0).with_ticks(Vec::new()),
    }
}

fn range(svg: &mut Svg, panel: &Panel, row: &Accuracy, y: f64) {
    let [median, most, largest] = errors(row).map(|ulps| DVec2::new(panel.at(ulps, 0.0).x, y));
    let idea = idea(&row.method);
    svg.line(&format!("{idea} line"), median, largest);
    mark(svg, idea, row.precision, most);
}

/// Median, 99.9th percentile, largest.
fn errors(row: &Accuracy) -> [f64; 3] {
    [row.median_ulps, row.p999_ulps, row.largest_ulps].map(|ulps| ulps.unwrap_or(f64::INFINITY))
}

const TABLE_HEAD: &str = "\
| ulps of *t* | ball: median | 99.9 % | largest | ground: median | 99.9 % | largest |
|---|---:|---:|---:|---:|---:|---:|
";
