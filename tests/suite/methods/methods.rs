//! The methods of chapter 6: what each one promises, and where it fails.
//!
//! Laws and bounds are those of the chapters. The judge is `laws::oracle`, which
//! shares no line with the method `exact`: each would notice a mistake of the
//! other. Where a method is known to fail, it is asserted to fail.

use std::ops::RangeInclusive;

use common::rtweekend::*;
use hittable_list::{Hittable, Sphere};
use laws::nearer_root::{self, BAND, root_bound};
use laws::oracle::Exact;
use laws::strategies::{self, samples};
use laws::{Case, WithInterval, config, intervals};
use proptest::prelude::*;
use proptest::test_runner::{TestCaseError, TestCaseResult};
use speed_vs_accuracy::{
    Discriminant, METHODS, Method, Precision, Solve, Stage, certified_hit, certified_t, exact,
    half_b, stage_of_hit, stage_of_t,
};

use crate::stability::share;
use crate::{campaign, hostile};

mod every_method {
    use super::*;

    proptest! {
        #![proptest_config(ProptestConfig { cases: 1000, ..config() })]

        /// The bounds are those of `half_b`, the worst of all.
        #[test]
        fn returns_the_nearest_root_in_the_interval(
            asked in strategies::with_interval(strategies::anywhere())
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

        /// On the whole line, the nearest root is the nearer one.
        #[test]
        fn obeys_the_laws_of_a_nearer_root(case in strategies::anywhere()) {
            each_obeys(|solve| {
                let (least, greatest) = (f64::NEG_INFINITY, f64::INFINITY);
                let nearer = |center, radius, ray: &Ray| solve(center, radius, ray, least, greatest);
                nearer_root::obeys_every_law(&nearer, &case)
            })?;
        }
    }

    fn each_obeys(law: impl Fn(&intervals::RangeSolver) -> TestCaseResult) -> TestCaseResult {
        for (name, solve) in in_double_precision() {
            law(&solve).map_err(|broken| TestCaseError::fail(format!("{name}:\n{broken}")))?;
        }
        Ok(())
    }

    #[test]
    fn misses_what_is_no_number() {
        let ray = Ray::new(Point3::ZERO, Vec3::NEG_Z);
        let center = Point3::new(0.0, 0.0, -1.0);
        let nowhere = Ray::new(Point3::ZERO, Vec3::ZERO);
        let lost = Ray::new(Point3::new(f64::NAN, 0.0, 0.0), Vec3::NEG_Z);
        let endless = Ray::new(Point3::ZERO, Vec3::new(0.0, 0.0, f64::NEG_INFINITY));
        for (name, solve) in in_double_precision() {
            for ray in [nowhere, lost, endless] {
                assert_eq!(solve(center, 0.5, &ray, 0.0, f64::INFINITY), None, "{name}");
            }
            assert_eq!(solve(center, f64::NAN, &ray, 0.0, 9.0), None, "{name}");
            assert_eq!(solve(center, 0.5, &ray, f64::NAN, 9.0), None, "{name}");
            assert_eq!(solve(center, 0.5, &ray, 0.0, f64::NAN), None, "{name}");
        }
    }
}

mod every_single_precision_method {
    use super::*;

    /// The same law as in `f64`, with u 2²⁹ times as large: the input is exact,
    /// and so is the oracle.
    #[test]
    fn returns_the_nearest_root_to_the_digits_that_remain() {
        for method in of(Precision::Single) {
            let name = method.name;
            for case in samples(&strategies::anywhere(), CASES) {
                let case = case.rounded(Precision::Single);
                let found = in_front(&case, method);
                if !case.numbers().iter().all(|number| number.is_finite()) {
                    continue;
                }
                let exact = Exact::of(&case);
                let margin = exact.discriminant_margin();
                let fits = |scale: f64| (1e-30..=1e30).contains(&scale);
                if !(fits(case.a()) && fits(case.m()) && margin.abs() > BAND * SINGLE) {
                    continue;
                }
                let bound = SINGLE * root_bound(&case, margin.max(2.0 * BAND));
                let expected = exact.nearest_root_in(0.0, f64::INFINITY);
                let nearer_is_at_the_end = [exact.nearer_root(), exact.farther_root()]
                    .into_iter()
                    .flatten()
                    .any(|root| root.rounded().abs() <= bound);
                match (found, expected) {
                    _ if nearer_is_at_the_end => {}
                    (Some(t), Some(root)) => {
                        assert!((t - root.rounded()).abs() <= bound, "{name}: {t} on {case}");
                    }
                    (found, expected) => {
                        assert_eq!(found.is_some(), expected.is_some(), "{name} on {case}");
                    }
                }
            }
        }
    }

