//! A panel: a grid between two axes, each with its title.

use glam::DVec2;

use crate::axis::{Axis, Tick, ticks};
use crate::number::number;
use crate::svg::{Anchor, Svg};

/// What is measured along one side of a panel.
#[derive(Clone, Debug)]
pub(super) struct Measure {
    /// What it is, with its unit.
    pub(super) title: String,
    pub(super) axis: Axis,
    /// The numbers with a grid line.
    pub(super) ticks: Vec<Tick>,
}

impl Measure {
    /// Equal steps for equal differences.
    pub(super) fn linear(title: &str, least: f64, most: f64, step: f64) -> Self {
        let steps = (least / step).ceil() as i32..=(most / step).floor() as i32;
        Self {
            title: title.to_owned(),
            axis: Axis::new(0.0, 0.0, 1.0, least, most),
            ticks: ticks(steps.map(|n| f64::from(n) * step), number),
        }
    }

    /// Equal steps for equal ratios, wide enough for all `values`, with ticks at 1, 2 and 5
    /// times powers of ten, or at these powers alone if there are many.
    pub(super) fn logarithmic(title: &str, values: impl Iterator<Item = f64> + Clone) -> Self {
        let least = values.clone().fold(f64::INFINITY, f64::min) / 1.25;
        let most = values.fold(0.0, f64::max) * 1.25;
        let has_many = (most / least).log10() > 2.5;
        let factors: &[f64] = if has_many { &[1.0] } else { &[1.0, 2.0, 5.0] };
        let decades = least.log10().floor() as i32..=most.log10().ceil() as i32;
        let powers = decades.map(|decade| 10_f64.powi(decade));
        let numbers = powers.flat_map(|power| factors.iter().map(move |factor| factor * power));
        Self {
            title: title.to_owned(),
            axis: Axis::new(0.0, 0.0, 1.0, least, most).logarithmic(),
            ticks: ticks(numbers.filter(|it| (least..=most).contains(it)), round),
        }
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

/// A rectangle with an axis to the right, below it, and one upwards, at its left.
#[derive(Clone, Debug)]
pub(super) struct Panel {
    /// The upper left corner.
    pub(super) corner: DVec2,
    /// From there to the lower right corner.
    pub(super) size: DVec2,
    x: Measure,
    y: Measure,
}

impl Panel {
    pub(super) fn new(corner: DVec2, size: DVec2, x: Measure, y: Measure) -> Self {
        let low = corner + DVec2::new(0.0, size.y);
        let place = |it: Measure, end| Measure {
            axis: it.axis.between(low, end),
            ..it
        };
        Self {
            corner,
            size,
            x: place(x, corner + size),
            y: place(y, corner),
        }
    }

    /// Where two numbers are on the sheet.
    pub(super) fn at(&self, x: f64, y: f64) -> DVec2 {
        DVec2::new(self.x.axis.at(x).x, self.y.axis.at(y).y)
    }

    /// Draws the grid, the numbers at its lines and the titles of the axes.
    pub(super) fn draw(&self, svg: &mut Svg) {
        let Self { x, y, size, .. } = self;
        let (up, right) = (DVec2::new(0.0, -size.y), DVec2::new(size.x, 0.0));
        x.axis.draw_ticks(svg, "grid thin", up, &x.ticks);
        y.axis.draw_ticks(svg, "grid thin", right, &y.ticks);
        let below = self.corner + size + DVec2::new(0.0, 36.0);
        svg.small_label("faint", below, Anchor::End, &x.title);
        let above = self.corner - DVec2::new(24.0, 12.0);
        svg.small_label("faint", above, Anchor::Start, &y.title);
    }
}
