//! A right picture that was turned, moved, or whose components have changed places,
//! though no slip does it.

use common::rtweekend::Camera;

use ::slips::Program;

use super::{Evidence, Explanation, Hypothesis, Seen, estimate, spread};
use crate::bits::Pixel;

/// What was done: one of forty ways, and less likely than a slip.
const NAME: f64 = 14.0;
/// How many pixels choose the way that is measured.
const LOOK: u32 = 600;

/// A way to change a picture: the color of the nth pixel, and a sentence.
struct Way<'a> {
    pixel: Box<dyn Fn(u32) -> Pixel + 'a>,
    said: String,
}

/// The best of these ways.
pub(crate) fn turned(
    evidence: &Evidence,
    right: &Hypothesis,
    drawn: &[Pixel],
) -> Option<Explanation> {
    let reading = evidence.reading;
    let all = reading.pixels.len() as u32;
    let (width, height) = (reading.width, reading.height);
    let off = |way: &Way| -> f64 {
        let places = spread(LOOK, all);
        let bits = places.map(|n| estimate((way.pixel)(n), reading.pixels[n as usize]));
        bits.sum()
    };
    let program = right.scene.program(&[]);
    let ways = turns(drawn, width, height)
        .into_iter()
        .chain(orders(drawn))
        .chain(moves(&program, program.camera(width)));
    let best = ways.min_by(|one, other| off(one).total_cmp(&off(other)))?;
    let changed: Vec<Pixel> = (0..all).map(&best.pixel).collect();
    let mut explanation = right.explaining(reading, &changed);
    explanation.name += NAME;
    explanation.seen = Some(Seen::Said(best.said));
    Some(explanation)
}

/// Mirrored, upside down, both, or columns for rows.
fn turns(drawn: &[Pixel], width: u32, height: u32) -> Vec<Way<'_>> {
    type Place = fn(u32, u32, u32, u32) -> (u32, u32);
    let turns: [(Place, &str); 4] = [
        (
            |i, j, _, height| (i, height - 1 - j),
            "It is upside down: the last row should be the first one.",
        ),
        (
            |i, j, width, _| (width - 1 - i, j),
            "It is mirrored: left and right have changed places.",
        ),
        (
            |i, j, width, height| (width - 1 - i, height - 1 - j),
            "It is turned by half a turn.",
        ),
        (
            |i, j, _, _| (j, i),
            "It is transposed: columns and rows have changed places.",
        ),
    ];
    let possible = match width == height {
        true => &turns[..],
        false => &turns[..3],
    };
    let way = |&(place, said): &(Place, &str)| Way {
        pixel: Box::new(move |n| {
            let (i, j) = place(n % width, n / width, width, height);
            drawn[(j * width + i) as usize]
        }),
        said: said.to_owned(),
    };
    possible.iter().map(way).collect()
}

/// Red, green and blue in another order.
fn orders(drawn: &[Pixel]) -> impl Iterator<Item = Way<'_>> {
    const ORDERS: [[usize; 3]; 5] = [[2, 1, 0], [1, 0, 2], [0, 2, 1], [1, 2, 0], [2, 0, 1]];
    const NAMES: [&str; 3] = ["red", "green", "blue"];
    ORDERS.into_iter().map(move |order| {
        let [red, green, blue] = order.map(|c| NAMES[c]);
        Way {
            pixel: Box::new(move |n| order.map(|c| drawn[n as usize][c])),
            said: format!(
                "Its red is what {red} should be, its green what {green}, its blue what {blue} should be."
            ),
        }
    })
}

/// The whole scene moved by half a pixel or by one.
fn moves(program: &Program, camera: Camera) -> impl Iterator<Item = Way<'_>> {
    let steps = [-1.0, -0.5, 0.0, 0.5, 1.0];
    let all = steps.into_iter().flat_map(move |x| steps.map(|y| (x, y)));
    let (width, height) = (camera.image_width, camera.image_height);
    // Editions before version 4 divide the whole edges, and the left one points up.
    let ([across, down], up) = match program.edition.counts_from_below() {
        true => ((program.divisors)(width.into(), height.into()), -1.0),
        false => ([1.0; 2], 1.0),
    };
    all.filter(|&way| way != (0.0, 0.0)).map(move |(x, y)| {
        let moved = Camera {
            pixel00: camera.pixel00
                + x / across * camera.pixel_delta_u
                + y / down * camera.pixel_delta_v,
            ..camera
        };
        // Rays that go further right make the scene move to the left.
        let along = |distance: f64, to: &str, from: &str| {
            let direction = if distance > 0.0 { to } else { from };
            (distance != 0.0).then(|| format!("{} pixel {direction}", distance.abs()))
        };
        let ways = [
            along(x, "to the left", "to the right"),
            along(up * y, "up", "down"),
        ];
        let ways: Vec<String> = ways.into_iter().flatten().collect();
        Way {
            pixel: Box::new(move |n| {
                let (i, j) = (program.order)(n, width, height);
                let color = (program.color)(program, &moved, i, j).to_array();
                color.map(|component| (program.level)(component).clamp(0, 255) as i16)
            }),
            said: format!("The whole scene is moved by {}.", ways.join(" and ")),
        }
    })
}
