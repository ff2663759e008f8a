//! Auto-vectorization: a block of questions at once, each in a SIMD lane, by the methods
//! themselves.
//!
//! Where a loop does the same to numbers that lie side by side, the compiler turns it
//! into instructions that do it to four or eight of them at once. Here such a loop asks
//! one of the methods, unchanged. It does so for methods that it can see through: of an
//! `if` both sides are computed, and one is taken. What needs a loop of its own, or
//! calls a function that is too long, keeps its answers and loses its lanes.

use multiversion::multiversion;

use crate::certified::{FilteredRoot, Rounded, later_stages};
use crate::workload::Case;

/// The number of questions that [`in_lanes`] answers at once: so few that they stay in the
/// processor's cache, and a multiple of its SIMD lanes.
pub const BLOCK: usize = 64;

/// Fills `answers` with `answer(0)`, `answer(1)` and so on, computed side by side in SIMD lanes.
///
/// The compiler makes three versions, for any processor, for AVX2 and for AVX-512, and the program
/// chooses when it runs. All three give the same bits.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512bw+avx512vl+fma", "x86_64+avx2+fma"))]
pub fn in_lanes<T, F: Fn(usize) -> T>(answers: &mut [T; BLOCK], answer: F) {
    for (k, place) in answers.iter_mut().enumerate() {
        *place = answer(k);
    }
}

/// Answers the case `case(k)` in `answers[k]` for each k of a block, as
/// [`certified_hit`](crate::certified_hit) does, or if `ULP` is true as
/// [`certified_t`](crate::certified_t), to the bit; infinity stands for a miss.
///
/// The filter decides the whole block in lanes, by signs or by gaps as the range allows; a single
/// question is decided in the same way. Nearly always it is certain of all; a case that it leaves
/// open is then decided by itself, in integers.
#[inline]
pub fn certified_in_lanes<const ULP: bool>(
    answers: &mut [f64; BLOCK],
    case: impl Fn(usize) -> Case,
    t_min: f64,
    t_max: f64,
) {
    let has_numbers = t_min < t_max;
    let some_are_open = if !has_numbers {
        answers.fill(f64::INFINITY);
        false
    } else if t_min == 0.0 && t_max == f64::INFINITY {
        filtered(answers, by::<ULP>(&case, |rounded| rounded.by_signs(None)))
    } else if t_min == 0.0 {
        filtered(
            answers,
            by::<ULP>(&case, |rounded| rounded.by_signs(Some(t_max))),
        )
    } else {
        filtered(
            answers,
            by::<ULP>(&case, |rounded| rounded.by_gaps(t_min, t_max)),
        )
    };
    if some_are_open {
        for (k, t) in answers.iter_mut().enumerate().filter(|(_, t)| t.is_nan()) {
            let (answer, _) = later_stages(case(k).numbers(), t_min, t_max);
            *t = answer.unwrap_or(f64::INFINITY);
        }
    }
}

/// Makes a filter that chooses the root of a case by `root`.
#[inline(always)]
fn by<const ULP: bool>(
    case: impl Fn(usize) -> Case,
    root: impl Fn(&Rounded) -> FilteredRoot,
) -> impl Fn(usize) -> f64 {
    #[inline(always)]
    move |k| {
        let case = case(k);
        let rounded = Rounded::of(&case);
        rounded.answer::<ULP>(&case, root(&rounded))
    }
}

/// Computes all answers as [`in_lanes`] does, and returns true if some are NaN.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512bw+avx512vl+fma", "x86_64+avx2+fma"))]
fn filtered<F: Fn(usize) -> f64>(answers: &mut [f64; BLOCK], answer: F) -> bool {
    let mut some_are_nan = false;
    for (k, place) in answers.iter_mut().enumerate() {
        *place = answer(k);
        some_are_nan |= place.is_nan();
    }
    some_are_nan
}
