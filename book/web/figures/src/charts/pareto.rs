//! A scatter plot with its Pareto front: the methods that no other beats.

use glam::DVec2;

use super::labels::{Label, Place, write};
use super::methods::Point;
use super::panel::{Measure, Panel};
use crate::svg::{Step, Svg, spot};

/// A panel, and what is drawn in it.
pub(super) struct Plot<'a> {
    panel: Panel,
    shown: &'a [Point],
}

impl<'a> Plot<'a> {
    /// A panel below the marks that are explained, for times in that range.
    pub(super) fn new([fastest, slowest]: [f64; 2], shown: &'a [Point]) -> Self {
        let title = "nanoseconds for one test";
        let times = Measure::logarithmic(title, fastest / 1.25, slowest * 1.25);
        let digits = Measure::linear("digits of *t* that are right", -1.0, 17.0, 4.0);
        Self {
            panel: Panel::new(spot(28.0, 88.0), spot(354.0, 588.0), times, digits),
            shown,
        }
    }

    fn at(&self, one: &Point) -> DVec2 {
        self.panel.at(one.ns, one.digits)
    }

    pub(super) fn draw(&self, svg: &mut Svg) {
        self.panel.draw(svg);
        let mut lines = self.through_reference();
        let fronts = [false, true].map(|in_lanes| front(self.shown, in_lanes));
        for front in &fronts {
            lines.push(("front line", steps(front.iter().map(|one| self.at(one)))));
        }
        for (class, points) in lines.iter().filter(|(_, points)| points.len() > 1) {
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
        let labels: Vec<Label> = sorted.iter().map(|one| self.label(one)).collect();
        write(svg, room, marks.chain(along).collect(), &labels);
    }

    /// The name of a method, at the right edge with its time.
    fn label(&self, one: &Point) -> Label {
        let text = if one.ns > self.panel.x.axis.most {
            format!("{}, {:.0} ns →", one.method, one.ns)
        } else if one.in_lanes {
            format!("{} in lanes", one.method)
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

/// The least and the greatest time.
pub(super) fn range(points: &[Point]) -> [f64; 2] {
    let times = points.iter().map(|one| one.ns);
    times.fold([f64::INFINITY, 0.0], |[least, most], ns| {
        [ns.min(least), ns.max(most)]
    })
}

/// What marks can say, the most important first.
const IDEAS: [&str; 3] = ["reference", "certain", "ink"];

/// The methods that no other beats in both speed and accuracy, the fastest
/// first. To be fast and have no digit right is not worth a place.
fn front(shown: &[Point], in_lanes: bool) -> Vec<&Point> {
    let is_asked = |one: &&Point| one.in_lanes == in_lanes && one.digits >= 1.0;
    let mut front: Vec<&Point> = shown.iter().filter(is_asked).collect();
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
