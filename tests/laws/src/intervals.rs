//! Laws for a solver with a range of `t`, as `Sphere::hit` of chapter 5
//! and every method of chapter 6 has.
//!
//! The range is open: a root at `t_min` or `t_max` does not count. The bounds
//! are those of [`nearer_root`](crate::nearer_root).

use std::fmt;

use common::rtweekend::*;
use speed_vs_accuracy::Case;

use crate::nearer_root::{BAND, EQUATION, root_bound};
use crate::numbers;
use crate::oracle::Exact;
use crate::verdict::{Broken, Verdict};

/// A function from center, radius, ray, `t_min` and `t_max` to the nearest root
/// between the two.
pub type RangeSolver<'a> = dyn Fn(Point3, f64, &Ray, f64, f64) -> Option<f64> + 'a;

/// A law for a solver with a range.
pub type RangeLaw = fn(&RangeSolver, &WithInterval) -> Verdict;

/// Every law for a solver with a range.
pub const NEAREST_IN_RANGE: [RangeLaw; 3] = [
    no_t_outside_the_interval_is_returned,
    the_farther_root_is_the_nearer_one_of_the_ray_turned_round,
    the_nearest_root_in_the_interval_is_returned,
];

/// A `t` that is returned lies between the ends. So it is never NaN.
///
/// Says nothing where an end is NaN, or the case is out of scale: what lies between is
/// then a matter of how the comparison is written, and the book writes it the other way.
pub fn no_t_outside_the_interval_is_returned(solve: &RangeSolver, asked: &WithInterval) -> Verdict {
    let WithInterval { case, t_min, t_max } = *asked;
    if !case.is_well_scaled() || t_min.is_nan() || t_max.is_nan() {
        return Ok(());
    }
    match asked.solve(solve) {
        Some(t) if !(t_min < t && t < t_max) => Err(Broken {
            law: "a hit lies inside the open interval (t_min, t_max)",
            found: format!("t = {t:?}"),
            allowed: format!("{t_min:?} < t < {t_max:?}, or a miss"),
            usually: if t.is_nan() {
                "`t <= t_min || t_max <= t` lets NaN pass: say `t_min < t && t < t_max`"
            } else {
                "one end is not tested, <= stands for <, or the farther root is not tested at all"
            },
            page: "chapter 5: both roots are tried, and each must lie in the range",
        }),
        _ => Ok(()),
    }
}

/// Turning the ray round turns the sign of every root and changes no bit: the
/// farther root, which the range behind the nearer one finds, is as good.
pub fn the_farther_root_is_the_nearer_one_of_the_ray_turned_round(
    solve: &RangeSolver,
    asked: &WithInterval,
) -> Verdict {
    let on_the_line = |case: Case, t_min| {
        WithInterval {
            case,
            t_min,
            t_max: f64::INFINITY,
        }
        .solve(solve)
    };
    let case = asked.case;
    let (Some(nearer), Some(turned)) = (
        on_the_line(case, f64::NEG_INFINITY),
        on_the_line(case.turned_round(), f64::NEG_INFINITY),
    ) else {
        return Ok(());
    };
    let farther = on_the_line(case, nearer).unwrap_or(nearer);
    if farther == -turned || !case.is_well_scaled() {
        return Ok(());
    }
    Err(Broken {
        law: "the farther root is the nearer one of the ray turned round, negated",
        found: format!("{farther:?}"),
        allowed: format!("{:?}, and no other bit", -turned),
        usually: "the farther root is computed in another way than the nearer one: it is \
                (h + √discriminant) / a",
        page: "equation (12) of the notes, with both signs",
    })
}

