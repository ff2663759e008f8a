//! The methods of chapter 6: what each one promises.
//!
//! Laws and bounds are those of the chapters. The judge is `laws::oracle`, which
//! shares no line with the method `exact`: each would notice a mistake of the
//! other.

use common::rtweekend::*;
use hittable_list::{Hittable, Sphere};
use laws::nearer_root::{self, root_bound};
use laws::oracle::ExactCase;
use laws::strategies::{self, samples};
use laws::{IntervalCase, LawResult, RangeSolver, config, intervals};
use proptest::prelude::*;
use proptest::test_runner::{RngSeed, TestCaseError, TestCaseResult, TestRunner};
use speed_vs_accuracy::{
    Case, METHODS, Method, Precision, Stage, certified_hit, certified_t, double_double, exact,
    half_b, stage_of_hit,
};

use crate::methods::{bands, hostile, question};

const CASES: u32 = 4000;

mod every_method {
    use super::*;

    proptest! {
        #![proptest_config(ProptestConfig { cases: 1000, ..config() })]

        /// The bounds are those of `half_b`, the worst of all.
        #[test]
        fn returns_the_nearest_root_in_the_interval(
            asked in strategies::with_interval(strategies::any_case())
        ) {
            each_obeys(|solve| {
                intervals::the_nearest_root_in_the_interval_is_returned(solve, &asked)
            })?;
        }

        #[test]
        fn returns_no_t_outside_the_interval(
            asked in hostile::with_hostile_interval(hostile::hostile())
        ) {
            each_obeys(|solve| intervals::no_t_outside_the_interval_is_returned(solve, &asked))?;
        }

        /// For an unbounded interval, the nearest root is the nearer one of the two.
        #[test]
        fn obeys_the_laws_of_a_nearer_root(case in strategies::any_case()) {
            each_obeys(|solve| {
                let (least, greatest) = (f64::NEG_INFINITY, f64::INFINITY);
                let nearer = |center, radius, ray: &Ray| solve(center, radius, ray, least, greatest);
                nearer_root::obeys_every_law(&nearer, &case)
            })?;
        }
    }

    fn each_obeys(law: impl Fn(&RangeSolver) -> LawResult) -> TestCaseResult {
        for method in in_double_precision() {
            let solve = |center, radius, ray: &Ray, t_min, t_max| {
                Case::new(center, radius, *ray).put_to(method, t_min, t_max)
            };
            let name = method.name;
            law(&solve).map_err(|broken| TestCaseError::fail(format!("{name}:\n{broken}")))?;
        }
        Ok(())
    }
}

/// All other methods are measured by `half_b`.
#[test]
fn half_b_is_chapter_5_to_the_bit() {
    let chapter_5 = |center, radius, ray: &Ray, t_min, t_max| {
        let hit = Sphere::new(center, radius).hit(ray, t_min, t_max);
        hit.map(|hit| hit.t)
    };
    let asked = strategies::with_interval(strategies::any_case());
    for asked in samples(&asked, CASES) {
        assert_eq!(asked.solve(&half_b), asked.solve(&chapter_5), "{asked}");
    }
}

/// The nearer root is 1/3, which rounds down to the end itself; the farther one is 1.
#[test]
fn double_double_takes_no_farther_root_for_one_that_rounds_to_an_end() {
    let ray = Ray::new(Point3::ZERO, 3.0 * Vec3::X);
    let found = double_double(2.0 * Vec3::X, 1.0, &ray, 1.0 / 3.0, 2.0);
    assert_eq!(found, None);
}

#[test]
fn the_exact_method_is_the_oracle_to_the_last_bit() {
    let asked = hostile::with_hostile_interval(hostile::hostile());
    for asked in samples(&asked, 10_000) {
        let IntervalCase { case, t_min, t_max } = asked;
        let oracle = ExactCase::of(&case);
        let expected = oracle
            .nearest_root_in(t_min, t_max)
            .filter(|_| t_min.next_up() < t_max)
            .map(|root| root.rounded().max(t_min.next_up()).min(t_max.next_down()));
        assert_eq!(asked.solve(&exact), expected, "{asked}");
    }
}

mod the_certified_methods {
    use super::*;

    proptest! {
        #![proptest_config(many())]

        /// `PROPTEST_CASES` says how many cases, and `PROPTEST_RNG_SEED` which.
        #[test]
        fn decide_rightly_and_to_an_ulp_for_every_input(
            asked in hostile::with_hostile_interval(hostile::hostile())
        ) {
            is_certified(&asked)?;
        }

        /// Where no end of the interval is in the way, the proof promises more.
        #[test]
        fn round_to_less_than_eight_tenths_of_an_ulp(case in hostile::hostile()) {
            let asked = IntervalCase { case, t_min: 0.0, t_max: f64::INFINITY };
            if asked.solve(&certified_t).is_some_and(|t| t > f64::from_bits(1)) {
                is_within_ulps(&asked, 0.8)?;
            }
        }
    }