    /// Input of 24 digits, arithmetic of 53: nothing is left to lose in t.
    #[test]
    fn is_right_to_an_ulp_if_it_is_widened() {
        for cases in [
            samples(&strategies::book_rays(), CASES),
            samples(&strategies::far(0.5..=4.0), CASES),
            samples(&strategies::above_the_ground(2.0..=6.0), CASES),
        ] {
            for case in cases {
                let case = case.rounded(Precision::Single);
                let found = in_front(&case, &Method::WIDENED_HALF_B_Q_F32);
                let exact = Exact::of(&case);
                let root = exact.nearest_root_in(0.0, f64::INFINITY);
                assert_eq!(found.is_some(), root.is_some(), "{case}");
                if let (Some(t), Some(root)) = (found, root) {
                    let ulps = root.error_in_ulps(t) / SINGLE;
                    assert!(ulps <= 1.0, "{ulps} ulps on {case}");
                }
            }
        }
    }

    /// Every number is rounded to `f32` first, and the ends of the range too.
    #[test]
    fn is_never_wrong_if_it_is_certified() {
        let asked = hostile::with_hostile_interval(hostile::hostile());
        let mut hits = 0;
        for WithInterval { case, t_min, t_max } in samples(&asked, 2 * CASES) {
            let case = case.rounded(Precision::Single);
            let Some(exact) = Exact::of_finite(&case) else {
                continue;
            };
            let [t_min, t_max] = [t_min, t_max].map(|end| end as f32);
            let found = case.put_to(&Method::CERTIFIED_F32, t_min.into(), t_max.into());
            let root = exact
                .nearest_root_in(t_min.into(), t_max.into())
                .filter(|_| t_min.next_up() < t_max);
            assert_eq!(
                found.is_some(),
                root.is_some(),
                "{t_min:?} {t_max:?} {case}"
            );
            let (Some(t), Some(root)) = (found, root) else {
                continue;
            };
            hits += 1;
            let (t, right) = (t as f32, root.rounded() as f32);
            let inside = right.max(t_min.next_up()).min(t_max.next_down());
            assert!(
                [inside.next_down(), inside, inside.next_up()].contains(&t),
                "{t:?}, not {right:?} on {case}"
            );
        }
        assert!(hits > CASES / 4, "{hits} hits");
    }

    /// 2²⁹: an ulp of an `f32` in ulps of an `f64`.
    const SINGLE: f64 = 536_870_912.0;
}

mod the_exact_method {
    use super::*;

    #[test]
    fn is_the_oracle_to_the_last_bit() {
        let asked = hostile::with_hostile_interval(hostile::hostile());
        for asked in samples(&asked, 10_000) {
            let WithInterval { case, t_min, t_max } = asked;
            let oracle = Exact::of(&case);
            let expected = oracle
                .nearest_root_in(t_min, t_max)
                .filter(|_| t_min.next_up() < t_max)
                .map(|root| root.rounded().max(t_min.next_up()).min(t_max.next_down()));
            assert_eq!(asked.solve(&exact), expected, "{asked}");
        }
    }

    /// The sphere around 0 of radius 1, seen from inside along x: the root is 1/s.
    fn one_over(s: f64, t_min: f64, t_max: f64) -> Option<f64> {
        let ray = Ray::new(Point3::ZERO, Vec3::new(s, 0.0, 0.0));
        exact(Point3::ZERO, 1.0, &ray, t_min, t_max)
    }

