//! A picture that is turned, moved or zoomed.

use common::rtweekend::Camera;

use super::view::{View, color};
use crate::diagnosis::candidates::distance;
use slips::Program;

/// The right color of the place to which a turn takes a pixel.
type Turn<'a> = &'a dyn Fn(u32) -> [i16; 3];

impl View<'_> {
    /// Mirrored, upside down, or both.
    pub(super) fn turned(&self) -> Option<String> {
        let (width, height) = (self.reading.width, self.reading.height);
        let at = |i: u32, j: u32| self.expected(j * width + i);
        let (across, down) = (
            |n: u32| width - 1 - n % width,
            |n: u32| height - 1 - n / width,
        );
        let turned: [(Turn, &str); 4] = [
            (
                &|n| at(n % width, down(n)),
                "It is upside down: the last row should be the first one.",
            ),
            (
                &|n| at(across(n), n / width),
                "It is mirrored: left and right have changed places.",
            ),
            (&|n| at(across(n), down(n)), "It is turned by half a turn."),
            (
                &|n| at(n / width, n % width),
                "It is transposed: columns and rows have changed places.",
            ),
        ];
        let turned = match width == height {
            true => &turned[..],
            false => &turned[..3],
        };
        // What is the same both ways, as a sphere in the middle is, was not turned.
        let is_other = |turn: Turn| {
            let off = |n: &&u32| distance(turn(**n), self.expected(**n)) > 1;
            20 * self.places.iter().filter(off).count() > self.places.len()
        };
        turned
            .iter()
            .find(|(turn, _)| is_other(turn) && self.shows(turn))
            .map(|(_, said)| (*said).to_owned())
    }

    /// The whole scene moved by half a pixel or by one.
    pub(super) fn moved(&self) -> Option<String> {
        let program = self.program();
        let camera = program.camera(self.reading.width);
        let steps = [-1.0, -0.5, 0.0, 0.5, 1.0];
        let shifts = steps.into_iter().flat_map(|x| steps.map(|y| (x, y)));
        let shows_shifted = |(x, y): (f64, f64)| {
            let moved = Camera {
                pixel00: camera.pixel00 + x * camera.pixel_delta_u + y * camera.pixel_delta_v,
                ..camera
            };
            let wrong = |n: &&u32| distance(color(&program, &moved, **n), self.found(**n)) > 1;
            // Where only edges are wrong, a shift has to mend almost all of them.
            20 * self.wrong.iter().filter(wrong).count() <= self.wrong.len()
                && self.shows(|n| color(&program, &moved, n))
        };
        let (x, y) = shifts
            .filter(|&shift| shift != (0.0, 0.0))
            .find(|&shift| shows_shifted(shift))?;
        // Rays that go further right make the scene move to the left.
        let along = |distance: f64, to: &str, from: &str| {
            let direction = if distance > 0.0 { to } else { from };
            (distance != 0.0).then(|| format!("{} pixel {direction}", distance.abs()))
        };
        let ways = [
            along(x, "to the left", "to the right"),
            along(y, "up", "down"),
        ];
        let ways: Vec<String> = ways.into_iter().flatten().collect();
        Some(format!(
            "The whole scene is moved by {}.",
            ways.join(" and ")
        ))
    }

    /// Everything larger or smaller, around the middle.
    pub(super) fn zoomed(&self) -> Option<String> {
        const HEIGHTS: [f64; 10] = [0.25, 0.5, 0.75, 1.25, 1.5, 2.25, 2.5, 3.0, 4.0, 8.0];
        let height = HEIGHTS.into_iter().find(|&viewport_height| {
            let program = Program {
                viewport_height,
                ..self.program()
            };
            let camera = program.camera(self.reading.width);
            self.shows(|n| color(&program, &camera, n))
        })?;
        let (times, focal_length) = (2.0 / height, 2.0 / height);
        Some(format!(
            "Everything is {times:.2} times as large: as if viewport_height were {height} instead of 2, or focal_length {focal_length:.2} instead of 1."
        ))
    }
}
