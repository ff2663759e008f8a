//! Labels that keep apart.

use glam::DVec2;

use crate::svg::{Anchor, SMALL, Svg, width};

/// A rectangle of the sheet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    least: DVec2,
    most: DVec2,
}

impl Place {
    /// From the upper left corner and the size.
    pub(super) fn new(corner: DVec2, size: DVec2) -> Self {
        Self {
            least: corner,
            most: corner + size,
        }
    }

    /// So far around a point.
    pub(super) fn around(point: DVec2, reach: f64) -> Self {
        Self::new(point - reach, DVec2::splat(2.0 * reach))
    }

    /// Along a straight line.
    pub(super) fn along(from: DVec2, to: DVec2) -> impl Iterator<Item = Self> {
        let steps = (from.distance(to) / 4.0).ceil().max(1.0) as i32;
        (0..=steps).map(move |n| Self::around(from.lerp(to, f64::from(n) / f64::from(steps)), 1.5))
    }

    fn holds(&self, other: &Self) -> bool {
        self.least.cmple(other.least).all() && other.most.cmple(self.most).all()
    }

    fn touches(&self, other: &Self) -> bool {
        self.least.cmplt(other.most).all() && other.least.cmplt(self.most).all()
    }
}

/// Finds room for one label after the other, the most important first.
pub(super) struct Labels {
    room: Place,
    taken: Vec<Place>,
    written: Vec<Place>,
}

impl Labels {
    /// Labels stay in `room` and off what is `taken`.
    pub(super) fn new(room: Place, taken: Vec<Place>) -> Self {
        Self {
            room,
            taken,
            written: Vec::new(),
        }
    }

    /// Writes `text` as near to `point` as there is room, with a line that leads
    /// to it if that is not near. The line crosses another label only if there is
    /// no other way. Where there is no room at all the label is left out.
    pub(super) fn put(&mut self, svg: &mut Svg, idea: &str, point: DVec2, text: &str) {
        let size = DVec2::new(width(text, SMALL), SMALL + 2.0);
        let free = || corners(point, size).filter(|corner| self.has_room(*corner, size));
        let clear = |corner: &DVec2| !self.crosses(leader(point, *corner, size));
        let Some(corner) = free().find(clear).or_else(|| free().next()) else {
            return;
        };
        if let Some([from, to]) = leader(point, corner, size) {
            svg.line("faint thin", from, to);
        }
        let at = corner + DVec2::new(0.0, 0.82 * SMALL + 1.0);
        svg.small_label(idea, at, Anchor::Start, text);
        self.taken.push(Place::new(corner, size));
        self.written.push(Place::new(corner, size));
    }

    fn has_room(&self, corner: DVec2, size: DVec2) -> bool {
        let place = Place::new(corner, size);
        self.room.holds(&place) && !self.taken.iter().any(|taken| taken.touches(&place))
    }

    /// Whether a line passes through a label.
    fn crosses(&self, line: Option<[DVec2; 2]>) -> bool {
        line.is_some_and(|[from, to]| {
            Place::along(from, to).any(|step| self.written.iter().any(|label| label.touches(&step)))
        })
    }
}

/// The line from `point` to a label that is not near.
fn leader(point: DVec2, corner: DVec2, size: DVec2) -> Option<[DVec2; 2]> {
    let middle = corner + 0.5 * size;
    let edge = middle + (point - middle).clamp(-0.5 * size, 0.5 * size);
    let way = (edge - point).normalize_or_zero();
    (edge.distance(point) > 9.0).then_some([point + 5.0 * way, edge])
}

/// Upper left corners for a label of that size, ever farther from `point`.
fn corners(point: DVec2, size: DVec2) -> impl Iterator<Item = DVec2> {
    (0..14).flat_map(move |ring| {
        let reach = 7.0 + 9.0 * f64::from(ring);
        // To the right first, then left, above and below, and between them.
        [
            0.0, 180.0, -90.0, 90.0, -30.0, 30.0, -150.0, 150.0, -60.0, 60.0, -120.0, 120.0,
        ]
        .into_iter()
        .map(move |degrees: f64| {
            let (sin, cos) = degrees.to_radians().sin_cos();
            let middle =
                point + DVec2::new(cos, sin) * (reach + 0.5 * size * DVec2::new(cos, sin).abs());
            middle - 0.5 * size
        })
    })
}

/// Moves `places`, in rising order, so that no two are nearer than `gap` and all
/// lie between `least` and `most`, each as little as is needed.
pub(super) fn spread(places: &[f64], gap: f64, least: f64, most: f64) -> Vec<f64> {
    let mut moved = Vec::with_capacity(places.len());
    let mut next = least;
    for place in places {
        let here = place.max(next);
        moved.push(here);
        next = here + gap;
    }
    let mut next = most;
    for place in moved.iter_mut().rev() {
        *place = place.min(next);
        next = *place - gap;
    }
    moved
}
