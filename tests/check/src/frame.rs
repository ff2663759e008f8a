//! Rectangles with sharp sides, and borders of one color: a picture in the window of a screenshot.

use std::cmp::Reverse;

use crate::bits::distance;
use crate::guess::is_near_a_chapter;
use crate::reading::{Cause, Reading};
use crate::scene::{Scene, USUAL_RATIOS};
use crate::verdict::{Check, MOST_MISSHAPEN};

/// What is said of it is called.
pub(crate) const FRAMED: &str = "framed";
/// How many of the sharpest lines each way may be a side.
const SIDES: usize = 40;
/// Pixels that are so many levels from each other lie on either side of one, and so many of a
/// hundred do.
const SHARP: u32 = 4;
const MOST: u32 = 60;
/// So many pixels beside it may be blurred.
const BLURRED: u32 = 2;
/// A line so much farther inside is none.
const FARTHER: u32 = BLURRED + 1;
/// Levels within which a border has one color.
const BORDER: u16 = 2;
/// One row in so many is a thin one.
const THIN: u32 = 25;
/// Levels that count at most.
const FAR: u32 = 24;
/// How many sides have to be seen: the others may be the file's own.
const SEEN: usize = 2;
/// A smaller part of the width or height holds no picture.
const LEAST: u32 = 3;
/// How many rectangles may hold a picture.
const TRIED: usize = 3;

/// Judges what was read, or what lies in a frame of it, where only that is known. Returns also
/// which of the two was judged.
///
/// # Errors
/// Those of `judge`.
pub fn judge_inside<E>(
    reading: Reading,
    judge: impl Fn(&Reading) -> Result<(Scene, Check), E>,
) -> Result<(Scene, Check, Reading), E> {
    if let Some(inside) = nearly_a_chapters(&reading) {
        let (scene, check) = judge(&inside)?;
        if is_known(&check) {
            return Ok((scene, check, inside));
        }
    }
    let (scene, check) = judge(&reading)?;
    if is_known(&check) {
        return Ok((scene, check, reading));
    }
    // Whatever it is, a border is no part of it.
    let border = inside_of_a_border(&reading);
    let has_border = border.is_some();
    if let Some(inside) = border.or_else(|| insides(&reading).next()) {
        let (of, inner) = judge(&inside)?;
        let is_misshapen = |check: &Check| matches!(check, Check::WrongShape { .. });
        let is_all = has_border && (!is_misshapen(&inner) || is_misshapen(&check));
        if is_known(&inner) || is_all {
            return Ok((of, inner, inside));
        }
    }
    Ok((scene, check, reading))
}

/// What is nearly a chapter's picture, inside of what is none.
fn nearly_a_chapters(reading: &Reading) -> Option<Reading> {
    let bordered = inside_of_a_border(reading).into_iter();
    let mut all = bordered.chain(insides(reading).take(TRIED)).peekable();
    all.peek()?;
    let is_framed = !is_near_a_chapter(reading);
    all.find(|inside| is_framed && is_near_a_chapter(inside))
}

fn is_known(check: &Check) -> bool {
    match check {
        Check::Right(_) | Check::Another { .. } => true,
        _ => check
            .finding()
            .is_some_and(|it| it.near.is_some() || !it.sets.is_empty()),
    }
}

/// What lies in a border of one color, whose sides may be blurred.
fn inside_of_a_border(reading: &Reading) -> Option<Reading> {
    let (width, height) = (reading.width, reading.height);
    let off = |n: u32| distance(reading.pixels[0], reading.pixels[n as usize]);
    let all = 0..width * height;
    let inside = all.filter(|&n| off(n) > BORDER);
    let [mut left, mut right, mut above, mut below] = [width, 0, height, 0];
    for n in inside {
        let (i, j) = (n % width, n / width);
        (left, right) = (left.min(i), right.max(i + 1));
        (above, below) = (above.min(j), below.max(j + 1));
    }
    let is_border = [left > 0, right < width, above > 0, below < height];
    let (across, down) = (right.saturating_sub(left), below.saturating_sub(above));
    // One side alone is that of something else, unless it is a row or a few.
    let is_thin = THIN * (width - across) <= width && THIN * (height - down) <= height;
    let count = is_border.iter().filter(|it| **it).count();
    let is_large = LEAST * across >= width && LEAST * down >= height && across.min(down) > BLURRED;
    if !is_large || count == 0 || count < SEEN && !is_thin {
        return None;
    }
    // Beside a border most are others, or it is the end of something that is none.
    let row = |j: u32| (left..right).map(move |i| j * width + i).collect();
    let column = |i: u32| (above..below).map(move |j| j * width + i).collect();
    let sides: [Vec<u32>; 4] = [
        column(left + BLURRED),
        column(right - 1 - BLURRED),
        row(above + BLURRED),
        row(below - 1 - BLURRED),
    ];
    let is_another = |n: &&u32| u32::from(off(**n)) >= FAR;
    let mut sides = sides
        .iter()
        .zip(is_border)
        .filter(|(_, is_border)| *is_border);
    let are_sharp = sides.all(|(side, _)| 2 * side.iter().filter(is_another).count() > side.len());
    let color = reading.pixels[0];
    let why = format!(
        "its border is {color:?} everywhere, as in a screenshot, or where rows are never drawn"
    );
    are_sharp.then(|| part(reading, [left, right, above, below], &why))
}

