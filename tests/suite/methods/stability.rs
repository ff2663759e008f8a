//! Where the quadratic stops working, and that it works until there.
//!
//! Each test asserts both sides of a threshold: an improvement is noticed as
//! surely as a regression. The function is chapter 4's, to whose last bit those of chapters
//! 3 and 5 agree. Errors are in
//! ulps of the exact root, from the oracle; u = 2⁻⁵³, M = |oc|² + r², and a
//! decision is in danger where |D| is not above 24u·a·M (see `laws::nearer_root`).

use common::rtweekend::*;
use hittable_list::{Hittable, Sphere};
use laws::Case;
use laws::nearer_root::Solver;
use laws::oracle::Exact;
use laws::strategies::{self, samples};
use measure::spread::Spread;
use proptest::strategy::Strategy;

mod a_far_sphere {
    use super::*;

    /// At 10ᵏ radii D/(a·M) is (1 − m²)·10⁻²ᵏ for a line that passes the center at m radii.
    /// The band of 3e-15 is far below that at k = 5: it holds the lines within 1.3e-5 of
    /// m = 1, one in 50,000.
    #[test]
    fn is_hit_or_missed_rightly_from_a_hundred_thousand_radii() {
        let wrong = survey(&strategies::far(5.0..=5.0)).wrong_decisions;
        assert_between(0.0, wrong, 0.001);
    }

    /// At k = 7 the band reaches the rays that come within 10 % of the rim.
    #[test]
    fn is_sometimes_decided_wrongly_from_ten_million_radii() {
        let wrong = survey(&strategies::far(7.0..=7.0)).wrong_decisions;
        assert_between(0.001, wrong, 0.05);
    }

    /// At k = 9 all of the sphere is inside the band: r² is less than one
    /// rounding of oc·oc, and nothing is left of it in c.
    #[test]
    fn is_decided_by_rounding_alone_from_a_billion_radii() {
        let wrong = survey(&strategies::far(9.0..=9.0)).wrong_decisions;
        assert_between(0.25, wrong, 0.55);
    }

    /// The error of √D is u·a·M/√D, and t is about |oc|: each power of ten in
    /// distance costs one digit, not two.
    #[test]
    fn loses_one_digit_with_each_power_of_ten() {
        let [near, far] = [2.0, 5.0].map(|k| survey(&strategies::far(k..=k)).median_ulps);
        assert_between(10.0, near, 200.0);
        assert_between(500.0, far / near, 2000.0);
    }
}

mod a_grazing_ray {
    use super::*;

    /// From 3 radii away D/(a·M) is 2·10⁻ᵏ/10. The least of the spheres, 0.01 large and 16
    /// from the origin, takes up to 5e-13 of that k away by the rounding of its center:
    /// at k = 12 enough is left for every one, and thirty times the band.
    #[test]
    fn is_decided_rightly_at_one_part_in_a_trillion() {
        assert_eq!(
            survey(&strategies::grazing(12.0..=12.0)).wrong_decisions,
            0.0
        );
    }

    /// At k = 15 it is 2e-16, one or two roundings.
    #[test]
    fn is_often_decided_wrongly_at_one_part_in_a_quadrillion() {
        let wrong = survey(&strategies::grazing(15.0..=15.0)).wrong_decisions;
        assert_between(0.05, wrong, 0.2);
    }

    /// √D shrinks as 10^(−k/2) while the error of D stays: six powers of ten
    /// cost three digits. In the limit half of the digits are lost.
    #[test]
    fn loses_half_a_digit_with_each_power_of_ten() {
        let [clear, close] = [6.0, 12.0].map(|k| survey(&strategies::grazing(k..=k)).median_ulps);
        assert_between(200.0, clear, 3000.0);
        assert_between(500.0, close / clear, 2000.0);
    }
}

mod an_origin_near_the_surface {
    use super::*;

    /// c = oc·oc − r² has an absolute error of 6u·M, and the root near the
    /// origin is about c/2h. At a distance of 10⁻ᵏ radii, k digits are lost.
    #[test]
    fn loses_a_digit_with_each_power_of_ten_that_it_is_nearer() {
        let [off, on] = [4.0, 10.0].map(|k| {
            let cases = strategies::near_the_surface(k..=k);
            survey(&cases.prop_map(towards_the_center)).median_ulps
        });
        assert_between(500.0, off, 10_000.0);
        assert_between(5e5, on / off, 2e6);
    }

