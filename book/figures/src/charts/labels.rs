//! Label placement without overlap (greedy).

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
    lines: Vec<Place>,
    marks: Vec<Place>,
    written: Vec<Place>,
    leaders: Vec<Place>,
}

impl Labels {
    /// Labels stay in `room` and off lines and marks.
    pub(super) fn new(room: Place, lines: Vec<Place>, marks: Vec<Place>) -> Self {
        Self {
            room,
            lines,
            marks,
            written: Vec::new(),
            leaders: Vec::new(),
        }
    }

    /// Writes `text` where it is best seen to belong to `point`, with a line that
    /// leads to it if that is not near. Where there is no room at all the label
    /// is left out.
    pub(super) fn put(&mut self, svg: &mut Svg, idea: &str, point: DVec2, text: &str) {
        let size = DVec2::new(width(text, SMALL), SMALL + 2.0);
        let best = corners(point, size)
            .filter(|corner| self.has_room(&Place::new(*corner, size)))
            .map(|corner| (self.doubt(point, corner, size), corner))
            .min_by(|one, other| one.0.total_cmp(&other.0));
        let Some((_, corner)) = best else {
            return;
        };
        if let Some([from, to]) = leader(point, corner, size) {
            svg.line("faint thin", from, to);
            self.leaders.extend(Place::along(from, to));
        }
        let at = corner + DVec2::new(0.0, 0.82 * SMALL + 1.0);
        svg.small_label(idea, at, Anchor::Start, text);
        self.written.push(Place::new(corner, size));
    }

    fn has_room(&self, place: &Place) -> bool {
        let taken = [&self.lines, &self.marks, &self.written];
        self.room.holds(place)
            && !taken
                .into_iter()
                .flatten()
                .any(|taken| taken.touches(place))
    }

    /// How easily a label there would be taken for that of another point: a
    /// length, to which each other mark or label that is too near adds. No line
    /// goes through a label if there is any other room.
    fn doubt(&self, point: DVec2, corner: DVec2, size: DVec2) -> f64 {
        let touch = |all: &[Place], place: &Place| all.iter().any(|it| it.touches(place));
        let struck = 1000.0 * f64::from(touch(&self.leaders, &Place::new(corner, size)));
        let Some([from, to]) = leader(point, corner, size) else {
            return struck;
        };
        let steps: Vec<Place> = Place::along(from, to).collect();
        let near = Place::new(corner - 6.0, size + 12.0);
        let count = |places: &[Place], by: &[Place]| {
            let away = |place: &&Place| !place.touches(&Place::around(point, 1.0));
            places
                .iter()
                .filter(away)
                .filter(|it| touch(by, it))
                .count() as f64
        };
        struck
            + point.distance(to)
            + 20.0 * count(&self.marks, &[near])
            + 100.0 * count(&self.marks, &steps)
            + 30.0 * count(&self.written, &[near])
            + 1000.0 * count(&self.written, &steps)
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
        // To the right, left, above and below, and between them.
        (0..24).map(move |n| {
            let degrees = 15.0 * f64::from(n);
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