/// What lies in the rectangles of a usual shape with the sharpest sides, the smallest of those
/// first.
fn insides(reading: &Reading) -> impl Iterator<Item = Reading> {
    let (width, height) = (reading.width, reading.height);
    let columns = Side::all(reading, width, height, |at, along| along * width + at);
    let rows = Side::all(reading, height, width, |at, along| at * width + along);
    let pairs = |sides: &[Side], all: u32| {
        let pairs = (0..sides.len()).flat_map(|n| (n + 1..sides.len()).map(move |m| (n, m)));
        let is_long = |&(n, m): &(usize, usize)| {
            let length = sides[m].at - sides[n].at;
            LEAST * length >= all && length > 2 * FARTHER
        };
        pairs.filter(is_long).collect::<Vec<_>>()
    };
    let (across, down) = (pairs(&columns, width), pairs(&rows, height));
    let all = across
        .iter()
        .flat_map(|pair| down.iter().map(move |other| (pair, other)));
    let framed = all.filter_map(|(&(left, right), &(above, below))| {
        let [left, right] = [left, right].map(|n| &columns[n]);
        let [above, below] = [above, below].map(|n| &rows[n]);
        let sharp = [
            left.sharp(above, below),
            right.sharp(above, below),
            above.sharp(left, right),
            below.sharp(left, right),
        ];
        let [across, down] = [right.at - left.at, below.at - above.at];
        let seen = sharp.iter().flatten();
        let is_sharp = seen.clone().all(|[_, share]| *share >= MOST);
        let area = u64::from(across) * u64::from(down);
        let is_picture = is_usual(across, down) && area <= MOST_MISSHAPEN;
        let is_framed = is_sharp && seen.clone().count() >= SEEN && is_picture;
        let levels: u32 = seen.map(|[levels, _]| levels).sum();
        let rank = (levels, Reverse(area));
        is_framed.then_some((rank, [left.at, right.at, above.at, below.at]))
    });
    let mut framed: Vec<(_, [u32; 4])> = framed.collect();
    framed.sort_unstable_by_key(|(rank, _)| Reverse(*rank));
    let framed = framed.into_iter().filter(|(_, it)| are_steps(reading, *it));
    let framed = framed.take(TRIED);
    // One color tells nothing of a picture.
    framed
        .map(|(_, sides)| part(reading, sides, "it lies in a frame, as in a screenshot"))
        .filter(|it| !it.is_plain())
}

/// Whether pixels on either side of each line differ more than those a little farther inside do: in
/// grain all differ.
fn are_steps(reading: &Reading, [left, right, above, below]: [u32; 4]) -> bool {
    let (width, height) = (reading.width, reading.height);
    let levels = |one: u32, other: u32| {
        let [one, other] = [one, other].map(|n| reading.pixels[n as usize]);
        u32::from(distance(one, other)).min(FAR)
    };
    let column = |i: u32| -> u32 {
        let pixels = (above..below).map(|j| j * width + i);
        pixels.map(|n| levels(n - 1, n)).sum()
    };
    let row = |j: u32| -> u32 {
        let pixels = (left..right).map(|i| j * width + i);
        pixels.map(|n| levels(n - width, n)).sum()
    };
    (left == 0 || column(left) > 2 * column(left + FARTHER))
        && (right == width || column(right) > 2 * column(right - FARTHER))
        && (above == 0 || row(above) > 2 * row(above + FARTHER))
        && (below == height || row(below) > 2 * row(below - FARTHER))
}

fn part(reading: &Reading, [left, right, above, below]: [u32; 4], why: &str) -> Reading {
    let (across, down) = (right - left, below - above);
    let width = reading.width;
    let pixels = (above..below).flat_map(|j| (left..right).map(move |i| j * width + i));
    Reading {
        width: across,
        height: down,
        pixels: pixels.map(|n| reading.pixels[n as usize]).collect(),
        before: (left, above),
        encoding: Some(Cause::new(
            FRAMED,
            format!(
                "{why}: the {across} × {down} pixels from column {left}, row {above} on were judged"
            ),
            "Check the file that the program wrote.",
        )),
    }
}

/// Whether people choose that shape, a row more or less.
fn is_usual(width: u32, height: u32) -> bool {
    let [width, height] = [width, height].map(f64::from);
    USUAL_RATIOS
        .iter()
        .any(|ratio| (width / ratio - height).abs() < 1.0)
}

/// A line between two columns, or two rows.
struct Side {
    at: u32,
    /// How many levels lie between the pixels on either side of it, and whether enough, summed over
    /// all before each; nothing at the file's own side.
    before: Vec<[u32; 2]>,
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
        let levels = |at: u32| {
            (0..length)
                .map(move |along| u32::from(distance(pixel(at - 1, along), pixel(at, along))))
        };
        let mut sharpest: Vec<u32> = (1..count).collect();
        let sharp = |at: &u32| Reverse(levels(*at).map(|it| it.min(FAR)).sum::<u32>());
        sharpest.sort_by_cached_key(sharp);
        sharpest.truncate(SIDES);
        let before = |at: u32| {
            let mut sums = [0; 2];
            let before = levels(at).map(|it| {
                sums = [sums[0] + it.min(FAR), sums[1] + u32::from(it >= SHARP)];
                sums
            });
            [[0; 2]].into_iter().chain(before).collect()
        };
        let sides = sharpest.into_iter().map(|at| Self {
            at,
            before: before(at),
        });
        let mut sides: Vec<Self> = sides.collect();
        sides.extend([0, count].map(|at| Self {
            at,
            before: Vec::new(),
        }));
        sides.sort_by_key(|it| it.at);
        sides
    }

    /// How many levels lie there between two others on the average, and how many of a hundred
    /// pixels are sharp, unless it is the file's own.
    fn sharp(&self, from: &Self, to: &Self) -> Option<[u32; 2]> {
        let [first, last] = [from, to].map(|side| self.before.get(side.at as usize));
        let ([levels, count], [past_levels, past]) = (first?, last?);
        let length = to.at - from.at;
        Some([
            (past_levels - levels) / length,
            100 * (past - count) / length,
        ])
    }
}
