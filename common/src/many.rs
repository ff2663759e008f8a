//! Eighty of a kind at once.
//!
//! A processor adds four or eight pairs of numbers in the time that one takes,
//! and divides them nearly so. The compiler sees to that by itself where a loop
//! does the same, turn by turn, to numbers that lie side by side. So all there
//! is to do is to lay them side by side, and to loop.

use std::marker::PhantomData;

#[cfg(not(plain))]
use multiversion::multiversion;

use crate::color::Color;

/// How many there are in [`Many`]: a number that processors like, a multiple of
/// 16, and that divides the width of most pictures: 400, 1280, 1920, 3840.
pub(crate) const MANY: usize = 80;

/// Many things that are made of `N` numbers each: first the first numbers of
/// all things, then all second ones, and so on.
#[derive(Clone, Debug)]
pub struct Many<T, const N: usize> {
    columns: [[f64; MANY]; N],
    things: PhantomData<T>,
}

impl<T: From<[f64; N]> + Into<[f64; N]>, const N: usize> Many<T, N> {
    /// Many times the same `thing`.
    #[inline]
    pub fn repeat(thing: T) -> Self {
        Self {
            columns: thing.into().map(|number| [number; MANY]),
            things: PhantomData,
        }
    }

    /// Replaces each `thing`, the one with the number `k`, by `next(k, thing)`.
    #[inline]
    pub fn update(&mut self, next: impl Fn(usize, T) -> T) {
        update(
            &mut self.columns,
            #[inline(always)]
            |k, numbers| next(k, T::from(numbers)).into(),
        );
    }

    /// The thing with the number `k`, from 0 to 79.
    #[inline(always)]
    pub fn get(&self, k: usize) -> T {
        self.columns
            .each_ref()
            .map(
                #[inline(always)]
                |column| column[k],
            )
            .into()
    }
}

/// Many pixels: the bytes that a picture stores.
#[derive(Clone, Debug)]
pub struct Pixels {
    pub(crate) red: [u8; MANY],
    pub(crate) green: [u8; MANY],
    pub(crate) blue: [u8; MANY],
}

impl Pixels {
    pub(crate) const BLACK: Self = Self {
        red: [0; MANY],
        green: [0; MANY],
        blue: [0; MANY],
    };

    /// Pixels of known bytes, three each, for at most [`MANY`] of them.
    pub(crate) fn from_rgb(rgb: &[u8]) -> Self {
        let mut pixels = Self::BLACK;
        let (all, _) = rgb.as_chunks::<3>();
        for (k, &[red, green, blue]) in all.iter().enumerate() {
            (pixels.red[k], pixels.green[k], pixels.blue[k]) = (red, green, blue);
        }
        pixels
    }

    /// Pixels of the colors `color(0)`, `color(1)` and so on.
    #[inline]
    pub fn paint(color: impl Fn(usize) -> Color) -> Self {
        let mut pixels = Self::BLACK;
        paint(&mut pixels, color);
        pixels
    }
}

// The compiler makes three versions of each of these loops: for any
// processor, for one with AVX2 (four numbers at once), and for one with AVX-512
// (eight). The program chooses when it runs. An operation rounds alike in all.
//
// It takes several turns at once only if it can see all that happens in one:
// hence `#[inline(always)]` on what is called for every ray. Where it cannot,
// the loop takes longer and does the same.
//
// `--cfg plain` leaves only the version for any processor, for `.ci/run` to try.

#[cfg_attr(
    not(plain),
    multiversion(targets("x86_64+avx512f+avx512dq+avx512bw+avx512vl", "x86_64+avx2"))
)]
fn update<F: Fn(usize, [f64; N]) -> [f64; N], const N: usize>(
    columns: &mut [[f64; MANY]; N],
    next: F,
) {
    for k in 0..MANY {
        let numbers = next(k, columns.each_ref().map(|column| column[k]));
        for (column, number) in columns.iter_mut().zip(numbers) {
            column[k] = number;
        }
    }
}

#[cfg_attr(
    not(plain),
    multiversion(targets("x86_64+avx512f+avx512dq+avx512bw+avx512vl", "x86_64+avx2"))
)]
fn paint<F: Fn(usize) -> Color>(pixels: &mut Pixels, color: F) {
    let [mut red, mut green, mut blue] = [[f64::NAN; MANY]; 3];
    for k in 0..MANY {
        [red[k], green[k], blue[k]] = color(k).to_array();
    }
    store(&red, &mut pixels.red);
    store(&green, &mut pixels.green);
    store(&blue, &mut pixels.blue);
}

#[cfg_attr(
    not(plain),
    multiversion(targets("x86_64+avx512f+avx512dq+avx512bw+avx512vl", "x86_64+avx2"))
)]
fn store(components: &[f64; MANY], levels: &mut [u8; MANY]) {
    for (to, &component) in levels.iter_mut().zip(components) {
        *to = level(component);
    }
}

/// The same level as that of `write_color`, without a decision.
///
/// A processor turns one number at a time into an integer. To add 2⁵² does that
/// too, for several numbers at once: no `f64` from there on has digits after the
/// point, and its last bits are the integer. It rounds to the nearest one, which
/// may be one too many.
#[inline(always)]
#[expect(
    clippy::manual_clamp,
    reason = "`clamp` keeps NaN, which becomes 0 here"
)]
fn level(component: f64) -> u8 {
    const TWO_TO_THE_52: f64 = (1_u64 << 52) as f64;
    let scaled = (255.999 * component).max(0.0).min(255.0);
    let nearest = scaled + TWO_TO_THE_52;
    let too_many = nearest - TWO_TO_THE_52 > scaled;
    (nearest.to_bits() - u64::from(too_many)) as u8
}
