//! A scatter plot with its Pareto front: speed against accuracy.

use glam::DVec2;
use speed_vs_accuracy::find_regime;

use super::chart::{Chart, Drawn, size, table};
use super::labels::{Labels, Place};
use super::methods::{Measured, Point, legend, read};
use super::panel::{Measure, Panel};
use crate::number::short;
use crate::records::{Accuracy, Timing};
use crate::svg::{Anchor, Svg};
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
        let all = read(files[0], files[1])?;
        let shown = of_regime(&all, "book");
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
        let mut regimes: Vec<&str> = Vec::new();
        for one in &all {
            if !regimes.contains(&&one.accuracy.regime[..]) {
                regimes.push(&one.accuracy.regime);
            }
        }
        let mut panels = Vec::new();
        let mut rows = Vec::new();
        let points_of_all = points(&all);
        for (n, regime) in regimes.into_iter().enumerate() {
            let shown = of_regime(&all, regime);
            let title = find_regime(regime).map_or(regime, |regime| regime.title);
            panels.push(small_panel(n, title, &points(&shown), &points_of_all));
            rows.extend(shown);
        }
        Ok(Drawn {
            panels,
            table: numbers(&rows),
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
    let svg = Svg::new("scene", &title, description, size(720.0));
    let digits = "digits of the worst hit point that are right";
    one_panel(svg, digits, "has wrong pixels", shown)
}

fn one_panel(mut svg: Svg, digits: &str, wrong: &str, shown: &[Point]) -> String {
    let top = 50.0 + legend(&mut svg, wrong);
    let corner = DVec2::new(28.0, top);
    let size = DVec2::new(354.0, 676.0 - top);
    // More room for the fast ones: what is much slower stands at the right edge.
    let slowest = 8.0 * shown.iter().map(|one| one.ns).fold(f64::INFINITY, f64::min);
    let plot = Plot {
        panel: panel(
            digits,
            corner,
            size,
            shown.iter().map(|one| one.ns.min(slowest)),
        ),
        shown,
        front: front(shown),
        slowest,
        name_all: true,
    };
    plot.draw(&mut svg);
    svg.finish()
}

/// A situation on scales that are wide enough for `all`; the marks are explained in the first.
fn small_panel(n: usize, title: &str, shown: &[Point], all: &[Point]) -> String {
    let mut svg = match n {
        0 => REGIMES.panel(1, title, 334.0),
        _ => REGIMES.panel(n + 1, title, 296.0),
    };
    let top = if n == 0 {
        56.0 + legend(&mut svg, CONFUSED)
    } else {
        56.0
    };
    svg.label("ink", DVec2::new(4.0, top - 34.0), Anchor::Start, title);
    let (corner, size) = (DVec2::new(28.0, top), DVec2::new(354.0, 196.0));
    let plot = Plot {
        panel: panel(DIGITS, corner, size, all.iter().map(|one| one.ns)),
        shown,
        front: front(shown),
        slowest: f64::INFINITY,
        name_all: false,
    };
    plot.draw(&mut svg);
    svg.finish()
}

fn panel(
    digits: &str,
    corner: DVec2,
    size: DVec2,
    times: impl Iterator<Item = f64> + Clone,
) -> Panel {
    let times = Measure::logarithmic("nanoseconds for one test", times);
    let digits = Measure::linear(digits, -1.0, 17.0, 4.0);
    Panel::new(corner, size, times, digits)
}

fn points(shown: &[Measured]) -> Vec<Point> {
    shown.iter().map(Measured::point).collect()
}

fn of_regime(all: &[Measured], regime: &str) -> Vec<Measured> {
    let of_regime = |one: &&Measured| one.accuracy.regime == regime;
    let has_hit = |one: &&Measured| one.accuracy.p999_ulps.is_some();
    let of = all.iter().filter(of_regime).filter(has_hit);
    of.cloned().collect()
}

/// A panel, and what is drawn in it.
struct Plot<'a> {
    panel: Panel,
    shown: &'a [Point],
    front: Vec<&'a Point>,
    /// What is slower than this stands at the right edge.
    slowest: f64,
    name_all: bool,
}

