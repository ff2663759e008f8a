//! Property testing: a runner that puts a function under laws, and reports a broken
//! one so that it teaches.

use std::env;
use std::fmt::Debug;

use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use speed_vs_accuracy::Case;

use crate::intervals::{NEAREST_IN_RANGE, RangeSolver, WithInterval};
use crate::nearer_root::{Law, NEARER_ROOT, Solver};
use crate::shrinker::{Simplify, simplified};
use crate::strategies;
use crate::verdict::{Broken, Verdict};

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
/// If a law is broken: the message says which, by what, and what usually makes
/// it so.
///
/// ```should_panic
/// # use common::rtweekend::*;
/// laws::runner::nearer_root(&|_center, _radius, _ray: &Ray| None);
/// ```
pub fn nearer_root(solve: &Solver) {
    for law in NEARER_ROOT {
        judge(law, solve);
    }
}

/// Puts `solve` under one law, with cases from everywhere.
///
/// # Panics
/// If the law is broken.
pub fn judge(law: Law, solve: &Solver) {
    holds(&strategies::anywhere(), |case| law(solve, case));
}

/// Puts `solve` under every law, with this one case.
///
/// # Panics
/// If a law is broken.
pub fn one_case(solve: &Solver, case: &Case) {
    for law in NEARER_ROOT {
        if let Err(broken) = law(solve, case) {
            panic!("{}", report(case, &broken));
        }
    }
}

/// Puts a solver with a range under every law for one.
///
/// # Panics
/// If a law is broken.
pub fn nearest_in_range(solve: &RangeSolver) {
    let strategy = strategies::with_interval(strategies::anywhere());
    for law in NEAREST_IN_RANGE {
        holds(&strategy, |asked| law(solve, asked));
    }
}

/// Puts a solver with a range under every law, with this one case.
///
/// # Panics
/// If a law is broken.
pub fn one_interval(solve: &RangeSolver, asked: &WithInterval) {
    for law in NEAREST_IN_RANGE {
        if let Err(broken) = law(solve, asked) {
            panic!("{}", report(asked, &broken));
        }
    }
}

/// Tries `law` on as many values of `strategy` as [`cases`] says.
///
/// # Panics
/// If the law is broken, with the simplest case that was found.
pub fn holds<T: Simplify>(strategy: &impl Strategy<Value = T>, law: impl Fn(&T) -> Verdict) {
    if let Some((value, broken)) = first_broken(strategy, cases(), law) {
        panic!("{}", report(&value, &broken));
    }
}

/// Tries `law` on `count` values of `strategy`. If it is broken, returns how, and
/// the simplest value that was found to break it.
pub fn first_broken<T: Simplify>(
    strategy: &impl Strategy<Value = T>,
    count: u32,
    law: impl Fn(&T) -> Verdict,
) -> Option<(T, Broken)> {
    let mut runner = runner(&chosen_seed());
    for _ in 0..count {
        let mut tree = new_tree(strategy, &mut runner);
        if law(&tree.current()).is_err() {
            shrink(&mut tree, &law);
            let simplest = simplified(tree.current(), &law);
            let broken = law(&simplest).expect_err("simplifying keeps the law broken");
            return Some((simplest, broken));
        }
    }
    None
}

/// The first `count` values of `strategy`, the same in every run.
pub fn samples<T: Debug>(strategy: &impl Strategy<Value = T>, count: u32) -> Vec<T> {
    endless(strategy, &chosen_seed())
        .take(count as usize)
        .collect()
}

/// Values of `strategy` without end, the same whenever the seed is.
pub fn endless<T: Debug>(
    strategy: &impl Strategy<Value = T>,
    seed: &str,
) -> impl Iterator<Item = T> {
    let mut runner = runner(seed);
    std::iter::repeat_with(move || new_tree(strategy, &mut runner).current())
}

/// How many cases a law is tried on: 1000, or what the environment variable
/// `PROPTEST_CASES` says.
pub fn cases() -> u32 {
    env::var("PROPTEST_CASES")
        .ok()
        .and_then(|number| number.parse().ok())
        .unwrap_or(1000)
}

/// Lets proptest make the value smaller as long as the law stays broken.
fn shrink<T>(tree: &mut impl ValueTree<Value = T>, law: &impl Fn(&T) -> Verdict) {
    const STEPS: usize = 2000;
    for _ in 0..STEPS {
        let moved = if law(&tree.current()).is_err() {
            tree.simplify()
        } else {
            tree.complicate()
        };
        if !moved {
            break;
        }
    }
    while law(&tree.current()).is_ok() && tree.complicate() {}
}

/// The same cases in every run, so that a failure is never luck; or the cases
/// of another seed, with the environment variable `PROPTEST_SEED`.
fn runner(seed: &str) -> TestRunner {
    let mut bytes = [0; 32];
    for (byte, letter) in bytes.iter_mut().zip(seed.bytes()) {
        *byte = letter;
    }
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &bytes);
    TestRunner::new_with_rng(Config::default(), rng)
}

fn chosen_seed() -> String {
    env::var("PROPTEST_SEED").unwrap_or_default()
}

fn new_tree<S: Strategy>(strategy: &S, runner: &mut TestRunner) -> S::Tree {
    strategy
        .new_tree(runner)
        .expect("no strategy here filters anything out")
}

fn report(value: &impl Simplify, broken: &Broken) -> String {
    let indented = value.as_test().replace('\n', "\n    ");
    let seed = match chosen_seed().as_str() {
        "" => String::new(),
        seed => format!("\n\nFound with PROPTEST_SEED={seed}"),
    };
    format!(
        "\n\nA law is broken.\n\n{broken}\n\nThe simplest case that was found, as a test:\n\n\
         #[test]\nfn this_case_is_right() {{\n    use common::rtweekend::*;\n    {indented}\n}}{seed}\n"
    )
}