    #[test]
    fn gives_the_largest_number_for_a_root_beyond_it() {
        let least = f64::from_bits(1);
        assert_eq!(one_over(least, 0.0, f64::INFINITY), Some(f64::MAX));
        assert_eq!(one_over(least, 0.0, f64::MAX), None);
        assert_eq!(
            one_over(-least, f64::NEG_INFINITY, 0.0),
            Some(f64::MIN),
            "the nearer root of the ray turned round"
        );
    }

    #[test]
    fn gives_way_inwards_where_a_root_rounds_to_an_end() {
        let third = 1.0 / 3.0;
        // 1/3 rounds down, so the root lies above its own rounding.
        assert_eq!(one_over(3.0, 0.0, 1.0), Some(third));
        assert_eq!(one_over(3.0, third, 1.0), Some(third.next_up()));
        assert_eq!(one_over(3.0, 0.0, third), None);
        // Between two neighbors there is a root, and no number for it.
        assert_eq!(one_over(3.0, third, third.next_up()), None);
    }

    /// A point at 1 or the next number, seen from half an ulp behind 0.
    #[test]
    fn rounds_half_way_to_the_even_number() {
        let half = f64::EPSILON / 2.0;
        let ray = Ray::new(Point3::new(-half, 0.0, 0.0), Vec3::X);
        for (center, even) in [(1.0, 1.0), (1.0 + 2.0 * half, 1.0 + 4.0 * half)] {
            let center = Point3::new(center, 0.0, 0.0);
            assert_eq!(exact(center, 0.0, &ray, 0.0, 2.0), Some(even));
        }
    }

    #[test]
    fn leaves_out_both_ends() {
        assert_eq!(one_over(1.0, 0.0, 2.0), Some(1.0));
        assert_eq!(one_over(1.0, 1.0, 2.0), None);
        assert_eq!(one_over(1.0, 0.0, 1.0), None);
    }
}

mod the_certified_methods {
    use super::*;

    /// A short part of the campaign that the book describes: `CERTIFIED_CASES`
    /// says how many cases, shared by all processors, and `CERTIFIED_SEED` which.
    #[test]
    fn decide_rightly_and_to_an_ulp_for_every_input() {
        let asked = || hostile::with_hostile_interval(hostile::hostile()).boxed();
        let (cases, stages) = campaign::run("CERTIFIED", asked, stages_that_answer);
        let (hit, t) = stages.split_at(STAGES);
        println!("by filter, rescaled, sharper, fixed width, exact: {hit:?}, {t:?}");
        // A stage that is never asked is never tried.
        let often_enough = |&count: &u64| count > cases / 500;
        assert!(stages.iter().all(often_enough), "{stages:?}");
    }

    /// Tries both methods, and counts the stages that answer: first those of
    /// `certified_hit`, then those of `certified_t`.
    fn stages_that_answer(asked: WithInterval) -> Result<[u64; 2 * STAGES], TestCaseError> {
        is_certified(&asked)?;
        let Case {
            center,
            radius,
            ray,
        } = asked.case;
        let (t_min, t_max) = (asked.t_min, asked.t_max);
        let mut stages = [0; 2 * STAGES];
        stages[stage_of_hit(center, radius, &ray, t_min, t_max) as usize] = 1;
        stages[STAGES + stage_of_t(center, radius, &ray, t_min, t_max) as usize] = 1;
        Ok(stages)
    }

    /// Where no end of the interval is in the way, the proof promises more.
    #[test]
    fn round_to_less_than_eight_tenths_of_an_ulp() {
        for case in samples(&hostile::hostile(), CASES) {
            let asked = WithInterval {
                case,
                t_min: 0.0,
                t_max: f64::INFINITY,
            };
            if asked
                .solve(&certified_t)
                .is_some_and(|t| t > f64::from_bits(1))
            {
                is_within_ulps(&asked, 0.8)
                    .unwrap_or_else(|failure| panic!("{failure}\n\n{asked}"));
            }
        }
    }