/// The root that is returned is the nearest in the interval, and it is found
/// if there is one. Silent where rounding may carry a root across an end, or
/// decide about the hit.
pub fn the_nearest_root_in_the_interval_is_returned(
    solve: &RangeSolver,
    asked: &WithInterval,
) -> Verdict {
    let WithInterval { case, t_min, t_max } = asked;
    let exact = Exact::of(case);
    let margin = exact.discriminant_margin();
    let bound = root_bound(case, margin);
    let near_an_end = [exact.nearer_root(), exact.farther_root()]
        .into_iter()
        .flatten()
        .any(|root| {
            let root = root.rounded();
            (root - t_min).abs() <= bound || (root - t_max).abs() <= bound
        });
    if !case.is_well_scaled() || margin.abs() <= BAND || near_an_end {
        return Ok(());
    }
    let found = asked.solve(solve);
    let expected = exact
        .nearest_root_in(*t_min, *t_max)
        .map(|root| root.rounded());
    match (found, expected) {
        (None, None) => Ok(()),
        (Some(t), Some(root)) if (t - root).abs() <= bound => Ok(()),
        _ => Err(Broken {
            law: "the nearest root in the open interval (t_min, t_max) is returned",
            found: format!("{found:?}"),
            allowed: expected.map_or("a miss".to_owned(), |root| {
                format!("{root:?} ± {bound:.1e}")
            }),
            usually: EQUATION,
            page: "chapter 5: both roots are tried, the nearer one first",
        }),
    }
}

/// For every finite input, there is a hit exactly if a root lies in the interval,
/// and `t` is nearer to that root than rounding alone explains.
///
/// One exception is by definition: between two neighbors there is no `f64` to
/// return, so an interval like that is missed.
pub fn the_decision_is_exactly_right(solve: &RangeSolver, asked: &WithInterval) -> Verdict {
    let WithInterval { case, t_min, t_max } = asked;
    let exact = Exact::of(case);
    let has_numbers = t_min.next_up() < *t_max;
    let root = exact
        .nearest_root_in(*t_min, *t_max)
        .filter(|_| has_numbers);
    let found = asked.solve(solve);
    let is_right = match (found, root) {
        (None, None) => true,
        (Some(t), Some(root)) => {
            let bound = root_bound(case, exact.discriminant_margin());
            let is_near = (t - root.rounded()).abs() <= bound || root.error_in_ulps(t) <= 1.0;
            t_min < &t && &t < t_max && (is_near || !case.is_well_scaled())
        }
        _ => false,
    };
    if is_right {
        return Ok(());
    }
    Err(Broken {
        law: "the decision is exactly right",
        found: format!("{found:?}"),
        allowed: match root {
            Some(root) => format!("a hit near {:?}", root.rounded()),
            None => "a miss".to_owned(),
        },
        usually: "a bound of the filter is too narrow, or an end of its range of exponents is open",
        page: "the proofs of chapter 6",
    })
}

/// For every finite input, `t` is within so many ulps of the nearest root in the
/// interval; a root that no `f64` reaches becomes the largest one.
pub fn t_is_within_ulps(solve: &RangeSolver, asked: &WithInterval, ulps: f64) -> Verdict {
    let exact = Exact::of(&asked.case);
    let root = exact.nearest_root_in(asked.t_min, asked.t_max);
    let (Some(t), Some(root)) = (asked.solve(solve), root) else {
        return Ok(());
    };
    let error = root.error_in_ulps(t);
    if error <= ulps || (root.rounded().is_infinite() && t.abs() == f64::MAX) {
        return Ok(());
    }
    Err(Broken {
        law: "t is the exact root, rounded",
        found: format!("t = {t:?}, {error:.3} ulps away"),
        allowed: format!("{:?} ± {ulps} ulps", root.rounded()),
        usually: "a bound of the filter is too narrow, or its last step loses digits",
        page: "the proofs of chapter 6",
    })
}

/// A case with a range of `t`, as the laws for intervals take it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WithInterval {
    /// The ray and the sphere.
    pub case: Case,
    /// The lower end, left out.
    pub t_min: f64,
    /// The upper end, left out.
    pub t_max: f64,
}

impl fmt::Display for WithInterval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { case, t_min, t_max } = self;
        let [t_min, t_max] = [t_min, t_max].map(|&end| numbers::code(end));
        write!(f, "{case}\nlet (t_min, t_max) = ({t_min}, {t_max});")
    }
}

impl WithInterval {
    /// The answer of `solve` to this case.
    pub fn solve(&self, solve: &RangeSolver) -> Option<f64> {
        let Case {
            center,
            radius,
            ray,
        } = &self.case;
        solve(*center, *radius, ray, self.t_min, self.t_max)
    }
}
