//! Linear and logarithmic scales: from numbers to places on the sheet.

use glam::DVec2;

use crate::number::number;
use crate::svg::{Anchor, SMALL, Svg, width};

/// One direction of a panel.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    /// What is measured, with its unit.
    pub(super) title: String,
    /// Where a number is: 0 at the beginning, 1 at the end.
    scale: Scale,
    /// The numbers with a grid line, and what stands there.
    ticks: Vec<(f64, String)>,
}

#[derive(Clone, Copy, Debug)]
struct Scale {
    least: f64,
    most: f64,
    logarithmic: bool,
}

impl Axis {
    /// An axis with equal steps for equal differences.
    pub(super) fn linear(title: &str, least: f64, most: f64, step: f64) -> Self {
        let first = (least / step).ceil() as i64;
        let last = (most / step).floor() as i64;
        Self {
            title: title.to_owned(),
            scale: Scale {
                least,
                most,
                logarithmic: false,
            },
            ticks: (first..=last)
                .map(|n| (n as f64 * step, number(n as f64 * step)))
                .collect(),
        }
    }

    /// An axis with equal steps for equal ratios, wide enough for all `values`,
    /// with ticks at 1, 2 and 5 times powers of ten, or at these powers alone if
    /// there are many.
    pub(super) fn logarithmic(title: &str, values: impl Iterator<Item = f64>) -> Self {
        let (least, most) = values
            .filter(|value| value.is_finite() && *value > 0.0)
            .fold((f64::INFINITY, 0.0_f64), |(least, most), value| {
                (least.min(value), most.max(value))
            });
        let (least, most) = if least <= most {
            (least, most)
        } else {
            (1.0, 10.0)
        };
        let (least, most) = (least / 1.25, most * 1.25);
        let factors: &[f64] = match (most / least).log10() {
            ..2.5 => &[1.0, 2.0, 5.0],
            _ => &[1.0],
        };
        let decades = least.log10().floor() as i32..=most.log10().ceil() as i32;
        let ticks = decades
            .flat_map(|decade| {
                factors
                    .iter()
                    .map(move |factor| factor * 10_f64.powi(decade))
            })
            .filter(|tick| (least..=most).contains(tick))
            .map(|tick| (tick, round(tick)))
            .collect();
        Self {
            title: title.to_owned(),
            scale: Scale {
                least,
                most,
                logarithmic: true,
            },
            ticks,
        }
    }

    /// The same axis with other ticks.
    pub(super) fn with_ticks(mut self, ticks: Vec<(f64, String)>) -> Self {
        self.ticks = ticks;
        self
    }

    /// Where `value` is: 0 at the beginning, 1 at the end, and never outside.
    fn place(&self, value: f64) -> f64 {
        let Scale {
            least,
            most,
            logarithmic,
        } = self.scale;
        let part = if logarithmic {
            (value / least).ln() / (most / least).ln()
        } else {
            (value - least) / (most - least)
        };
        part.clamp(0.0, 1.0)
    }
}

/// A round number in few characters.
fn round(value: f64) -> String {
    match value {
        1e6.. => format!("{} M", number(value / 1e6)),
        1e4.. => format!("{} 000", number(value / 1e3)),
        _ => number(value),
    }
}

/// A rectangle with two axes.
#[derive(Clone, Debug)]
pub(super) struct Panel {
    /// The upper left corner of what lies between the axes.
    pub(super) corner: DVec2,
    /// Its size.
    pub(super) size: DVec2,
    /// To the right.
    pub(super) x: Axis,
    /// Upwards.
    pub(super) y: Axis,
}

impl Panel {
    /// Where two numbers are on the sheet.
    pub(super) fn at(&self, x: f64, y: f64) -> DVec2 {
        let part = DVec2::new(self.x.place(x), 1.0 - self.y.place(y));
        self.corner + self.size * part
    }

    /// Draws the grid, the numbers at its lines and the titles of the axes.
    pub(super) fn draw(&self, svg: &mut Svg) {
        let (low, high) = (self.corner, self.corner + self.size);
        let mut written = f64::NEG_INFINITY;
        for (tick, words) in &self.x.ticks {
            let x = self.corner.x + self.size.x * self.x.place(*tick);
            svg.line("grid thin", DVec2::new(x, low.y), DVec2::new(x, high.y));
            let half = 0.5 * width(words, SMALL);
            // Where lines are near to each other not each has its number.
            if x - half > written {
                svg.small_label("faint", DVec2::new(x, high.y + 16.0), Anchor::Middle, words);
                written = x + half + 4.0;
            }
        }
        for (tick, words) in &self.y.ticks {
            let y = self.corner.y + self.size.y * (1.0 - self.y.place(*tick));
            svg.line("grid thin", DVec2::new(low.x, y), DVec2::new(high.x, y));
            svg.small_label(
                "faint",
                DVec2::new(low.x - 7.0, y + 4.0),
                Anchor::End,
                words,
            );
        }
        let (x, anchor) = match width(&self.x.title, SMALL) < self.size.x + 24.0 {
            true => (high.x, Anchor::End),
            false => (low.x - 24.0, Anchor::Start),
        };
        let below = DVec2::new(x, high.y + 33.0);
        svg.small_label("faint", below, anchor, &self.x.title);
        let above = DVec2::new(low.x - 24.0, low.y - 12.0);
        svg.small_label("faint", above, Anchor::Start, &self.y.title);
    }
}
