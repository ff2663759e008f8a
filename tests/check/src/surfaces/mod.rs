//! Seeded region growing (Adams and Bischof, 1994): what a picture shows, whatever it was meant to be.
//!
//! What is smooth is a surface, and the pixels of an edge belong to the surface that is nearer in
//! color. Of each it is told where it lies, what colors it, and whether a chapter has it so.

mod apart;
mod background;
mod cone;
mod fit;
mod said;
mod terms;
mod uniform;
mod view;
mod wrapped;

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::Range;

use crate::bits::distance;
use crate::reading::Reading;

pub(crate) use said::said;
pub(crate) use wrapped::rows_differ;
use wrapped::wrapped;

/// From one pixel to the next a smooth surface changes by no more levels, but for the rim of a
/// small sphere.
const SMOOTH: u16 = 12;
/// One pixel in so many is a surface, and so many pixels at least.
const PART: usize = 500;
const FEW: usize = 20;

/// Pixels that are next to each other and change little from one to the next.
struct Surface {
    /// Those that lie at no edge, row by row.
    inner: Vec<u32>,
    /// How many there are with those at its edges.
    count: usize,
    columns: Range<u32>,
    rows: Range<u32>,
    /// Between its pixels and those of other surfaces, in columns and rows.
    outline: Vec<(f64, f64)>,
}

/// The top of a picture is one part of its height in so many.
const TOP: u32 = 64;

impl Surface {
    /// Whether it reaches the top by more than pixels at its edges.
    fn reaches_the_top(&self, reading: &Reading) -> bool {
        let highest = self.inner.first().map(|n| n / reading.width);
        highest.is_some_and(|row| row <= reading.height.div_ceil(TOP))
    }
}

/// What has more surfaces is no picture of these chapters, with whatever mistake.
const MANY: usize = 8;

/// Whether a picture has more surfaces than any of these chapters'.
pub(crate) fn are_many(reading: &Reading) -> bool {
    Grown::seeds(reading).seeds.len() > MANY
}

/// How many surfaces a picture shows; one, where it has little besides.
pub(crate) fn count(reading: &Reading) -> usize {
    let count = Grown::seeds(reading).seeds.len();
    if is_one(reading) { 1 } else { count }
}

/// Whether almost all of a picture is one surface, so it shows nothing before a sky.
pub(crate) fn is_one(reading: &Reading) -> bool {
    let seeds = Grown::seeds(reading).seeds;
    let total = reading.pixels.len();
    seeds
        .first()
        .is_some_and(|it| total - it.len() < total / PART)
}

/// The surfaces of a picture, the largest first.
fn surfaces(reading: &Reading) -> Vec<Surface> {
    all_of(Grown::seeds(reading))
}

/// The same where some pixels are known to be of no surface with the others.
fn surfaces_apart(reading: &Reading, apart: &[bool]) -> Vec<Surface> {
    all_of(Grown::seeds_apart(reading, apart))
}

fn all_of(mut grown: Grown) -> Vec<Surface> {
    grown.grow();
    let mut all = grown.surfaces();
    all.sort_by_key(|it| Reverse(it.count));
    all
}

/// Which surface each pixel is of.
struct Grown<'a> {
    reading: &'a Reading,
    surface: Vec<Option<usize>>,
    seeds: Vec<Vec<u32>>,
}

impl<'a> Grown<'a> {
    /// What is smooth and not too small.
    fn seeds(reading: &'a Reading) -> Self {
        Self::seeds_apart(reading, &vec![false; reading.pixels.len()])
    }

    fn seeds_apart(reading: &'a Reading, apart: &[bool]) -> Self {
        let total = reading.pixels.len();
        let is_smooth = |n: u32| {
            let pixel = reading.pixels[n as usize];
            let mut near = neighbors(n, reading);
            near.all(|near| {
                let is_near = distance(pixel, reading.pixels[near as usize]) <= SMOOTH;
                is_near && apart[n as usize] == apart[near as usize]
            })
        };
        let mut is_free: Vec<bool> = (0..total as u32).map(is_smooth).collect();
        let mut grown = Self {
            reading,
            surface: vec![None; total],
            seeds: Vec::new(),
        };
        for first in 0..total as u32 {
            if !std::mem::take(&mut is_free[first as usize]) {
                continue;
            }
            let (mut seed, mut at) = (vec![first], 0);
            while let Some(&n) = seed.get(at) {
                let near = neighbors(n, reading);
                seed.extend(near.filter(|&near| std::mem::take(&mut is_free[near as usize])));
                at += 1;
            }
            if seed.len() >= FEW.max(total / PART) {
                for &n in &seed {
                    grown.surface[n as usize] = Some(grown.seeds.len());
                }
                seed.sort_unstable();
                grown.seeds.push(seed);
            }
        }
        grown
    }

    /// Gives each other pixel to the surface beside it that differs least, the nearest first.
    fn grow(&mut self) {
        let mut queue = BinaryHeap::new();
        let pass = |n: u32, grown: &Self, queue: &mut BinaryHeap<_>| {
            let own = grown.surface[n as usize];
            for near in neighbors(n, grown.reading) {
                if grown.surface[near as usize].is_none() {
                    let [pixel, other] = [n, near].map(|n| grown.reading.pixels[n as usize]);
                    queue.push((Reverse(distance(pixel, other)), Reverse(near), own));
                }
            }
        };
        for n in self.seeds.iter().flatten() {
            pass(*n, self, &mut queue);
        }
        while let Some((_, Reverse(n), own)) = queue.pop() {
            if self.surface[n as usize].is_none() {
                self.surface[n as usize] = own;
                pass(n, self, &mut queue);
            }
        }
    }

    fn surfaces(self) -> Vec<Surface> {
        let mut all: Vec<Vec<u32>> = vec![Vec::new(); self.seeds.len()];
        for (n, own) in (0..).zip(&self.surface) {
            if let Some(own) = own {
                all[*own].push(n);
            }
        }
        let seeds = self.seeds.iter();
        let all = seeds.zip(all).enumerate();
        all.map(|(own, (inner, all))| Surface {
            inner: inner.clone(),
            count: all.len(),
            columns: range(all.iter().map(|n| n % self.reading.width)),
            rows: range(all.iter().map(|n| n / self.reading.width)),
            outline: self.outline(own, &all),
        })
        .collect()
    }

    fn outline(&self, own: usize, all: &[u32]) -> Vec<(f64, f64)> {
        let width = self.reading.width;
        let middle = |one: u32, other: u32| f64::from(one + other) / 2.0;
        let between = |n: u32, near: u32| {
            (
                middle(n % width, near % width),
                middle(n / width, near / width),
            )
        };
        let is_another = |near: &u32| self.surface[*near as usize] != Some(own);
        let all = all.iter().flat_map(|&n| {
            let others = neighbors(n, self.reading).filter(is_another);
            others.map(move |near| between(n, near))
        });
        all.collect()
    }
}

/// From the least of these to the greatest.
fn range(all: impl Iterator<Item = u32> + Clone) -> Range<u32> {
    all.clone().min().unwrap_or(0)..all.max().map_or(0, |last| last + 1)
}

/// The pixels to the left and right, above and below.
fn neighbors(n: u32, reading: &Reading) -> impl Iterator<Item = u32> {
    let (width, total) = (reading.width, reading.pixels.len() as u32);
    let i = n % width;
    let left = (i > 0).then(|| n - 1);
    let right = (i + 1 < width).then(|| n + 1);
    let above = n.checked_sub(width);
    let below = Some(n + width).filter(|n| *n < total);
    [left, right, above, below].into_iter().flatten()
}
