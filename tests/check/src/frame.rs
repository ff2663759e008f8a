//! Rectangles with sharp sides: a picture in the window of a screenshot.

use crate::bits::distance;
use crate::reading::{Cause, Reading};
use crate::scene::{Scene, USUAL_RATIOS};
use crate::verdict::Check;

/// What is said of it is called.
pub(crate) const FRAMED: &str = "framed";
/// How many of the sharpest lines each way may be a side.
const SIDES: usize = 12;
/// Pixels that are this far from each other lie on either side of one.
const SHARP: u16 = 4;
/// How many of a hundred have to.
const MOST: u32 = 90;
/// How many sides have to be seen: the others may be the file's own.
const SEEN: usize = 2;
/// How near a ratio of width to height is to one that people choose.
const NEAR: f64 = 0.02;
/// A smaller part of the width or height holds no picture.
const LEAST: u32 = 4;

/// Judges what lies in a frame of what was read, where that is known, or else all of it. Returns
/// also which of the two was judged.
///
/// # Errors
/// Those of `judge`.
pub fn judge_inside<E>(
    reading: Reading,
    judge: impl Fn(&Reading) -> Result<(Scene, Check), E>,
) -> Result<(Scene, Check, Reading), E> {
    if let Some(inside) = inside(&reading) {
        let (scene, check) = judge(&inside)?;
        if is_known(&check) {
            return Ok((scene, check, inside));
        }
    }
    let (scene, check) = judge(&reading)?;
    Ok((scene, check, reading))
}

fn is_known(check: &Check) -> bool {
    match check {
        Check::Right(_) | Check::Another { .. } => true,
        _ => check
            .finding()
            .is_some_and(|it| it.near.is_some() || !it.sets.is_empty()),
    }
}

/// What lies in the smallest rectangle with sharp sides.
fn inside(reading: &Reading) -> Option<Reading> {
    let (width, height) = (reading.width, reading.height);
    let columns = Side::all(reading, width, height, |at, along| along * width + at);
    let rows = Side::all(reading, height, width, |at, along| at * width + along);
    let pairs = |sides: &[Side], all: u32| {
        let pairs = (0..sides.len()).flat_map(|n| (n + 1..sides.len()).map(move |m| (n, m)));
        let is_long = |&(n, m): &(usize, usize)| LEAST * (sides[m].at - sides[n].at) >= all;
        pairs.filter(is_long).collect::<Vec<_>>()
    };
    let (across, down) = (pairs(&columns, width), pairs(&rows, height));
    let all = across
        .iter()
        .flat_map(|pair| down.iter().map(move |other| (pair, other)));
    let all = all.map(|(&(left, right), &(above, below))| {
        [&columns[left], &columns[right], &rows[above], &rows[below]]
    });
    let is_framed = |[left, right, above, below]: &[&Side; 4]| {
        let seen = [
            left.is_seen(above.at, below.at),
            right.is_seen(above.at, below.at),
            above.is_seen(left.at, right.at),
            below.is_seen(left.at, right.at),
        ];
        let count = seen.iter().filter(|it| **it == Some(true)).count();
        count >= SEEN && !seen.contains(&Some(false))
    };
    // A window has other rectangles too.
    let of_usual_shape = |[left, right, above, below]: &[&Side; 4]| {
        let [across, down] = [right.at - left.at, below.at - above.at];
        let ratio = f64::from(across) / f64::from(down);
        let is_usual = USUAL_RATIOS
            .iter()
            .any(|it| (it / ratio - 1.0).abs() < NEAR);
        (!is_usual, u64::from(across) * u64::from(down))
    };
    let framed = all.filter(is_framed).min_by_key(of_usual_shape)?;
    let [left, right, above, below] = framed.map(|it| it.at);
    let (across, down) = (right - left, below - above);
    let pixels = (above..below).flat_map(|j| (left..right).map(move |i| j * width + i));
    Some(Reading {
        width: across,
        height: down,
        pixels: pixels.map(|n| reading.pixels[n as usize]).collect(),
        encoding: Some(Cause::new(
            FRAMED,
            format!(
                "it lies in a frame, as in a screenshot: the {across} × {down} pixels from column {left}, row {above} on were judged"
            ),
            "Check the file that the program wrote.",
        )),
    })
}

/// A line between two columns, or two rows.
struct Side {
    at: u32,
    /// How many pixels before each along the line are sharp; nothing at the file's own side.
    before: Vec<u32>,
}

impl Side {
    /// The sharpest, and the file's own two, in their order.
    fn all(
        reading: &Reading,
        count: u32,
        length: u32,
        place: impl Fn(u32, u32) -> u32,
    ) -> Vec<Self> {
        let pixel = |at: u32, along: u32| reading.pixels[place(at, along) as usize];
        let before = |at: u32| {
            let mut sum = 0;
            let sums = (0..length).map(|along| {
                sum += u32::from(distance(pixel(at - 1, along), pixel(at, along)) >= SHARP);
                sum
            });
            [0].into_iter().chain(sums).collect()
        };
        let mut sides: Vec<Self> = (1..count)
            .map(|at| Self {
                at,
                before: before(at),
            })
            .collect();
        sides.sort_by_key(|it| std::cmp::Reverse(it.before.last().copied()));
        sides.truncate(SIDES);
        let own = [0, count].map(|at| Self {
            at,
            before: Vec::new(),
        });
        sides.extend(own);
        sides.sort_by_key(|it| it.at);
        sides
    }

    /// Whether it is sharp between two others, unless it is the file's own.
    fn is_seen(&self, from: u32, to: u32) -> Option<bool> {
        let [first, last] = [from, to].map(|at| self.before.get(at as usize));
        Some(100 * (last? - first?) >= MOST * (to - from))
    }
}
