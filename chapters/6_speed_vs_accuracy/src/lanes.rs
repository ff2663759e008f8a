//! Auto-vectorization: a block of questions at once, each in a SIMD lane, by the methods
//! themselves.
//!
//! Where a loop does the same to numbers that lie side by side, the compiler turns it
//! into instructions that do it to four or eight of them at once. Here such a loop asks
//! one of the methods, unchanged. It does so for methods that it can see through: of an
//! `if` both sides are computed, and one is taken. What needs a loop of its own, or
//! calls a function that is too long, keeps its answers and loses its lanes.

use multiversion::multiversion;

use crate::certified::{filter, later_stages};
use crate::workload::Case;

/// Questions in a block: so few that they stay near the processor, and a multiple of the
/// lanes that it has.
pub const BLOCK: usize = 64;

/// The answers to the questions 0, 1 and so on, one in each lane.
///
/// The compiler makes three versions, for any processor, for AVX2 and for AVX-512, and the
/// program chooses when it runs. An operation rounds alike in all of them.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512bw+avx512vl", "x86_64+avx2"))]
pub fn in_lanes<T, F: Fn(usize) -> T>(answers: &mut [T; BLOCK], answer: F) {
    for (k, place) in answers.iter_mut().enumerate() {
        *place = answer(k);
    }
}

/// What [`certified_hit`](crate::certified_hit), or if `ULP` [`certified_t`](crate::certified_t),
/// answers to each case; infinity for a miss.
///
/// The filter decides in lanes. It is nearly always certain of all; what it leaves open is
/// asked one by one, in integers.
#[inline]
pub fn certified_in_lanes<const ULP: bool>(
    answers: &mut [f64; BLOCK],
    case: impl Fn(usize) -> Case,
    t_min: f64,
    t_max: f64,
) {
    in_lanes(
        answers,
        #[inline(always)]
        |k| {
            let Case {
                center,
                radius,
                ray,
            } = case(k);
            filter::<ULP>(center, radius, &ray, t_min, t_max)
        },
    );
    if some_are_nan(answers) {
        for (k, t) in answers.iter_mut().enumerate().filter(|(_, t)| t.is_nan()) {
            let Case {
                center,
                radius,
                ray,
            } = case(k);
            let (answer, _) = later_stages(center, radius, &ray, t_min, t_max);
            *t = answer.unwrap_or(f64::INFINITY);
        }
    }
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512bw+avx512vl", "x86_64+avx2"))]
fn some_are_nan(answers: &[f64; BLOCK]) -> bool {
    answers.iter().fold(false, |any, t| any | t.is_nan())
}
