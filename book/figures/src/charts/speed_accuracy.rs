//! A scatter plot with its Pareto front: speed against accuracy.

use glam::DVec2;
use speed_vs_accuracy::find_regime;

use super::chart::{Chart, Drawn, table};
use super::labels::{Label, Place, write};
use super::methods::{Measured, Point, legend, read};
use super::panel::{Measure, Panel};
use crate::number::printed;
use crate::records::{Accuracy, Timing};
use crate::svg::{Anchor, Step, Svg, spot};
use crate::table::Record;

const FILES: &[&str] = &[Accuracy::FILE, Timing::FILE];

const DIGITS: &str = "digits of *t* that are right";

/// What a cross means there.
const CONFUSED: &str = "confuses some hits and misses";

/// The book's own rays.
pub(super) const BOOK: Chart = Chart {
    name: "speed_accuracy",
    title: "Speed against accuracy, on the rays of the book",
    description: "A point for each method: how long a test takes, from left to right, and how many \
        digits of t are right, upwards. The methods in f32 lie far below those in f64. A line joins \
        the methods that no other beats in both; all others lie below it or to its right.",
    caption: "Left is faster, up is more exact. No method is both faster and more exact than one \
        on the line. The dashed lines meet in half_b; a method that is much slower is at the \
        right edge, with its time.",
    files: FILES,
    draw: |files| {
        let mut shown = with_hits(&read(files[0], files[1])?);
        shown.retain(|(row, _)| row.regime == "book");
        let svg = BOOK.sheet(720.0);
        Ok(Drawn {
            panels: vec![one_panel(svg, DIGITS, CONFUSED, &points(&shown))],
            table: numbers(&shown),
        })
    },
};

/// All situations as small panels.
pub(super) const REGIMES: Chart = Chart {
    name: "speed_accuracy_regimes",
    title: "Speed against accuracy, situation by situation",
    description: "The same chart for each situation, in small panels with equal scales. Far away, \
        near a tangent and close to a surface most plain methods lose digits, and many get crosses. \
        certified_t stays at the top and moves to the right. certified_hit never has a cross.",
    caption: "The same for every situation, with the same scales. The methods that no other \
        beats, the reference, and the certified ones have names here; the table names all.",
    files: FILES,
    draw: |files| {
        let all = read(files[0], files[1])?;
        let situations = all.chunk_by(|(one, _), (other, _)| one.regime == other.regime);
        let situations: Vec<_> = situations.map(with_hits).collect();
        let panel = |(n, shown): (usize, &Vec<Measured>)| small_panel(n, shown, &all);
        Ok(Drawn {
            panels: situations.iter().enumerate().map(panel).collect(),
            table: numbers(&situations.concat()),
        })
    },
};

/// A chart of one scene, as a drawing for a wide page: how long a question takes, and
/// how many digits of the hit point are right where it is worst. A cross means wrong
/// pixels.
pub fn scene_chart(name: &str, shown: &[Point]) -> String {
    let title = format!("Speed against accuracy: {name}");
    let description = "A point for each method: how long a question takes, from left to right, and \
        how many digits of the worst hit point are right, upwards. A method with wrong pixels has a \
        cross. A line joins the methods that no other beats in both.";
    let svg = Svg::new("scene", &title, description, 720.0);
    let digits = "digits of the worst hit point that are right";
    one_panel(svg, digits, "has wrong pixels", shown)
}

fn one_panel(mut svg: Svg, digits: &str, wrong: &str, shown: &[Point]) -> String {
    legend(&mut svg, wrong);
    // More room for the fast ones: what is much slower stands at the right edge.
    let [fastest, slowest] = range(shown);
    let range = [fastest, slowest.min(8.0 * fastest)];
    let plot = Plot {
        panel: panel(digits, 88.0, 588.0, range),
        shown,
        name_all: true,
    };
    plot.draw(&mut svg);
    svg.finish()
}

/// A situation on scales that are wide enough for `all`; the marks are explained in the first.
fn small_panel(n: usize, shown: &[Measured], all: &[Measured]) -> String {
    let regime = &shown[0].0.regime;
    let title = find_regime(regime).map_or(&regime[..], |regime| regime.title);
    let explained = if n == 0 { 38.0 } else { 0.0 };
    let mut svg = REGIMES.panel(n + 1, title, 296.0 + explained);
    if n == 0 {
        legend(&mut svg, CONFUSED);
    }
    let top = 56.0 + explained;
    svg.label("ink", spot(4.0, top - 34.0), Anchor::Start, title);
    let plot = Plot {
        panel: panel(DIGITS, top, 196.0, range(&points(all))),
        shown: &points(shown),
        name_all: false,
    };
    plot.draw(&mut svg);
    svg.finish()
}

/// The least and the greatest time.
fn range(points: &[Point]) -> [f64; 2] {
    let times = points.iter().map(|one| one.ns);
    times.fold([f64::INFINITY, 0.0], |[least, most], ns| {
        [ns.min(least), ns.max(most)]
    })
}