impl Plot<'_> {
    fn at(&self, one: &Point) -> DVec2 {
        let shown = one.ns.min(self.slowest);
        self.panel.at(shown, one.digits)
    }

    fn draw(&self, svg: &mut Svg) {
        self.panel.draw(svg);
        let steps = steps(self.front.iter().map(|one| self.at(one)));
        svg.path("front line", &steps);
        let mut lines = vec![steps];
        for ends in self.through_reference() {
            svg.line("reference dashed", ends[0], ends[1]);
            lines.push(ends.to_vec());
        }
        let pairs = lines.iter().flat_map(|line| line.windows(2));
        let along = pairs.flat_map(|ends| Place::along(ends[0], ends[1]));
        let marks = self
            .shown
            .iter()
            .map(|one| Place::around(self.at(one), 6.0));
        let (corner, size) = (self.panel.corner, self.panel.size);
        let room = Place::new(corner - DVec2::new(0.0, 8.0), size + DVec2::new(16.0, 8.0));
        let labels = Labels {
            room,
            lines: along.collect(),
            taken: marks.collect(),
        };
        self.draw_methods(svg, labels);
    }

    /// The two lines that meet in `half_b`.
    fn through_reference(&self) -> Vec<[DVec2; 2]> {
        let Some(reference) = self.shown.iter().find(|one| one.idea() == "reference") else {
            return Vec::new();
        };
        let DVec2 { x, y } = self.at(reference);
        let (low, high) = (self.panel.corner, self.panel.corner + self.panel.size);
        vec![
            [DVec2::new(x, low.y), DVec2::new(x, high.y)],
            [DVec2::new(low.x, y), DVec2::new(high.x, y)],
        ]
    }

    fn draw_methods(&self, svg: &mut Svg, mut labels: Labels) {
        let mut sorted: Vec<&Point> = self.shown.iter().collect();
        // The most important ones in front, and named first.
        sorted.sort_by_key(|one| IDEAS.iter().position(|idea| *idea == one.idea()));
        for one in sorted.iter().rev() {
            one.mark(svg, self.at(one));
        }
        for one in sorted {
            let named = self.name_all || one.idea() != "ink" || self.front.contains(&one);
            if one.ns > self.slowest {
                let text = format!("{}, {:.0} ns →", one.method, one.ns);
                labels.put(svg, one.idea(), self.at(one), &text);
            } else if named {
                labels.put(svg, one.idea(), self.at(one), &one.method);
            }
        }
    }
}

/// What marks can say, the most important first.
const IDEAS: [&str; 3] = ["reference", "certain", "ink"];

/// The methods that no other beats in both speed and accuracy, the fastest
/// first. To be fast and have no digit right is not worth a place.
fn front(shown: &[Point]) -> Vec<&Point> {
    let mut sorted: Vec<&Point> = shown.iter().filter(|one| one.digits >= 1.0).collect();
    sorted.sort_by(|one, other| {
        one.ns
            .total_cmp(&other.ns)
            .then(other.digits.total_cmp(&one.digits))
    });
    let mut best: Vec<&Point> = Vec::new();
    for one in sorted {
        if best.last().is_none_or(|last| one.digits > last.digits) {
            best.push(one);
        }
    }
    best
}

/// Stairs through `points`: what lies below and to the right of a step is
/// beaten.
fn steps(points: impl Iterator<Item = DVec2>) -> Vec<DVec2> {
    let mut stairs: Vec<DVec2> = Vec::new();
    for point in points {
        if let Some(last) = stairs.last() {
            stairs.push(DVec2::new(point.x, last.y));
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
        vec![
            one.accuracy.regime.replace('_', " "),
            format!("`{}`", one.method()),
            format!("{:.2}", one.time.median_ns),
            format!("{:.2}", one.time.ratio),
            format!("{:.1}", one.digits()),
            one.accuracy.p999_ulps.map_or("none".to_owned(), short),
            short(one.accuracy.wrong_per_million),
        ]
    };
    table(2, &heads.map(str::to_owned), shown.iter().map(row))
}