    /// The decision does not suffer: D is as large as ever. Only with a range
    /// of t does the lost sign of c matter, because it is that of the root.
    #[test]
    fn is_no_danger_to_the_decision_without_a_range() {
        assert_eq!(
            survey(&strategies::near_the_surface(15.0..=15.0)).wrong_decisions,
            0.0
        );
    }

    /// A reflected ray starts where the last one ended, on the surface up to a
    /// rounding. Here c/M is one rounding as well, so chapter 5 may find the
    /// very surface that the ray leaves: specks of shadow, known as acne.
    #[test]
    fn makes_chapter_5_hit_the_surface_that_a_ray_leaves() {
        let share_of_wrong_hits = |k: f64| {
            let cases = samples(&strategies::near_the_surface(k..=k), CASES);
            share(&cases, |case| {
                let found = sphere(case).hit(&case.ray, 0.0, f64::INFINITY).is_some();
                found
                    != Exact::of(case)
                        .nearest_root_in(0.0, f64::INFINITY)
                        .is_some()
            })
        };
        assert_eq!(share_of_wrong_hits(12.0), 0.0);
        assert_between(0.01, share_of_wrong_hits(16.0), 0.2);
    }
}

mod a_huge_sphere {
    use super::*;

    /// The book's ground is 100 large: most roots keep all but a digit.
    #[test]
    fn of_radius_100_costs_one_digit() {
        let book = seen_from_above(2.0);
        assert_eq!(book.wrong_decisions, 0.0);
        assert_between(1.0, book.median_ulps, 20.0);
    }

    /// The eye is about 1 above the surface, so c/M is 1/R: as near the
    /// surface, each power of ten costs a digit of the near root.
    #[test]
    fn of_radius_a_billion_costs_seven_digits_more() {
        let [book, huge] = [2.0, 9.0].map(seen_from_above);
        assert_eq!(huge.wrong_decisions, 0.0);
        assert_between(2e6, huge.median_ulps / book.median_ulps, 2e7);
    }

    fn seen_from_above(k: f64) -> Survey {
        let cases = strategies::above_the_ground(k..=k);
        survey(&cases.prop_map(towards_the_center))
    }
}

/// Turned round if it looks away: of the two roots the nearer is then the one near the
/// origin, where h − √D cancels.
fn towards_the_center(case: Case) -> Case {
    if case.h() < 0.0 {
        case.turned_round()
    } else {
        case
    }
}

/// The book's ray through the middle, d = (0, 0, −s): a = s², h = s, c = ¾, and
/// the nearer root is ½/s. With s a power of two nothing rounds, until an
/// exponent runs out.
mod the_length_of_the_direction {
    use super::*;

    fn full(s: f64) -> Option<f64> {
        normals::hit_sphere(CENTER, 0.5, &ray(s))
    }

    fn half(s: f64) -> Option<f64> {
        half_b_sphere::hit_sphere(CENTER, 0.5, &ray(s))
    }

    fn range(s: f64) -> Option<f64> {
        let sphere = Sphere::new(CENTER, 0.5);
        sphere.hit(&ray(s), 0.0, f64::INFINITY).map(|hit| hit.t)
    }

    const CENTER: Point3 = Point3::new(0.0, 0.0, -1.0);

    fn ray(s: f64) -> Ray {
        Ray::new(Point3::ZERO, Vec3::new(0.0, 0.0, -s))
    }

    fn two_to(exponent: i32) -> f64 {
        f64::exp2(f64::from(exponent))
    }

    #[test]
    fn does_not_matter_from_two_to_minus_511_to_two_to_510() {
        for exponent in [-511, -300, -1, 0, 1, 300, 510] {
            let s = two_to(exponent);
            for hit in [full, half, range] {
                assert_eq!(hit(s), Some(0.5 / s), "for a length of 2^{exponent}");
            }
        }
    }

    /// b² and 4ac are four times h² and ac, so they overflow a factor of 2 in
    /// length before these do: the full formula has infinity less infinity.
    /// This is the one way in which half-b is better.
    #[test]
    fn overflows_the_full_formula_first() {
        let s = two_to(511);
        assert!(full(s).is_some_and(f64::is_nan));
        assert_eq!(half(s), Some(0.5 / s));
        assert_eq!(range(s), Some(0.5 / s));
    }

    /// From 2^512 on a and h² are infinite, and infinity less infinity is NaN.
    /// In chapter 5 NaN lies in no range: the sphere is gone.
    #[test]
    fn of_two_to_512_is_too_much_for_all() {
        let s = two_to(512);
        assert!(full(s).is_some_and(f64::is_nan));
        assert!(half(s).is_some_and(f64::is_nan));
        assert_eq!(range(s), None);
    }