/// A panel of that height, so far below the upper edge of the sheet.
fn panel(digits: &str, top: f64, height: f64, [fastest, slowest]: [f64; 2]) -> Panel {
    let title = "nanoseconds for one test";
    let times = Measure::logarithmic(title, fastest / 1.25, slowest * 1.25);
    let digits = Measure::linear(digits, -1.0, 17.0, 4.0);
    Panel::new(spot(28.0, top), spot(354.0, height), times, digits)
}

fn points(shown: &[Measured]) -> Vec<Point> {
    shown.iter().map(Point::of).collect()
}

/// What has hit anything.
fn with_hits(measured: &[Measured]) -> Vec<Measured> {
    let has_hit = |(row, _): &&Measured| row.p999_ulps.is_some();
    measured.iter().filter(has_hit).cloned().collect()
}

/// A panel, and what is drawn in it.
struct Plot<'a> {
    panel: Panel,
    shown: &'a [Point],
    name_all: bool,
}

impl Plot<'_> {
    fn at(&self, one: &Point) -> DVec2 {
        self.panel.at(one.ns, one.digits)
    }

    fn draw(&self, svg: &mut Svg) {
        self.panel.draw(svg);
        let mut lines = self.through_reference();
        let front = front(self.shown);
        lines.push(("front line", steps(front.iter().map(|one| self.at(one)))));
        for (class, points) in &lines {
            svg.path(class, points);
        }
        let mut sorted: Vec<&Point> = self.shown.iter().collect();
        // The most important ones in front, and named first.
        sorted.sort_by_key(|one| IDEAS.iter().position(|idea| *idea == one.idea()));
        for one in sorted.iter().rev() {
            one.mark(svg, self.at(one));
        }
        let marks = sorted.iter().map(|one| Place::around(self.at(one), 6.0));
        let pairs = lines.iter().flat_map(|(_, points)| points.windows(2));
        let along = pairs.flat_map(|ends| Place::along(ends[0], ends[1]));
        let (low, high) = self.corners();
        let room = Place(low.down(-8.0), high.right(16.0));
        let is_named = |one: &Point| self.name_all || one.idea() != "ink" || front.contains(&one);
        let labels: Vec<Label> = sorted
            .iter()
            .filter(|one| is_named(one))
            .map(|one| self.label(one))
            .collect();
        write(svg, room, marks.chain(along).collect(), &labels);
    }

    /// The name of a method, at the right edge with its time.
    fn label(&self, one: &Point) -> Label {
        let text = if one.ns > self.panel.x.axis.most {
            format!("{}, {:.0} ns →", one.method, one.ns)
        } else {
            one.method.clone()
        };
        (one.idea(), self.at(one), text)
    }

    /// The two lines that meet in `half_b`.
    fn through_reference(&self) -> Vec<(&str, Vec<DVec2>)> {
        let Some(reference) = self.shown.iter().find(|one| one.idea() == "reference") else {
            return Vec::new();
        };
        let DVec2 { x, y } = self.at(reference);
        let (low, high) = self.corners();
        vec![
            ("reference dashed", vec![spot(x, low.y), spot(x, high.y)]),
            ("reference dashed", vec![spot(low.x, y), spot(high.x, y)]),
        ]
    }

    fn corners(&self) -> (DVec2, DVec2) {
        (self.panel.corner, self.panel.corner + self.panel.size)
    }
}

/// What marks can say, the most important first.
const IDEAS: [&str; 3] = ["reference", "certain", "ink"];

/// The methods that no other beats in both speed and accuracy, the fastest
/// first. To be fast and have no digit right is not worth a place.
fn front(shown: &[Point]) -> Vec<&Point> {
    let mut front: Vec<&Point> = shown.iter().filter(|one| one.digits >= 1.0).collect();
    front.sort_by(|one, other| {
        let by_digits = other.digits.total_cmp(&one.digits);
        one.ns.total_cmp(&other.ns).then(by_digits)
    });
    let mut best = 0.0;
    front.retain(|one| {
        let is_better = one.digits > best;
        best = one.digits.max(best);
        is_better
    });
    front
}

/// Stairs through `points`: what lies below and to the right of a step is
/// beaten.
fn steps(points: impl Iterator<Item = DVec2>) -> Vec<DVec2> {
    let mut stairs: Vec<DVec2> = Vec::new();
    for point in points {
        if let Some(last) = stairs.last() {
            stairs.push(spot(point.x, last.y));
        }
        stairs.push(point);
    }
    stairs
}

fn numbers(shown: &[Measured]) -> String {
    let heads = [
        "situation",
        "method",
        "ns",
        "÷ half_b",
        "digits",
        "ulps, 99.9 %",
        "✗ per million",
    ];
    let row = |one: &Measured| {
        let (row, time) = one;
        vec![
            row.regime.replace('_', " "),
            format!("`{}`", row.method),
            format!("{:.2}", time.median_ns),
            format!("{:.2}", time.ratio),
            format!("{:.1}", Point::of(one).digits),
            row.p999_ulps.map_or("none".to_owned(), printed),
            printed(row.wrong_per_million),
        ]
    };
    table(2, &heads.map(str::to_owned), shown.iter().map(row))
}
