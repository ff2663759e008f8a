//! A panel: a grid between two axes, each with its title.

use glam::DVec2;

use crate::axis::{Axis, Tick, ticks};
use crate::number::number;
use crate::svg::{Anchor, Step, Svg, spot};

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

    /// Equal steps for equal ratios, with ticks at 1, 2 and 5 times powers of ten, or at these
    /// powers alone if there are many.
    pub(super) fn logarithmic(title: &str, least: f64, most: f64) -> Self {
        let has_many = (most / least).log10() > 2.5;
        let factors: &[f64] = if has_many { &[1.0] } else { &[1.0, 2.0, 5.0] };
        let decades = least.log10().floor() as i32..=most.log10().ceil() as i32;
        let powers = decades.map(|decade| 10_f64.powi(decade));
        let numbers = powers.flat_map(|power| factors.iter().map(move |factor| factor * power));
        Self {
            title: title.to_owned(),
            axis: Axis {
                is_logarithmic: true,
                ..Axis::new(0.0, 0.0, 1.0, least, most)
            },
            ticks: ticks(numbers.filter(|it| (least..=most).contains(it)), number),
        }
    }
}

/// A rectangle with an axis to the right, below it, and one upwards, at its left.
#[derive(Clone, Debug)]
pub(super) struct Panel {
    /// The upper left corner.
    pub(super) corner: DVec2,
    /// From there to the lower right corner.
    pub(super) size: DVec2,
    pub(super) x: Measure,
    y: Measure,
}

impl Panel {
    pub(super) fn new(corner: DVec2, size: DVec2, mut x: Measure, mut y: Measure) -> Self {
        let low = corner.down(size.y);
        (x.axis.start, x.axis.end) = (low, corner + size);
        (y.axis.start, y.axis.end) = (low, corner);
        Self { corner, size, x, y }
    }

    /// Where two numbers are on the sheet.
    pub(super) fn at(&self, x: f64, y: f64) -> DVec2 {
        spot(self.x.axis.point(x).x, self.y.axis.point(y).y)
    }

    /// Draws the grid, the numbers at its lines and the titles of the axes.
    pub(super) fn draw(&self, svg: &mut Svg) {
        let Self { x, y, size, .. } = self;
        let (up, right) = (spot(0.0, -size.y), spot(size.x, 0.0));
        x.axis.draw_ticks(svg, "grid thin", up, &x.ticks);
        y.axis.draw_ticks(svg, "grid thin", right, &y.ticks);
        let below = (self.corner + size).down(36.0);
        svg.small_label("faint", below, Anchor::End, &x.title);
        let above = self.corner + spot(-24.0, -12.0);
        svg.small_label("faint", above, Anchor::Start, &y.title);
    }
}
