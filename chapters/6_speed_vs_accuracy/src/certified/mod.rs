//! Filtered predicates: answers that are proven, ray by ray, while they are computed.
//!
//! A filter computes as `half_b_q` does, and knows how far off it can be. Nearly always that is
//! enough. If not, the question is asked again in integers, where nothing is rounded. Source of
//! the idea: Fortune and Van Wyk, *Efficient Exact Arithmetic for Computational Geometry*, 1993.
//!
//! # The theorem
//!
//! `certified.md` of the notes states it once, with its conditions. Of finite input, a direction
//! that is not zero, and a range that contains an `f64`, [`certified_hit`] and [`certified_t`]
//! say rightly hit or miss, and which of the two roots; the `t` of [`certified_t`] is off by less
//! than 0.8 ulp, that of [`certified_hit`] has the digits of `half_b_q`. All other input is a miss.
//! Rust on x86-64 and on 64-bit ARM meets what it asks of rounding, unless other code in the
//! program flushes tiny numbers to zero.
//!
//! Each bound has a letter, which stands beside it here and in the book, in `proofs.md`.

mod exact;
mod filter;
mod fixed_width;
mod refined;

use common::rtweekend::*;

use crate::method::Method;
use crate::workload::Case;
use filter::{Unclear, filter};
use fixed_width::fixed_width;

pub(crate) use exact::comes_before;
pub use exact::{exact, exact_discriminant};

/// Finds the nearest root with `t_min` < `t` < `t_max`. Hit or miss, and which of the two roots it
/// is, are proven right for finite input, a direction that is not 0 and a range that holds an
/// `f64`: see the [theorem](self). All other input is a miss.
///
/// Cost: 1 √, 1 ÷, and a few + and × more than `half_b_q`. Some thirty times as much where
/// `half_b_q` could decide wrongly, because the sphere is far, or the ray starts on its surface or
/// nearly touches it; and as much as [`exact`](crate::exact()) if lengths differ by a factor of
/// 2⁶⁷. Error of t: that of `half_b_q`, and half an ulp where integers decide.
#[inline]
pub fn certified_hit(
    center: Point3,
    radius: f64,
    ray: &Ray,
    t_min: f64,
    t_max: f64,
) -> Option<f64> {
    staged::<false>(Case::new(center, radius, *ray), t_min, t_max).0
}

/// Finds the root that [`certified_hit`] finds, with a `t` that is proven to be less than 0.8 ulp
/// off: see the [theorem](self).
///
/// Cost: that of `certified_hit`, and for a hit 1 ÷ and 90 + or × more. Integers decide also if D
/// or c is small: from some 250 radii away, and close to the surface.
#[inline]
pub fn certified_t(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
    staged::<true>(Case::new(center, radius, *ray), t_min, t_max).0
}

/// A stage of a certified method. A case that one stage cannot decide goes to the next, which is
/// slower.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Stage {
    /// The first stage: plain `f64` with an error bound.
    Filter,
    /// The second stage: integers of fixed width.
    FixedWidth,
    /// The last stage: integers of any length.
    Exact,
}

/// Returns the stage that decides in [`certified_hit`] about `case` with `t_min` < `t` < `t_max`.
pub fn stage_of_hit(case: &Case, t_min: f64, t_max: f64) -> Stage {
    staged::<false>(*case, t_min, t_max).1
}

/// Returns the answer to a case, and the stage that decides it.
#[inline(always)]
fn staged<const ULP: bool>(case: Case, t_min: f64, t_max: f64) -> (Option<f64>, Stage) {
    let t = filter::<ULP>(&case, t_min, t_max);
    if t.is_nan() {
        return later_stages(case.numbers(), t_min, t_max);
    }
    ((t < f64::INFINITY).then_some(t), Stage::Filter)
}

/// Decides a case that the filter leaves open; returns the answer and the stage. The numbers are
/// passed by value: if a center or a ray were passed by reference, it would be kept in memory, and
/// the filter would wait for that.
#[cold]
#[inline(never)]
fn later_stages(numbers: [f64; 10], t_min: f64, t_max: f64) -> (Option<f64>, Stage) {
    let case = Case::from_numbers(numbers);
    match fixed_width(case.center, case.radius, &case.ray, t_min, t_max) {
        Ok(t) => (t, Stage::FixedWidth),
        Err(Unclear) => (case.put_to(&Method::EXACT, t_min, t_max), Stage::Exact),
    }
}
