//! Axes with ticks, linear and logarithmic.

use glam::DVec2;

use crate::svg::{Anchor, Svg};
use crate::text::{SMALL, width};

/// The numbers from `least` to `most` on a straight stretch of the sheet, to the right or
/// upwards.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Axis {
    pub(crate) start: DVec2,
    pub(crate) end: DVec2,
    least: f64,
    most: f64,
    /// Whether equal steps are equal ratios.
    is_logarithmic: bool,
}

/// A number, and what stands there.
pub(crate) type Tick = (f64, String);

impl Axis {
    /// An axis to the right, from (x, y) on so long.
    pub(crate) const fn new(x: f64, y: f64, long: f64, least: f64, most: f64) -> Self {
        Self {
            start: DVec2::new(x, y),
            end: DVec2::new(x + long, y),
            least,
            most,
            is_logarithmic: false,
        }
    }

    /// The same numbers, with equal steps for equal ratios.
    pub(crate) fn logarithmic(self) -> Self {
        let is_logarithmic = true;
        Self {
            is_logarithmic,
            ..self
        }
    }

    /// The same numbers elsewhere on the sheet.
    pub(crate) fn between(self, start: DVec2, end: DVec2) -> Self {
        Self { start, end, ..self }
    }

    /// Where `value` is, or the end that is nearer to it.
    pub(crate) fn at(&self, value: f64) -> DVec2 {
        let Self { least, most, .. } = *self;
        let part = if self.is_logarithmic {
            (value / least).ln() / (most / least).ln()
        } else {
            (value - least) / (most - least)
        };
        self.start.lerp(self.end, part.clamp(0.0, 1.0))
    }

    /// Which number is there on a linear axis to the right, or would be beyond its end.
    pub(crate) fn value(&self, at: DVec2) -> f64 {
        let part = (at.x - self.start.x) / (self.end.x - self.start.x);
        self.least + part * (self.most - self.least)
    }

    /// Draws a line of that class at each tick, as far as `reach`, and its words: below the
    /// axis, or left of it if it is upright.
    pub(crate) fn draw_ticks(&self, svg: &mut Svg, class: &str, reach: DVec2, ticks: &[Tick]) {
        let is_upright = self.start.x == self.end.x;
        let mut written = f64::NEG_INFINITY;
        for (value, words) in ticks {
            let at = self.at(*value);
            svg.line(class, at, at + reach);
            let half = 0.5 * width(words, SMALL);
            if is_upright {
                let beside = at + DVec2::new(-7.0, 4.0);
                svg.small_label("faint", beside, Anchor::End, words);
            } else if at.x - half > written {
                // Where lines are near to each other not each has its number.
                let below = at + DVec2::new(0.0, 18.0);
                svg.small_label("faint", below, Anchor::Middle, words);
                written = at.x + half + 4.0;
            }
        }
    }
}

/// Numbers as ticks.
pub(crate) fn ticks(
    numbers: impl Iterator<Item = f64>,
    words: impl Fn(f64) -> String,
) -> Vec<Tick> {
    numbers.map(|value| (value, words(value))).collect()
}
