//! Property testing: what a reader's test calls to put a function under the laws, and
//! what lets a law be tried on many values.

use common::rtweekend::*;
use proptest::strategy::Strategy;
use speed_vs_accuracy::Case;

use crate::causes::Cause;
use crate::intervals::{NEAREST_IN_RANGE, RangeSolver, WithInterval};
use crate::nearer_root::{DECISION, NEARER_ROOT, Solver};
use crate::question::{Question, simplified};
use crate::record::{RECORD, Recorded, Recorder};
use crate::report::{self, Report};
use crate::sampling::{cases, chosen_seed, endless};
use crate::trial::{Outcome, Trial};
use crate::verdict::Verdict;

/// Puts `solve` under every law for a nearer root.
///
/// This is what a reader calls from a test of their own, in a package that has
/// `common` and `laws` among its `[dev-dependencies]`, as
/// `{ path = "…/common" }` and `{ path = "…/tests/laws" }`:
///
/// ```
/// use common::rtweekend::*;
///
/// /// Your own function, as you typed it.
/// fn hit_sphere(center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
///     let oc = center - ray.origin;
///     let a = ray.direction.length_squared();
///     let h = ray.direction.dot(oc);
///     let c = oc.length_squared() - radius * radius;
///     let discriminant = h * h - a * c;
///     (discriminant >= 0.0).then(|| (h - discriminant.sqrt()) / a)
/// }
///
/// laws::runner::nearer_root(&hit_sphere);
/// ```
///
/// # Panics
/// If a law is broken: the message says which, by what, and which mistake gives
/// such answers. [`Trial::nearer_root`] returns it instead.
///
/// ```should_panic
/// # use common::rtweekend::*;
/// laws::runner::nearer_root(&|_center, _radius, _ray: &Ray| None);
/// ```
pub fn nearer_root<F: Fn(Point3, f64, &Ray) -> Option<f64> + ?Sized>(solve: &F) {
    succeed(Trial::default().nearer_root(solve));
}

/// Panics with the report, if there is one.
///
/// # Panics
/// If a law is broken.
pub fn succeed(outcome: Outcome) {
    if let Err(report) = outcome {
        panic!("\n\n{report}\n{}", seed());
    }
}

/// The same of several functions. All are tried before the first report is shown, so that
/// all that they answer can be kept.
///
/// # Panics
/// If a law is broken.
pub fn all_succeed<const N: usize>(outcomes: [Outcome; N]) {
    outcomes.into_iter().for_each(succeed);
}

/// Puts `decide` under every law for a decision, with this one case.
///
/// # Panics
/// If a law is broken.
pub fn one_decision(decide: &dyn Fn(Point3, f64, &Ray) -> bool, case: &Case) {
    let solve = |center, radius, ray: &Ray| decide(center, radius, ray).then_some(0.0);
    holds_once(DECISION.into_iter().map(|law| law(&solve, case)));
}

/// Puts `solve` under every law for a nearer root, with this one case.
///
/// # Panics
/// If a law is broken.
pub fn one_case(solve: &Solver, case: &Case) {
    holds_once(NEARER_ROOT.into_iter().map(|law| law(solve, case)));
}

/// Puts a solver with a range under every law for one, with this one case.
///
/// # Panics
/// If a law is broken.
pub fn one_interval(solve: &RangeSolver, case: Case, t_min: f64, t_max: f64) {
    let (least, greatest) = (f64::NEG_INFINITY, f64::INFINITY);
    let nearer = |center, radius, ray: &Ray| solve(center, radius, ray, least, greatest);
    holds_once(NEARER_ROOT.into_iter().map(|law| law(&nearer, &case)));
    let asked = WithInterval { case, t_min, t_max };
    holds_once(NEAREST_IN_RANGE.into_iter().map(|law| law(solve, &asked)));
}

/// Puts what records a hit under every law for that, with this one case.
///
/// # Panics
/// If a law is broken.
pub fn one_record(record: &Recorder, case: &Case) {
    let asked = Recorded(*case);
    holds_once(RECORD.into_iter().map(|law| asked.obeys(record, law)));
}

fn holds_once(mut verdicts: impl Iterator<Item = Verdict>) {
    if let Some(broken) = verdicts.find_map(Verdict::err) {
        panic!("\n\n{broken}\n");
    }
}

/// Tries `law` on as many values of `strategy` as [`cases`] says.
///
/// # Panics
/// If the law is broken, with the simplest case that was found.
pub fn holds<Q: Question>(strategy: &impl Strategy<Value = Q>, law: impl Fn(&Q) -> Verdict) {
    let mut tried = endless(strategy, &chosen_seed()).take(cases() as usize);
    let Some(found) = tried.find(|value| law(value).is_err()) else {
        return;
    };
    let simplest = simplified(found, |simpler| law(simpler).is_err());
    let report = Report {
        broken: law(&simplest).expect_err("simplifying keeps the law broken"),
        cause: Cause::default(),
        others: 0,
        test: report::test(&simplest),
    };
    panic!("\n\n{report}\n{}", seed());
}

/// What finds the same cases again, if they are not those of every run.
fn seed() -> String {
    match chosen_seed().as_str() {
        "" => String::new(),
        seed => format!("\nFound with PROPTEST_SEED={seed}\n"),
    }
}
