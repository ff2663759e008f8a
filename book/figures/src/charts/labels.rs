//! Label placement without overlap (greedy): each label takes the nearest room that is left.

use glam::DVec2;

use crate::svg::{Anchor, Svg};
use crate::text::{SMALL, width};

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

    fn touches_any(&self, others: &[Self]) -> bool {
        others.iter().any(|other| other.touches(self))
    }

    /// The line from a point to a label here that is not near.
    fn leader(&self, point: DVec2) -> Option<[DVec2; 2]> {
        let edge = point.clamp(self.least, self.most);
        let way = (edge - point).normalize_or_zero();
        (edge.distance(point) > 9.0).then_some([point + 5.0 * way, edge])
    }
}

/// Finds room for one label after the other, the most important first.
pub(super) struct Labels {
    /// Labels stay in here,
    pub(super) room: Place,
    /// off these lines,
    pub(super) lines: Vec<Place>,
    /// and off marks and other labels, through which no leader goes either.
    pub(super) taken: Vec<Place>,
}

impl Labels {
    /// Writes `text` near `point`, with a line that leads to it if that is not very near.
    /// Where there is no room at all the label is left out.
    pub(super) fn put(&mut self, svg: &mut Svg, idea: &str, point: DVec2, text: &str) {
        let size = DVec2::new(width(text, SMALL), SMALL + 2.0);
        let mut places = corners(point, size).map(|corner| Place::new(corner, size));
        let Some(place) = places.find(|place| self.is_free(place, point)) else {
            return;
        };
        if let Some([from, to]) = place.leader(point) {
            svg.line("faint thin", from, to);
            self.lines.extend(Place::along(from, to));
        }
        let at = place.least + DVec2::new(0.0, 0.82 * SMALL + 1.0);
        svg.small_label(idea, at, Anchor::Start, text);
        self.taken.push(place);
    }

    fn is_free(&self, place: &Place, point: DVec2) -> bool {
        let own = Place::around(point, 1.0);
        // A leader begins in the mark of its own point.
        let is_in_the_way = |step: &Place| {
            let mut others = self.taken.iter().filter(|it| !it.touches(&own));
            others.any(|it| it.touches(step))
        };
        let is_clear =
            |[from, to]: [DVec2; 2]| !Place::along(from, to).any(|it| is_in_the_way(&it));
        self.room.holds(place)
            && !place.touches_any(&self.lines)
            && !place.touches_any(&self.taken)
            && place.leader(point).is_none_or(is_clear)
    }
}

/// Upper left corners for a label of that size, ever farther from `point`.
fn corners(point: DVec2, size: DVec2) -> impl Iterator<Item = DVec2> {
    (0..14).flat_map(move |ring| {
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
