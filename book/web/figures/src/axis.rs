//! Axes with ticks, linear and logarithmic.

use glam::DVec2;

use crate::svg::{Anchor, Shift, Svg, spot};
use crate::text::{SMALL, width};

/// An axis of a diagram: a straight stretch of the sheet, to the right or upwards, for the numbers
/// from `least` to `most`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Axis {
    /// The place of `least` on the sheet.
    pub(crate) start: DVec2,
    /// The place of `most` on the sheet.
    pub(crate) end: DVec2,
    /// The number at the start; greater than 0 on a logarithmic axis.
    pub(crate) least: f64,
    /// The number at the end.
    pub(crate) most: f64,
    /// True if equal lengths of the axis stand for equal ratios, false if for equal differences.
    pub(crate) is_logarithmic: bool,
}

/// A marked number of an axis, and the words beside it.
pub(crate) type Tick = (f64, String);

impl Axis {
    /// Makes a linear axis from (x, y) of the sheet to the right, `long` units of the sheet in
    /// length.
    pub(crate) const fn new(x: f64, y: f64, long: f64, least: f64, most: f64) -> Self {
        Self {
            start: spot(x, y),
            end: spot(x + long, y),
            least,
            most,
            is_logarithmic: false,
        }
    }

    /// Returns the place of `value` on the sheet: the nearer end, if the axis does not reach so
    /// far.
    pub(crate) fn point(&self, value: f64) -> DVec2 {
        let Self { least, most, .. } = *self;
        let part = if self.is_logarithmic {
            (value / least).ln() / (most / least).ln()
        } else {
            (value - least) / (most - least)
        };
        self.start.lerp(self.end, part.clamp(0.0, 1.0))
    }

    /// Returns the number of a linear axis to the right that is above or below `at`; also beyond
    /// its ends.
    pub(crate) fn place(&self, at: DVec2) -> f64 {
        let part = (at.x - self.start.x) / (self.end.x - self.start.x);
        self.least + part * (self.most - self.least)
    }

    /// Draws an axis to the right, with a short line and words at each tick.
    pub(crate) fn draw(&self, svg: &mut Svg, ticks: &[Tick]) {
        svg.line("ink line", self.start, self.end);
        self.draw_ticks(svg, "ink line", spot(0.0, 5.0), ticks);
    }

    /// Draws a line at each tick, from the axis along `reach`, and the words of the tick: below the
    /// axis, or left of an upright one. Words that would overlap others are left out.
    pub(crate) fn draw_ticks(&self, svg: &mut Svg, class: &str, reach: DVec2, ticks: &[Tick]) {
        let is_upright = self.start.x == self.end.x;
        let mut written = f64::NEG_INFINITY;
        for (value, words) in ticks {
            let at = self.point(*value);
            svg.line(class, at, at + reach);
            let half = 0.5 * width(words, SMALL);
            if is_upright {
                svg.small_label("faint", at + spot(-7.0, 4.0), Anchor::End, words);
            } else if at.x - half > written {
                // Where lines are near to each other not each has its number.
                svg.small_label("faint", at.down(18.0), Anchor::Middle, words);
                written = at.x + half + 4.0;
            }
        }
    }
}

/// Makes a tick of each number, with `words` for it.
pub(crate) fn ticks(
    numbers: impl Iterator<Item = f64>,
    words: impl Fn(f64) -> String,
) -> Vec<Tick> {
    numbers.map(|value| (value, words(value))).collect()
}
