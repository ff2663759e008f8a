//! Place, size and form of the only sphere.

use std::ops::Range;

use common::rtweekend::Picture;

use slips::{Chapter, Room};

use super::view::View;
use crate::bits::distance;

impl View<'_> {
    /// What the outline of the only sphere says, if there is one sphere and it is
    /// in full view.
    pub(super) fn disc(&self) -> Option<String> {
        if self.scene.chapter.room() != Room::One || self.scene.probe.is_some() {
            return None;
        }
        let (width, height) = (self.reading.width, self.reading.height);
        let gradient = self.scene.of_chapter(Chapter::Gradient);
        let sky = gradient.right(width, height);
        let Some(found) = Disc::of(&sky, &self.reading.picture()) else {
            return Some("There is only sky: no sphere is to be seen.".to_owned());
        };
        let expected = Disc::of(&sky, self.right)?;
        if found.touches_the_edge(width, height) {
            return None;
        }
        let seen = found.size(&expected, height) + &found.place(&expected);
        (!seen.is_empty()).then(|| seen.trim_start().to_owned())
    }
}

/// The pixels of a picture that are not sky.
struct Disc {
    columns: Range<u32>,
    rows: Range<u32>,
}

impl Disc {
    /// The smallest box around them, or `None` if all is sky.
    fn of(sky: &Picture, picture: &Picture) -> Option<Self> {
        let width = picture.width();
        let mut disc: Option<Self> = None;
        let (sky, _) = sky.rgb().as_chunks::<3>();
        let (pixels, _) = picture.rgb().as_chunks::<3>();
        for (n, (sky, pixel)) in (0u32..).zip(sky.iter().zip(pixels)) {
            if distance(sky.map(i16::from), pixel.map(i16::from)) > 1 {
                let (i, j) = (n % width, n / width);
                let disc = disc.get_or_insert(Self {
                    columns: i..i,
                    rows: j..j,
                });
                disc.columns = disc.columns.start.min(i)..disc.columns.end.max(i + 1);
                disc.rows.end = j + 1;
            }
        }
        disc
    }

    fn touches_the_edge(&self, width: u32, height: u32) -> bool {
        self.columns.start == 0
            || self.rows.start == 0
            || self.columns.end == width
            || self.rows.end == height
    }

    /// What is wrong with the size, or nothing.
    fn size(&self, expected: &Self, height: u32) -> String {
        let [wide, high] = [length(&self.columns), length(&self.rows)];
        let right_wide = length(&expected.columns);
        // An edge may be a pixel farther on either side before it means something.
        let near = |one: f64, other: f64| (one - other).abs() <= 1.5;
        if !near(wide, high) {
            return format!(
                "What is not sky is {wide} pixels wide and {high} high, instead of {right_wide} both ways."
            );
        }
        if near(wide, right_wide) {
            return String::new();
        }
        // On the viewport, one unit away, the disc's radius is the tangent of an
        // angle whose sine is the sphere's radius.
        let on_viewport = wide / f64::from(height);
        let radius = on_viewport / on_viewport.hypot(1.0);
        format!(
            "The disc is {wide} pixels wide instead of {right_wide}: as if the radius were {radius:.3} instead of 0.5, or the sphere at another distance."
        )
    }

    /// What is wrong with the place, or nothing.
    fn place(&self, expected: &Self) -> String {
        let x = middle(&self.columns) - middle(&expected.columns);
        let y = middle(&self.rows) - middle(&expected.rows);
        if x.abs().max(y.abs()) < 1.5 {
            return String::new();
        }
        format!(
            " Its middle is {x} pixels to the right and {y} down from where it should be (negative: left, up)."
        )
    }
}

fn length(range: &Range<u32>) -> f64 {
    f64::from(range.end - range.start)
}

fn middle(range: &Range<u32>) -> f64 {
    f64::from(range.start + range.end) / 2.0
}
