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

use crate::Verdict;
use crate::nearer_root::{BAND, EQUATION, Solver, root_bound};
use crate::oracle::Exact;
use crate::question::{Question, code};
use crate::record::{Hit, Recorder};
use crate::strategies;

/// A function from center, radius, ray, `t_min` and `t_max` to the nearest root
/// between the two.
pub type RangeSolver<'a> = dyn Fn(Point3, f64, &Ray, f64, f64) -> Option<f64> + 'a;

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

/// A `t` that is returned lies between the ends. So it is never NaN.
///
/// Says nothing where an end is NaN, or the case is out of scale: what lies between is
/// then a matter of how the comparison is written, and the book writes it the other way.
pub fn no_t_outside_the_interval_is_returned(solve: &RangeSolver, asked: &WithInterval) -> Verdict {
    let WithInterval { case, t_min, t_max } = *asked;
    let is_silent = !case.is_well_scaled() || t_min.is_nan() || t_max.is_nan();
    let Some(t) = asked.solve(solve).filter(|_| !is_silent) else {
        return Ok(());
    };
    prop_assert!(
        t_min < t && t < t_max,
        "the law:  a hit lies inside the open interval (t_min, t_max)\n\
         found:    t = {t:?}\n\
         allowed:  {t_min:?} < t < {t_max:?}, or a miss\n\
         usually:  {}\n\
         read:     chapter 5: both roots are tried, and each must lie in the range",
        if t.is_nan() {
            "`t <= t_min || t_max <= t` lets NaN pass: say `t_min < t && t < t_max`"
        } else {
            "one end is not tested, <= stands for <, or the farther root is not tested at all"
        }
    );
    Ok(())
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
    let roots = [exact.nearer_root(), exact.farther_root()];
    let near_an_end = roots.into_iter().flatten().any(|root| {
        let root = root.rounded();
        (root - t_min).abs() <= bound || (root - t_max).abs() <= bound
    });
    if !case.is_well_scaled() || margin.abs() <= BAND || near_an_end {
        return Ok(());
    }
    let found = asked.solve(solve);
    let root = exact.nearest_root_in(*t_min, *t_max);
    let expected = root.map(|root| root.rounded());
    prop_assert!(
        match (found, expected) {
            (Some(t), Some(root)) => (t - root).abs() <= bound,
            (found, expected) => found.is_none() && expected.is_none(),
        },
        "the law:  the nearest root in the open interval (t_min, t_max) is returned\n\
         found:    {found:?}\n\
         allowed:  {expected:?} ± {bound:.1e}\n\
         usually:  {EQUATION}\n\
         read:     chapter 5: both roots are tried, the nearer one first"
    );
    Ok(())
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

    /// The numbers of a root, without a range. Chapter 2 only says whether there is one: any
    /// number stands for it.
    pub(crate) fn root(&self, chapter: Chapter, solve: &Solver) -> Vec<f64> {
        let root = self.case.solve(solve);
        let is_told = chapter != Chapter::RedSphere;
        let told = root.map(|t| if is_told { t } else { 0.0 });
        told.into_iter().collect()
    }

    /// The numbers of a record. Which side of a tangent is hit is a matter of rounding.
    pub(crate) fn record(&self, record: &Recorder) -> Vec<f64> {
        let Some(hit) = record(self) else {
            return Vec::new();
        };
        if Exact::of(&self.case).discriminant().is_eq() {
            return vec![hit.t];
        }
        let vectors = [hit.point.to_array(), hit.normal.to_array()].concat();
        [vec![hit.t, f64::from(hit.front_face)], vectors].concat()
    }

    /// The record that a program makes.
    pub(crate) fn record_of(&self, program: &Program) -> Option<Hit> {
        let Case {
            center,
            radius,
            ray,
        } = self.case;
        program.record(Ball { center, radius }, &ray, self.t_min, self.t_max)
    }
}

/// What is asked of `hit_sphere` in chapters 2 to 4, and of the `hit` of a sphere in chapter 5:
/// only this has a range.
impl Question for WithInterval {
    fn kind(&self) -> &'static str {
        "sphere"
    }

    fn as_test(&self, chapter: Chapter) -> String {
        let case = "let case = laws::Case::new(center, radius, ray);";
        match chapter {
            Chapter::RedSphere => {
                let is_hit = Exact::of(&self.case).nearer_root().is_some();
                let case = self.case;
                format!("{case}\nassert_eq!(hit_sphere(center, radius, &ray), {is_hit});")
            }
            Chapter::HittableList => format!(
                "{self}\n{case}\nlet asked = laws::WithInterval {{ case, t_min, t_max }};\n\
                 laws::holds(laws::record::obeys_every_law(&record, &asked));"
            ),
            _ => format!(
                "{}\n{case}\nlaws::holds(laws::nearer_root::obeys_every_law(&hit_sphere, &case));",
                self.case
            ),
        }
    }

    fn answer_of(&self, program: &Program) -> Vec<f64> {
        let solve = |center, radius, ray: &Ray| program.hit_sphere(center, radius, ray);
        match program.chapter {
            Chapter::HittableList => self.record(&|asked| asked.record_of(program)),
            chapter => self.root(chapter, &solve),
        }
    }

    fn ordinary(_: Chapter) -> BoxedStrategy<Self> {
        strategies::with_interval(strategies::ordinary()).boxed()
    }

    fn kinds(_: Chapter) -> Vec<BoxedStrategy<Self>> {
        let kinds = strategies::kinds();
        kinds
            .map(|kind| strategies::with_interval(kind).boxed())
            .into()
    }
}
