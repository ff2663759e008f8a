//! Outlier rejection: what is joined to the background by mixed edges, and has other colors.
//!
//! Where several rays are taken, edges change as little from pixel to pixel as surfaces do. What the
//! background is made of shows at the picture's sides, and what is off there is something else.

use super::background::viewports;
use super::cone::Eye;
use super::said::Seen;
use super::terms::Terms;
use super::{MANY, Surface, neighbors, surfaces_apart};
use crate::bits::{Pixel, distance};
use crate::reading::Reading;

/// How wide the sides of a picture are: one part of so many.
const SIDE: u32 = 16;
/// By how many levels more than at the sides a pixel is off that is of something else, and one of how
/// many are, where something is joined to what lies behind.
const MIXED: f64 = 2.0;
const JOINED: usize = 50;
/// From pixel to pixel a surface that is not seen from aside changes by no more.
const FLAT: u16 = 4;

/// All surfaces, where mixed edges join something to what lies behind it, but it has not the colors
/// that this has at the picture's sides.
pub(super) fn apart(background: &Surface, reading: &Reading) -> Option<Vec<Surface>> {
    // What is no level has no color.
    let is_level = |it: &i16| (0..=255).contains(it);
    if !reading.pixels.iter().flatten().all(is_level) {
        return None;
    }
    let sides = at_the_sides(background, reading);
    let apart = unlike(&sides, reading)?;
    let joined = background.inner.iter().copied();
    let joined: Vec<u32> = joined.filter(|n| apart[*n as usize]).collect();
    let is_joined = JOINED * joined.len() > background.inner.len();
    // What only drifts away has no edge, unless all the rest has one color.
    let color = |n: &u32| reading.pixels[*n as usize];
    let mut colors = sides.inner.iter().map(color);
    let first = colors.next();
    let is_plain = colors.all(|it| Some(it) == first);
    if !is_joined || !is_plain && !has_an_edge(joined, &apart, reading) {
        return None;
    }
    let all = surfaces_apart(reading, &apart);
    (1..=MANY).contains(&all.len()).then_some(all)
}

/// Its pixels at the top of the picture, and above its middle at the left and the right.
fn at_the_sides(background: &Surface, reading: &Reading) -> Surface {
    let Reading { width, height, .. } = *reading;
    let is_at_a_side = |n: &u32| {
        let [i, j] = [n % width, n / width];
        SIDE * j < height || 2 * j < height && SIDE * i.min(width - 1 - i) < width
    };
    let inner = background.inner.iter().copied();
    Surface {
        inner: inner.filter(is_at_a_side).collect(),
        outline: Vec::new(),
        count: 0,
        columns: 0..width,
        rows: 0..height,
    }
}

/// Which pixels have not the colors of what these are a part of: a blend, or colors on a line.
fn unlike(sides: &Surface, reading: &Reading) -> Option<Vec<bool>> {
    let [books, ..] = viewports(reading).map(|viewport| Eye::new(reading, viewport));
    let seen = Seen::new(sides, reading, books);
    let mut terms = [Terms::UnitY, Terms::Red].into_iter();
    let (terms, fit) = terms.find_map(|it| Some((it, seen.fit(it)?)))?;
    let is_unlike = |(n, found): (u32, &Pixel)| {
        let color = seen.values(terms, n).map(|it| fit.color(it));
        color.is_some_and(|color| {
            let level = |component: f64| (256.0 * component).clamp(0.0, 255.0) as i16;
            f64::from(distance(color.map(level), *found)) > fit.off + MIXED
        })
    };
    Some((0..).zip(&reading.pixels).map(is_unlike).collect())
}

/// Whether colors change at once at a quarter of all places where what is apart, and joined to these,
/// ends.
fn has_an_edge(joined: Vec<u32>, apart: &[bool], reading: &Reading) -> bool {
    let color = |n: u32| reading.pixels[n as usize];
    let (mut is_free, mut left) = (apart.to_vec(), joined);
    let (mut flat, mut steep) = (0, 0);
    for n in &left {
        is_free[*n as usize] = false;
    }
    while let Some(n) = left.pop() {
        for near in neighbors(n, reading) {
            if std::mem::take(&mut is_free[near as usize]) {
                left.push(near);
            } else if !apart[near as usize] {
                match distance(color(n), color(near)) {
                    ..=FLAT => flat += 1,
                    _ => steep += 1,
                }
            }
        }
    }
    flat < 3 * steep
}