    #[test]
    fn are_answered_by_the_filter_for_a_ray_of_the_book() {
        for case in samples(&strategies::book_rays(), CASES) {
            assert_eq!(stages(&case).0, Stage::Filter, "{case}");
        }
    }

    /// The narrower a bound of the filter, the more it would answer by itself.
    /// Here it must not.
    #[test]
    fn ask_the_sharper_stage_where_rounding_could_decide() {
        let cases = samples(&strategies::far(9.0..=11.0), 500);
        let by = |stage| share(&cases, |case| stages(case).0 == stage);
        assert_eq!(by(Stage::Filter), 0.0);
        // A ray of a thousand passes so near a tangent that it is left to integers.
        assert!(by(Stage::Sharper) > 0.99, "{}", by(Stage::Sharper));
    }

    #[test]
    fn ask_for_integers_at_a_tangent() {
        for case in samples(&strategies::tangents(), 500) {
            let fixed_width = (Stage::FixedWidth, Stage::FixedWidth);
            assert_eq!(stages(&case), fixed_width, "{case}");
        }
    }

    /// At 10¹⁷ radii all of the sphere is less than a rounding, and from 2⁶⁷ on
    /// the lengths do not fit into the fixed width.
    #[test]
    fn ask_for_integers_where_rounding_is_larger_than_the_sphere() {
        for case in samples(&strategies::far(17.0..=17.0), 500) {
            assert!(stages(&case).0 >= Stage::FixedWidth, "{case}");
        }
        for case in samples(&strategies::far(22.0..=22.0), 500) {
            assert_eq!(stages(&case).0, Stage::Exact, "{case}");
        }
    }

    #[test]
    fn change_the_units_at_extreme_exponents() {
        for length in [1e-290, 1e-140, 1e140, 1e290] {
            let case = ahead(0.5, length);
            assert_eq!(stages(&case), (Stage::Rescaled, Stage::Rescaled), "{case}");
        }
    }

    /// A sphere at a distance of 1 along a ray whose direction has this length.
    fn ahead(radius: f64, length: f64) -> Case {
        Case {
            center: Point3::new(0.0, 0.0, -1.0),
            radius,
            ray: Ray::new(Point3::ZERO, Vec3::new(0.0, 0.0, -length)),
        }
    }

    /// A ray from afar has digits to decide long after it has none for t.
    #[test]
    fn need_more_digits_for_t_than_for_a_decision() {
        for case in samples(&strategies::far(4.0..=4.0), 500) {
            let (hit, t) = stages(&case);
            assert!(hit <= t, "{case}");
            if in_front(&case, &Method::CERTIFIED_HIT).is_some() {
                assert_eq!((hit, t), (Stage::Filter, Stage::FixedWidth), "{case}");
            }
        }
    }

    const STAGES: usize = Stage::Exact as usize + 1;

    fn stages(case: &Case) -> (Stage, Stage) {
        let Case {
            center,
            radius,
            ray,
        } = *case;
        let ask = |stage: fn(Point3, f64, &Ray, f64, f64) -> Stage| {
            stage(center, radius, &ray, 0.0, f64::INFINITY)
        };
        (ask(stage_of_hit), ask(stage_of_t))
    }
}

/// Each method on rays of one kind, and how often it decides wrongly or how many ulps it is
/// off: the thresholds, from both sides. Those of `half_b` are those of the chapters.
mod thresholds {
    use super::*;

