//! Outlier rejection: what is joined to the background by mixed edges, and has other colors.
//!
//! Where several rays are taken, edges change as little from pixel to pixel as surfaces do. What the
//! background is made of shows at the picture's sides, and what is off there is something else.

use super::background::viewports;
use super::cone::Eye;
use super::said::Seen;
use super::terms::Terms;
use super::{MANY, Surface, neighbors, surfaces_apart};
use crate::bits::distance;
use crate::reading::Reading;

/// How wide the sides of a picture are: one part of so many.
pub(super) const SIDE: u32 = 16;
/// By how many levels more than at the sides a pixel is off that is of something else, and one of how
/// many are, where something is joined to what lies behind.
const MIXED: f64 = 2.0;
const JOINED: usize = 50;
/// From pixel to pixel a surface that is not seen from aside changes by no more.
const FLAT: u16 = 4;

/// All surfaces, where mixed edges join something to what lies behind it, but it has not the colors
/// that this has at the picture's sides.
pub(super) fn apart(background: &Surface, reading: &Reading) -> Option<Vec<Surface>> {
    let Reading { width, height, .. } = *reading;
    // What is no level has no color.
    let is_level = |it: &i16| (0..=255).contains(it);
    if !reading.pixels.iter().flatten().all(is_level) {
        return None;
    }
    let is_at_a_side = |n: &u32| {
        let [i, j] = [n % width, n / width];
        SIDE * j < height || 2 * j < height && SIDE * i.min(width - 1 - i) < width
    };
    let inner = background.inner.iter().copied();
    let sides = Surface {
        inner: inner.filter(is_at_a_side).collect(),
        outline: Vec::new(),
        count: 0,
        columns: 0..width,
        rows: 0..height,
    };
    let [books, ..] = viewports(reading).map(|viewport| Eye::new(reading, viewport));
    let seen = Seen::new(&sides, reading, books);
    let mut terms = [Terms::UnitY, Terms::Red].into_iter();
    let (terms, fit) = terms.find_map(|it| Some((it, seen.fit(it)?)))?;
    let pixel = |n: u32| reading.pixels[n as usize];
    let is_apart = |n: u32| {
        let color = seen.values(terms, n).map(|it| fit.color(it));
        color.is_some_and(|color| {
            let level = |component: f64| (256.0 * component).clamp(0.0, 255.0) as i16;
            f64::from(distance(color.map(level), pixel(n))) > fit.off + MIXED
        })
    };
    let all: Vec<bool> = (0..reading.pixels.len() as u32).map(is_apart).collect();
    let is_apart = |n: u32| all[n as usize];
    let joined = background.inner.iter().filter(|n| is_apart(**n)).count();
    // What only drifts away has no edge, unless all the rest has one color.
    let edge = (0..all.len() as u32)
        .filter(|n| is_apart(*n))
        .flat_map(|n| {
            let others = neighbors(n, reading).filter(|near| !is_apart(*near));
            others.map(move |near| distance(pixel(n), pixel(near)))
        });
    let edge: Vec<u16> = edge.collect();
    let flat = edge.iter().filter(|step| **step <= FLAT).count();
    let is_plain = sides
        .inner
        .iter()
        .all(|n| pixel(*n) == pixel(sides.inner[0]));
    let is_joined = JOINED * joined > background.inner.len();
    let has_an_edge = 4 * flat < 3 * edge.len() || is_plain;
    let all = (is_joined && has_an_edge).then(|| surfaces_apart(reading, is_apart));
    all.filter(|all| (1..=MANY).contains(&all.len()))
}