    /// Below 2⁻¹⁰²² there are fewer digits the smaller a number is, and h² is smaller
    /// than b²: where the last digit of one is lost, the other may have it still.
    #[test]
    fn about_two_to_minus_515_tells_the_two_formulas_apart() {
        let scale = two_to(-515);
        let hits = samples(&strategies::anywhere(), 4000).into_iter();
        let hits =
            hits.map(|case| case.with_ray(case.ray.origin, scale * case.ray.direction.normalize()));
        let answers = hits.map(|case| {
            let ask = |solve: fn(Point3, f64, &Ray) -> Option<f64>| {
                solve(case.center, case.radius, &case.ray)
            };
            (ask(::normals::hit_sphere), ask(::half_b_sphere::hit_sphere))
        });
        let both: Vec<(f64, f64)> = answers.filter_map(|(full, half)| full.zip(half)).collect();
        let differ = both.iter().filter(|(full, half)| full != half).count();
        let of = both.len();
        assert!(4 * differ > of, "{differ} of {of}");
    }

    /// At s = 2⁻⁵³⁷ a is 2⁻¹⁰⁷⁴, the least number above zero, and a·c = ¾a
    /// rounds to a: D is 0, and the sphere is touched at its center.
    #[test]
    fn leaves_no_digit_of_the_discriminant_where_a_underflows() {
        let s = two_to(-537);
        assert_eq!(half(s), Some(1.0 / s));
        assert_eq!(range(s), Some(1.0 / s));
    }

    /// One step further a is 0. In half-b D is 0 as well, and h/0 is infinity; in
    /// the full formula b² is still above zero, and leaves 0/0.
    #[test]
    fn of_two_to_minus_538_is_nothing() {
        let s = two_to(-538);
        assert!(full(s).is_some_and(f64::is_nan));
        assert_eq!(half(s), Some(f64::INFINITY));
        assert_eq!(range(s), None);
    }
}

/// Triangles with whole sides: the line touches, and no operation rounds.
mod a_sphere_an_ulp_too_small {
    use super::*;

    /// The exact answer is a miss. But r² less one ulp of r is lost in c as soon
    /// as oc·oc is a few times as large, and then D is 0 as for a tangent.
    #[test]
    fn is_still_hit_when_the_ray_comes_from_afar() {
        let tangents = samples(&strategies::tangents(), CASES);
        let too_small: Vec<Case> = tangents
            .into_iter()
            .map(|case| Case {
                radius: case.radius.next_down(),
                ..case
            })
            .collect();
        assert!(
            too_small
                .iter()
                .all(|case| Exact::of(case).discriminant().is_lt())
        );
        let hit = share(&too_small, |case| case.solve(SOLVE).is_some());
        assert_between(0.1, hit, 0.9);
    }
}

const CASES: u32 = 4000;

const SOLVE: &Solver = &half_b_sphere::hit_sphere;

/// How well it does on a family of cases.
struct Survey {
    /// The share of cases with a hit that should be a miss, or the reverse.
    wrong_decisions: f64,
    /// The median error where there is a root and it was found.
    median_ulps: f64,
}

fn survey(strategy: &impl Strategy<Value = Case>) -> Survey {
    let cases = samples(strategy, CASES);
    let error = |case: &Case| {
        let exact = Exact::of(case);
        Some(exact.nearer_root()?.error_in_ulps(case.solve(SOLVE)?))
    };
    let is_wrong =
        |case: &Case| case.solve(SOLVE).is_some() != Exact::of(case).nearer_root().is_some();
    Survey {
        wrong_decisions: share(&cases, is_wrong),
        median_ulps: Spread::of(cases.iter().filter_map(error).collect()).median,
    }
}

/// The share of the cases that count.
pub(crate) fn share(cases: &[Case], is_counted: impl Fn(&Case) -> bool) -> f64 {
    cases.iter().filter(|case| is_counted(case)).count() as f64 / cases.len() as f64
}

fn sphere(case: &Case) -> Sphere {
    Sphere::new(case.center, case.radius)
}

fn assert_between(low: f64, value: f64, high: f64) {
    assert!(
        value >= low,
        "{value} is less than {low}: has the method become better? Say so here"
    );
    assert!(
        value <= high,
        "{value} is more than {high}: the method has become worse"
    );
}