    #[test]
    fn of_wrong_decisions_are_where_the_rows_say() {
        let far = |k: f64| samples(&strategies::far(k..=k), CASES);
        let [plain, double_double] = [Method::HALF_B_Q, Method::DOUBLE_DOUBLE].map(|it| vec![it]);
        let distance: Vec<Method> = by(Discriminant::Distance).copied().collect();
        let certain: Vec<Method> = by(Discriminant::Certain).copied().collect();
        let widened = vec![Method::WIDENED_HALF_B_Q_F32];
        let single = of(Precision::Single).copied().collect();
        // A scattered ray starts on the surface up to a rounding. Whether it meets the
        // sphere again is a matter of the sign of c, which is that rounding.
        let leaving = || samples(&hostile::leaving_the_surface(3.0..=3.0), CASES);
        let few_digits_of_c = vec![Method::HALF_B_Q, Method::CROSS_Q];
        let all_digits_of_c = vec![Method::ADAPTIVE_Q, Method::DOUBLE_DOUBLE];
        let rows = [
            (plain.clone(), far(5.0), 0.0..=0.001),
            (plain.clone(), far(7.0), 0.001..=0.05),
            (plain, far(9.0), 0.25..=0.6),
            (distance.clone(), far(11.0), 0.0..=0.0),
            (distance, far(15.0), 0.01..=0.06),
            (double_double.clone(), far(11.0), 0.0..=0.0),
            (double_double, far(15.0), 0.001..=0.03),
            (certain.clone(), far(15.0), 0.0..=0.0),
            // Single precision is lost at the square root of the distance.
            (vec![Method::HALF_B_F32], far(3.0), 0.02..=0.1),
            (widened.clone(), far(4.0), 0.0..=0.0),
            (widened, far(8.0), 0.01..=0.6),
            (few_digits_of_c, leaving(), 0.1..=0.35),
            (all_digits_of_c, leaving(), 0.0..=0.0),
            (certain, leaving(), 0.0..=0.0),
            // It is enough for the book.
            (
                single,
                samples(&strategies::book_rays(), 10 * CASES),
                0.0..=1e-4,
            ),
        ];
        for (row, (methods, cases, share)) in rows.iter().enumerate() {
            for method in methods {
                assert_within(share, wrong(*method, cases), row, method);
            }
        }
    }

    /// A huge ground costs digits unless c has them all.
    #[test]
    fn of_lost_digits_are_where_the_rows_say() {
        let ground = samples(&strategies::above_the_ground(6.0..=6.0), CASES);
        let rows = [
            (Method::HALF_B_Q, 1e2..=1e7),
            (Method::CROSS_Q, 1e2..=1e7),
            (Method::ADAPTIVE_Q, 0.0..=2.0),
            (Method::DOUBLE_DOUBLE, 0.0..=2.0),
            (Method::CERTIFIED_T, 0.0..=2.0),
        ];
        for (row, (method, ulps)) in rows.iter().enumerate() {
            assert_within(ulps, percentile(*method, &ground, 0.5), row, method);
        }
    }

    fn assert_within(range: &RangeInclusive<f64>, found: f64, row: usize, method: &Method) {
        let name = method.name;
        assert!(
            range.contains(&found),
            "row {row}: {found} for {name}, not {range:?}: if it is better, say so there"
        );
    }
}

mod exponents {
    use super::*;

    /// At a length of 1e±160 the plain squares overflow, or leave nothing.
    #[test]
    fn run_out_for_all_that_do_not_scale() {
        for length in [1e-165, 1e160] {
            let case = Case {
                center: Point3::new(0.0, 0.0, -1.0),
                radius: 0.5,
                ray: Ray::new(Point3::ZERO, Vec3::new(0.0, 0.0, -length)),
            };
            for method in of(Precision::Double) {
                let name = method.name;
                let found = in_front(&case, method);
                let is_right = found.is_some_and(|t| (t * length - 0.5).abs() < 1e-15);
                assert_eq!(
                    is_right, method.any_exponent,
                    "{name} at a length of {length}"
                );
            }
        }
    }
}

/// What one would not expect, and what the charts therefore show.
mod surprises {
    use super::*;

    /// By which all others are measured.
    #[test]
    fn half_b_is_chapter_5_to_the_bit() {
        let chapter_5 = |center, radius, ray: &Ray, t_min, t_max| {
            let hit = Sphere::new(center, radius).hit(ray, t_min, t_max);
            hit.map(|hit| hit.t)
        };
        let asked = strategies::with_interval(strategies::anywhere());
        for asked in samples(&asked, CASES) {
            assert_eq!(asked.solve(&half_b), asked.solve(&chapter_5), "{asked}");
        }
    }

