//! Least squares: of what the levels of a surface are made, as sums of up to four terms.

use glam::{DMat4, DVec4};

/// Levels have lost their fraction, which is half of one on the average.
const LOST: f64 = 0.5;
/// One pixel in so many may be off by more levels than the others.
const SOME: usize = 50;
/// What part of a term is as good as none of it.
pub(super) const LITTLE: f64 = 0.015;
/// Levels of a whole component.
const WHOLE: f64 = 256.0;

/// What of each term a component has.
pub(super) struct Fit {
    pub(super) components: [DVec4; 3],
    /// How far all but some are off, in levels.
    pub(super) off: f64,
}

impl Fit {
    /// The sums of terms that come nearest to levels, if all but some are off by at most so much; none
    /// of no points.
    pub(super) fn of(points: &[(DVec4, [i16; 3])], most: f64) -> Option<Self> {
        let sums = [0, 1, 2].map(|channel| sum(points, channel));
        let mut off: Vec<f64> = points
            .iter()
            .flat_map(|(terms, levels)| {
                [0, 1, 2].map(|channel| {
                    let level = sums[channel].dot(*terms) - LOST;
                    let found = levels[channel];
                    let level = if is_end(found) {
                        level.clamp(0.0, 255.0)
                    } else {
                        level
                    };
                    (level - f64::from(found)).abs()
                })
            })
            .collect();
        let at = off.len().checked_sub(1 + off.len() / SOME)?;
        let (_, off, _) = off.select_nth_unstable_by(at, f64::total_cmp);
        let off = *off;
        (off <= most).then(|| Self {
            components: sums.map(|sum| sum / WHOLE),
            off,
        })
    }

    /// Whether each component is made of no more than one of the terms after the first.
    pub(super) fn is_simple(&self) -> bool {
        self.components.iter().all(|it| {
            let [_, parts @ ..] = it.to_array();
            parts.iter().filter(|part| part.abs() >= LITTLE).count() < 2
        })
    }

    /// Where each component grows, if in no more than one way.
    pub(super) fn growing(&self) -> Option<String> {
        let way = |it: &DVec4| match (it.y.abs() < LITTLE, it.z.abs() < LITTLE) {
            (true, true) => Some("is the same everywhere"),
            (false, true) => {
                Some(["grows to the left", "grows to the right"][usize::from(it.y > 0.0)])
            }
            (true, false) => Some(["grows downwards", "grows upwards"][usize::from(it.z > 0.0)]),
            (false, false) => None,
        };
        let [red, green, blue] = self.components.each_ref().map(way);
        Some(format!("red {}, green {}, blue {}", red?, green?, blue?))
    }

    /// Whether each component is that of a normal, from 0 to 1.
    pub(super) fn is_the_normal(&self) -> bool {
        let book = [DVec4::Y, DVec4::Z, DVec4::W].map(|axis| 0.5 * (DVec4::X + axis));
        let mut pairs = self.components.iter().zip(book);
        pairs.all(|(it, book)| (*it - book).abs().max_element() < LITTLE)
    }

    /// By how much what it makes of a unit direction's y, down and up, is more than a color is.
    pub(super) fn beyond_colors(&self) -> f64 {
        let ends = self.ends().into_iter().flatten();
        ends.map(|it| (it - 1.0).max(-it)).fold(0.0, f64::max)
    }

    /// By how much that differs from two colors.
    pub(super) fn blends(&self, colors: [[f64; 3]; 2]) -> f64 {
        let pairs = self
            .ends()
            .into_iter()
            .flatten()
            .zip(colors.into_iter().flatten());
        pairs
            .map(|(it, other)| (it - other).abs())
            .fold(0.0, f64::max)
    }

    /// The colors where the y of a unit direction is -1 and 1.
    fn ends(&self) -> [[f64; 3]; 2] {
        [-1.0, 1.0].map(|y| self.color(DVec4::new(1.0, 0.0, y, 0.0)))
    }

    /// The color of some terms.
    pub(super) fn color(&self, terms: DVec4) -> [f64; 3] {
        self.components.map(|it| it.dot(terms))
    }
}

/// The sum for one channel, from those levels that did not end at 0 or 255, unless most did.
fn sum(points: &[(DVec4, [i16; 3])], channel: usize) -> DVec4 {
    let inside = points.iter().filter(|(_, levels)| !is_end(levels[channel]));
    let is_most = 4 * inside.count() > points.len();
    // What no term tells apart has none of it.
    let mut matrix = DMat4::from_diagonal(DVec4::splat(1e-9));
    let mut vector = DVec4::ZERO;
    for (terms, levels) in points {
        let level = levels[channel];
        if !is_end(level) || !is_most {
            let column = |term: f64| *terms * term;
            let [x, y, z, w] = terms.to_array();
            matrix += DMat4::from_cols(column(x), column(y), column(z), column(w));
            vector += *terms * (f64::from(level) + LOST);
        }
    }
    matrix.inverse() * vector
}

/// What is beyond the first or the last level may be cut off there.
fn is_end(level: i16) -> bool {
    matches!(level, 0 | 255)
}