    /// A bound is tight there, and random cases never come there. A filter was wrong in one such
    /// case of a hundred that had answered a hundred million others rightly.
    #[test]
    fn are_right_at_the_edges_of_the_filter_s_bands() {
        at_the_edges(20_000, 11);
    }

    #[test]
    #[ignore = "ten million questions take minutes"]
    fn are_right_at_the_edges_for_ten_million_questions() {
        at_the_edges(10_000_000, 12);
    }

    fn at_the_edges(cases: u32, seed: u64) {
        let rng_seed = RngSeed::Fixed(seed);
        let mut runner = TestRunner::new(ProptestConfig {
            cases,
            rng_seed,
            ..config()
        });
        let result = runner.run(&bands::at_a_band(), |asked| is_certified(&asked));
        result.unwrap_or_else(|failure| panic!("{failure}"));
    }

    /// In which order they are asked, and that each is needed: the narrower a bound, the more
    /// the filter would answer by itself. From 2⁶⁷ radii on the lengths do not fit into the
    /// fixed width.
    #[test]
    fn are_answered_by_the_stage_that_is_meant() {
        let far = |k: f64| strategies::far(k..=k).boxed();
        for (cases, expected) in [
            (strategies::book_rays().boxed(), Stage::Filter),
            (far(4.0), Stage::Filter),
            (far(9.0), Stage::FixedWidth),
            (far(22.0), Stage::Exact),
            (strategies::tangents().boxed(), Stage::FixedWidth),
            (hostile::directions_of(1e30), Stage::Filter),
            (hostile::directions_of(1e-140), Stage::FixedWidth),
            (hostile::directions_of(1e-290), Stage::Exact),
        ] {
            for case in samples(&cases, 500) {
                let stage = stage_of_hit(&question(&case), 0.0, f64::INFINITY);
                assert_eq!(stage, expected, "{case}");
            }
        }
    }

    fn many() -> ProptestConfig {
        let config = config();
        ProptestConfig {
            cases: config.cases.max(12_000),
            ..config
        }
    }
}

/// Both certified methods find a hit exactly if a root lies in the interval, nearer to it
/// than rounding alone explains, and `certified_t` to an ulp.
///
/// One exception is by definition: between two neighbors there is no `f64` to
/// return, so an interval like that is missed.
pub(crate) fn is_certified(asked: &IntervalCase) -> TestCaseResult {
    let IntervalCase { case, t_min, t_max } = *asked;
    let exact = ExactCase::of(&case);
    let has_numbers = t_min.next_up() < t_max;
    let root = exact.nearest_root_in(t_min, t_max).filter(|_| has_numbers);
    for solve in [certified_hit, certified_t] {
        let found = asked.solve(&solve);
        prop_assert_eq!(found.is_some(), root.is_some(), "{:?}", found);
        if let (Some(t), Some(root)) = (found, root) {
            let bound = root_bound(&case, exact.discriminant_margin());
            let right = root.rounded();
            let is_near = (t - right).abs() <= bound || root.error_in_ulps(t) <= 1.0;
            prop_assert!(is_near || !case.is_well_scaled(), "{t:?}, {right:?}");
            prop_assert!(t_min < t && t < t_max, "{t:?}");
        }
    }
    is_within_ulps(asked, 1.0)
}

/// Fails unless `t` is within so many ulps of the nearest root in the interval; a root that no
/// `f64` reaches becomes the largest one.
fn is_within_ulps(asked: &IntervalCase, ulps: f64) -> TestCaseResult {
    let exact = ExactCase::of(&asked.case);
    let root = exact.nearest_root_in(asked.t_min, asked.t_max);
    if let (Some(t), Some(root)) = (asked.solve(&certified_t), root) {
        let is_beyond = root.rounded().is_infinite() && t.abs() == f64::MAX;
        let error = root.error_in_ulps(t);
        prop_assert!(
            error <= ulps || is_beyond,
            "{t:?} is {error:.3} ulps from the root"
        );
    }
    Ok(())
}

pub(crate) fn in_double_precision() -> impl Iterator<Item = &'static Method> {
    let methods = METHODS.iter();
    methods.filter(|method| method.precision() == Precision::Double)
}

pub(crate) fn in_front(case: &Case, method: &Method) -> Option<f64> {
    case.put_to(method, 0.0, f64::INFINITY)
}