    /// The book's ground is so large that r² is exact and |d × oc|² is not small:
    /// the discriminant that is made for far spheres is the worse one here.
    #[test]
    fn the_stable_discriminant_is_worse_on_the_ground_of_the_book() {
        let ground = book_ground();
        let [plain, cross] =
            [Method::HALF_B_Q, Method::CROSS_Q].map(|method| percentile(method, &ground, 0.999));
        assert!((1.0..=20.0).contains(&plain), "{plain}");
        assert!((20.0 * plain..=1e4).contains(&cross), "{cross}");
    }

    fn book_ground() -> Vec<Case> {
        samples(&strategies::book_rays(), 4 * CASES)
            .into_iter()
            .filter(|case| case.radius == 100.0)
            .collect()
    }
}

const CASES: u32 = 4000;

/// Both certified methods find a hit exactly if a root lies in the interval, nearer to it
/// than rounding alone explains, and `certified_t` to an ulp.
///
/// One exception is by definition: between two neighbors there is no `f64` to
/// return, so an interval like that is missed.
pub(crate) fn is_certified(asked: &WithInterval) -> TestCaseResult {
    let WithInterval { case, t_min, t_max } = *asked;
    let exact = Exact::of(&case);
    let has_numbers = t_min.next_up() < t_max;
    let root = exact.nearest_root_in(t_min, t_max).filter(|_| has_numbers);
    for solve in [certified_hit, certified_t] {
        let found = asked.solve(&solve);
        prop_assert_eq!(found.is_some(), root.is_some(), "{:?}", found);
        if let (Some(t), Some(root)) = (found, root) {
            let bound = root_bound(&case, exact.discriminant_margin());
            let is_near = (t - root.rounded()).abs() <= bound || root.error_in_ulps(t) <= 1.0;
            prop_assert!(
                is_near || !case.is_well_scaled(),
                "{t:?}, {:?}",
                root.rounded()
            );
            prop_assert!(t_min < t && t < t_max, "{t:?}");
        }
    }
    is_within_ulps(asked, 1.0)
}

/// `t` is within so many ulps of the nearest root in the interval; a root that no `f64`
/// reaches becomes the largest one.
fn is_within_ulps(asked: &WithInterval, ulps: f64) -> TestCaseResult {
    let exact = Exact::of(&asked.case);
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

type RangeFn = fn(Point3, f64, &Ray, f64, f64) -> Option<f64>;

fn in_double_precision() -> impl Iterator<Item = (&'static str, RangeFn)> {
    METHODS.iter().filter_map(|method| match method.solve {
        Solve::Double(solve) => Some((method.name, solve)),
        Solve::Single(_) => None,
    })
}

fn of(precision: Precision) -> impl Iterator<Item = &'static Method> {
    let all = METHODS.iter();
    all.filter(move |method| method.precision() == precision)
}

fn by(discriminant: Discriminant) -> impl Iterator<Item = &'static Method> {
    of(Precision::Double).filter(move |method| method.discriminant == discriminant)
}

fn in_front(case: &Case, method: &Method) -> Option<f64> {
    case.put_to(method, 0.0, f64::INFINITY)
}

/// The share of hits that should be misses, or the reverse, in front of the ray.
/// Right is what is right for the numbers that the method is given.
fn wrong(method: Method, cases: &[Case]) -> f64 {
    share(cases, |case| {
        let given = case.rounded(method.precision());
        in_front(case, &method).is_some() != is_hit(&given)
    })
}

fn is_hit(case: &Case) -> bool {
    let exact = Exact::of(case);
    exact.nearest_root_in(0.0, f64::INFINITY).is_some()
}

/// The error in ulps that this share of the hits in front does not exceed.
fn percentile(method: Method, cases: &[Case], share: f64) -> f64 {
    let mut errors: Vec<f64> = cases
        .iter()
        .filter_map(|case| {
            let exact = Exact::of(case);
            let root = exact.nearest_root_in(0.0, f64::INFINITY)?;
            Some(root.error_in_ulps(in_front(case, &method)?))
        })
        .collect();
    errors.sort_by(f64::total_cmp);
    errors[((errors.len() - 1) as f64 * share) as usize]
}
