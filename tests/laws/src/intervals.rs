//! Laws for a solver with a range of `t`, as `Sphere::hit` of chapter 5
//! and every method of chapter 6 has.
//!
//! The range is open: a root at `t_min` or `t_max` does not count. The bounds
//! are those of [`nearer_root`](crate::nearer_root).

use std::fmt;

use common::rtweekend::*;
use proptest::prelude::*;
use slips::{Ball, Chapter, Program};
use speed_vs_accuracy::Case;

use crate::broken::{Broken, Verdict};
use crate::nearer_root::{BAND, EQUATION, root_bound};
use crate::oracle::Exact;
use crate::question::{Question, code, numbers};
use crate::strategies;

/// A function from center, radius, ray, `t_min` and `t_max` to the nearest root
/// between the two.
pub type RangeSolver<'a> = dyn Fn(Point3, f64, &Ray, f64, f64) -> Option<f64> + 'a;

/// A law for a solver with a range.
pub type RangeLaw = fn(&RangeSolver, &WithInterval) -> Verdict;

/// Every law for a solver with a range.
pub const NEAREST_IN_RANGE: [RangeLaw; 2] = [
    no_t_outside_the_interval_is_returned,
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
        let [t_min, t_max] = [t_min, t_max].map(|&end| code(&[end]));
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

    pub(crate) fn ball(&self) -> Ball {
        Ball {
            center: self.case.center,
            radius: self.case.radius,
        }
    }
}

/// What the `hit` of a sphere in chapter 5 is asked.
impl Question for WithInterval {
    fn kind(&self) -> &'static str {
        "hit"
    }

    fn as_test(&self, _: Chapter) -> String {
        format!(
            "{self}\nlaws::trial::one_interval(&hit, laws::Case {{ center, radius, ray }}, t_min, t_max);"
        )
    }

    fn answer_of(&self, program: &Program) -> Vec<f64> {
        let t = program.hit(self.ball(), &self.case.ray, self.t_min, self.t_max);
        numbers(t.map(|t| [t]))
    }

    fn ordinary(_: Chapter) -> BoxedStrategy<Self> {
        strategies::with_interval(strategies::ordinary()).boxed()
    }

    fn cases(_: Chapter) -> Vec<BoxedStrategy<Self>> {
        let kinds = strategies::kinds();
        kinds
            .map(|kind| strategies::with_interval(kind).boxed())
            .into()
    }
}
