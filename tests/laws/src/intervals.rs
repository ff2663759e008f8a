//! Laws for a solver with a range of `t`, as `Sphere::hit` of chapter 5
//! and every method of chapter 6 has.
//!
//! The range is open: a root at `t_min` or `t_max` does not count. The bounds
//! are those of [`nearer_root`](crate::nearer_root).

use crate::case::{IntervalCase, RangeSolver};
use crate::nearer_root::{BAND, root_bound, said};
use crate::oracle::ExactCase;
use crate::verdict::{BrokenLaw, LawResult};

/// Tests that the `t` that `solve` returns for a ray, a sphere and an interval lies between the
/// interval's ends, both excluded; so it is never NaN. A miss is right here.
///
/// Makes no claim where an end is NaN, or where numbers are so large or small that the equation may
/// overflow.
pub fn no_t_outside_the_interval_is_returned(
    solve: &RangeSolver,
    asked: &IntervalCase,
) -> LawResult {
    let IntervalCase { case, t_min, t_max } = *asked;
    let is_silent = !case.is_well_scaled() || t_min.is_nan() || t_max.is_nan();
    let found = asked.solve(solve);
    let is_outside = |t: &f64| !(t_min < *t && *t < t_max);
    match found.filter(is_outside) {
        Some(t) if !is_silent => Err(BrokenLaw {
            law: "a hit lies inside the open interval (t_min, t_max)".into(),
            found: format!("t = {t:?}"),
            allowed: format!("{t_min:?} < t < {t_max:?}, or a miss"),
            read: "chapter 5: both roots are tried, and each must lie in the range".into(),
        }),
        _ => Ok(()),
    }
}

/// Tests that `solve` returns the nearest root between the ends of the interval, or none if no root
/// lies there.
///
/// Makes no claim where rounding could move a root across an end of the interval, or decide between
/// hit and miss, or where numbers are so large or small that the equation may overflow.
pub fn the_nearest_root_in_the_interval_is_returned(
    solve: &RangeSolver,
    asked: &IntervalCase,
) -> LawResult {
    let IntervalCase { case, t_min, t_max } = *asked;
    let exact = ExactCase::of(&case);
    let margin = exact.discriminant_margin();
    let bound = root_bound(&case, margin);
    let roots = [exact.nearer_root(), exact.farther_root()];
    let near_an_end = roots.into_iter().flatten().any(|root| {
        let root = root.rounded();
        (root - t_min).abs() <= bound || (root - t_max).abs() <= bound
    });
    if !case.is_well_scaled() || margin.abs() <= BAND || near_an_end {
        return Ok(());
    }
    let found = asked.solve(solve);
    let root = exact.nearest_root_in(t_min, t_max);
    let expected = root.map(|root| root.rounded());
    let is_right = match (found, expected) {
        (Some(t), Some(root)) => (t - root).abs() <= bound,
        (found, expected) => found.is_none() && expected.is_none(),
    };
    let rounding = expected.map_or(String::new(), |_| format!(" ± {bound:.1e}"));
    BrokenLaw::unless(is_right, || BrokenLaw {
        law: "the nearest root in the open interval (t_min, t_max) is returned".into(),
        found: said(found),
        allowed: format!("{}{rounding}, in ({t_min:?}, {t_max:?})", said(expected)),
        read: "chapter 5: both roots are tried, the nearer one first".into(),
    })
}
