//! Label placement without overlap (greedy): each label takes the nearest room that is left.

use glam::DVec2;

use crate::svg::{Anchor, Step, Svg};
use crate::text::{SMALL, width};

/// A rectangle of the sheet: the upper left corner, and the lower right one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place(pub(super) DVec2, pub(super) DVec2);

impl Place {
    /// So far around a point.
    pub(super) fn around(point: DVec2, reach: f64) -> Self {
        Self(point - reach, point + reach)
    }

    /// Along a straight line.
    pub(super) fn along(from: DVec2, to: DVec2) -> impl Iterator<Item = Self> {
        let steps = (from.distance(to) / 4.0).ceil() as i32;
        (0..=steps).map(move |n| Self::around(from.lerp(to, f64::from(n) / f64::from(steps)), 1.5))
    }

    fn holds(&self, other: &Self) -> bool {
        self.0.cmple(other.0).all() && other.1.cmple(self.1).all()
    }

    fn touches(&self, other: &Self) -> bool {
        self.0.cmplt(other.1).all() && other.0.cmplt(self.1).all()
    }
}

/// A label: its idea, the point that it names, and its text.
pub(super) type Label = (&'static str, DVec2, String);

/// Writes each label near its point, with a line that leads to it if that is not very near:
/// in the `room`, and off marks and lines that have `taken` theirs. The first ones choose
/// first, and one that finds no room at all is left out.
pub(super) fn write(svg: &mut Svg, room: Place, mut taken: Vec<Place>, labels: &[Label]) {
    let mut written = Vec::new();
    for (idea, point, text) in labels {
        let size = DVec2::new(width(text, SMALL), SMALL + 2.0);
        let mut places = corners(*point, size).map(|corner| Place(corner, corner + size));
        let is_free =
            |place: &Place| room.holds(place) && !taken.iter().any(|it| it.touches(place));
        let Some(place) = places.find(is_free) else {
            continue;
        };
        let edge = point.clamp(place.0, place.1);
        if edge.distance(*point) > 9.0 {
            let rim = point + 5.0 * (edge - point).normalize();
            svg.line("faint thin", rim, edge);
        }
        taken.push(place);
        written.push((idea, place, text));
    }
    // After all lines, so that none goes through a label.
    for (idea, place, text) in written {
        let line = place.0.down(0.82 * SMALL + 1.0);
        svg.small_label(idea, line, Anchor::Start, text);
    }
}

/// Upper left corners for a label of that size, ever farther from `point`.
fn corners(point: DVec2, size: DVec2) -> impl Iterator<Item = DVec2> {
    (0..9).flat_map(move |ring| {
        let reach = 7.0 + 9.0 * f64::from(ring);
        // To the right first, and then around.
        (0..24).map(move |n| {
            let way = DVec2::from_angle((15.0 * f64::from(n)).to_radians());
            point + way * (reach + 0.5 * size * way.abs()) - 0.5 * size
        })
    })
}

/// Moves `places`, in rising order, so that no two are nearer than `gap` and all
/// lie between `least` and `most`, each as little as is needed.
pub(super) fn spread(places: &[f64], gap: f64, least: f64, most: f64) -> Vec<f64> {
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
