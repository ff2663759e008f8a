//! Where the quadratic stops working, and that it works until there: a table of methods, of
//! rays of one kind, and of how often they are decided wrongly or how many ulps t is off.
//!
//! Each row asserts both sides of a threshold: an improvement is noticed as surely as a
//! regression. `half_b` is chapter 5 to the last bit. Errors are in ulps of the exact root,
//! from the oracle; u = 2⁻⁵³, M = |oc|² + r², and a decision is in danger where |D| is not
//! above 24u·a·M.

use std::ops::RangeInclusive;

use common::rtweekend::*;
use hittable_list::{Hittable, Sphere};
use laws::Case;
use laws::oracle::Exact;
use laws::strategies::{self, samples};
use proptest::prelude::*;
use speed_vs_accuracy::Method;

use crate::hostile;
use crate::methods::in_front;

const CASES: u32 = 4000;

/// A kind of ray, at its level k.
type Rays = fn(f64) -> BoxedStrategy<Case>;

const BOOK: Rays = |_| strategies::book_rays().boxed();
const FAR: Rays = |k| strategies::far(k..=k).boxed();
const GRAZING: Rays = |k| strategies::grazing(k..=k).boxed();
const LEAVING: Rays = |k| hostile::leaving_the_surface(k..=k).boxed();
const NEAR: Rays = |k| strategies::near_the_surface(k..=k).boxed();

/// The nearer root is then the one near the origin, where h − √D cancels.
const TOWARDS_NEAR: Rays = |k| NEAR(k).prop_map(towards_the_center).boxed();
const TOWARDS_GROUND: Rays = |k| {
    let above = strategies::above_the_ground(k..=k);
    above.prop_map(towards_the_center).boxed()
};

fn towards_the_center(case: Case) -> Case {
    if case.h() < 0.0 {
        case.turned_round()
    } else {
        case
    }
}

/// Whole-number tangents whose radius is an ulp too small: all are misses.
const BESIDE_TANGENTS: Rays = |_| {
    let smaller = |case: Case| Case {
        radius: case.radius.next_down(),
        ..case
    };
    strategies::tangents().prop_map(smaller).boxed()
};

const PLAIN: &[Method] = &[Method::HALF_B, Method::HALF_B_Q];
const DISTANCE: &[Method] = &[Method::CROSS_Q, Method::ADAPTIVE_Q];
const FEW_DIGITS_OF_C: &[Method] = &[Method::HALF_B_Q, Method::CROSS_Q];
const DIGITS_OF_C: &[Method] = &[Method::ADAPTIVE_Q, Method::DOUBLE_DOUBLE];
const DOUBLE_DOUBLE: &[Method] = &[Method::DOUBLE_DOUBLE];
const CERTAIN: &[Method] = &[Method::CERTIFIED_HIT, Method::CERTIFIED_T, Method::EXACT];
const WIDENED: &[Method] = &[Method::WIDENED_HALF_B_Q_F32];
const SINGLE: &[Method] = &[
    Method::HALF_B_F32,
    Method::WIDENED_HALF_B_Q_F32,
    Method::CERTIFIED_F32,
];

type Row = (&'static [Method], Rays, f64, RangeInclusive<f64>);

#[test]
fn each_method_decides_wrongly_as_often_as_its_row_says() {
    let rows: [Row; 21] = [
        // At 10ᵏ radii D/(a·M) is (1 − m²)·10⁻²ᵏ for a line that passes the center at m radii.
        // At k = 7 the band of 3e-15 reaches the rays that come within 10 % of the rim; at
        // k = 9 r² is less than one rounding of oc·oc, and nothing is left of it in c.
        (PLAIN, FAR, 5.0, 0.0..=0.001),
        (PLAIN, FAR, 7.0, 0.001..=0.05),
        (PLAIN, FAR, 9.0, 0.25..=0.6),
        (DISTANCE, FAR, 11.0, 0.0..=0.0),
        (DISTANCE, FAR, 15.0, 0.01..=0.06),
        (DOUBLE_DOUBLE, FAR, 11.0, 0.0..=0.0),
        (DOUBLE_DOUBLE, FAR, 15.0, 0.001..=0.03),
        (CERTAIN, FAR, 15.0, 0.0..=0.0),
        // Single precision is lost at the square root of the distance.
        (&[Method::HALF_B_F32], FAR, 3.0, 0.02..=0.1),
        (WIDENED, FAR, 4.0, 0.0..=0.0),
        (WIDENED, FAR, 8.0, 0.01..=0.6),
        // From 3 radii away D/(a·M) is 2·10⁻ᵏ/10: at k = 12 thirty times the band, and at
        // k = 15 one or two roundings.
        (PLAIN, GRAZING, 12.0, 0.0..=0.0),
        (PLAIN, GRAZING, 15.0, 0.05..=0.2),
        (CERTAIN, GRAZING, 15.0, 0.0..=0.0),
        // Nothing of the radius that was taken away is left in c.
        (PLAIN, BESIDE_TANGENTS, 0.0, 0.1..=0.9),
        (CERTAIN, BESIDE_TANGENTS, 0.0, 0.0..=0.0),
        // A scattered ray starts on the surface up to a rounding. Whether it meets the
        // sphere again is a matter of the sign of c, which is that rounding: shadow acne.
        (FEW_DIGITS_OF_C, LEAVING, 3.0, 0.1..=0.35),
        (PLAIN, NEAR, 12.0, 0.0..=0.0),
        (DIGITS_OF_C, LEAVING, 3.0, 0.0..=0.0),
        (CERTAIN, LEAVING, 3.0, 0.0..=0.0),
        // It is enough for the book.
        (SINGLE, BOOK, 0.0, 0.0..=2e-4),
    ];
    assert_rows(&rows, |method, cases| {
        share(cases, |case| {
            let given = case.rounded(method.precision());
            let root = Exact::of(&given);
            let is_hit = root.nearest_root_in(0.0, f64::INFINITY).is_some();
            in_front(&given, method).is_some() != is_hit
        })
    });
}

#[test]
fn half_of_the_roots_of_each_method_are_off_by_as_many_ulps_as_its_row_says() {
    let rows: [Row; 15] = [
        // The error of √D is u·a·M/√D, and t is about |oc|: each power of ten in distance
        // costs one digit, not two.
        (PLAIN, FAR, 2.0, 10.0..=200.0),
        (PLAIN, FAR, 5.0, 1e4..=2e5),
        (DISTANCE, FAR, 5.0, 0.0..=2.0),
        (WIDENED, FAR, 4.0, 0.0..=0.3),
        // √D shrinks as 10^(−k/2) while the error of D stays: six powers of ten cost three
        // digits.
        (PLAIN, GRAZING, 6.0, 200.0..=3000.0),
        (PLAIN, GRAZING, 12.0, 2e5..=3e6),
        // c has an absolute error of 6u·M, and the root near the origin is about c/2h. At a
        // distance of 10⁻ᵏ radii, k digits are lost.
        (PLAIN, TOWARDS_NEAR, 4.0, 500.0..=1e4),
        (PLAIN, TOWARDS_NEAR, 10.0, 5e8..=1e10),
        (DIGITS_OF_C, TOWARDS_NEAR, 10.0, 0.0..=2.0),
        // The eye is about 1 above a ground of 10ᵏ: c/M is 1/R, and the book's ground costs
        // one digit.
        (&[Method::HALF_B], TOWARDS_GROUND, 2.0, 1.0..=20.0),
        (FEW_DIGITS_OF_C, TOWARDS_GROUND, 6.0, 1e2..=1e7),
        (&[Method::HALF_B], TOWARDS_GROUND, 9.0, 1e7..=2e8),
        (DIGITS_OF_C, TOWARDS_GROUND, 6.0, 0.0..=2.0),
        (&[Method::CERTIFIED_T], TOWARDS_GROUND, 6.0, 0.0..=0.5),
        (&[Method::CERTIFIED_T], FAR, 8.0, 0.0..=0.5),
    ];
    assert_rows(&rows, |method, cases| percentile(method, cases, 0.5));
}

/// The book's ground is so large that r² is exact and |d × oc|² is not small: the
/// discriminant that is made for far spheres is the worse one here.
#[test]
fn the_stable_discriminant_is_worse_on_the_ground_of_the_book() {
    let mut ground = samples(&strategies::book_rays(), 4 * CASES);
    ground.retain(|case| case.radius == 100.0);
    let plain = percentile(&Method::HALF_B_Q, &ground, 0.999);
    let cross = percentile(&Method::CROSS_Q, &ground, 0.999);
    assert!((1.0..=20.0).contains(&plain), "{plain}");
    assert!((20.0 * plain..=1e4).contains(&cross), "{cross}");
}

/// The book's ray through the middle, d = (0, 0, −s): a = s², h = s, c = ¾, and the nearer
/// root is ½/s. With s a power of two nothing rounds, until an exponent runs out: in the
/// full formula of chapter 3 a factor of 2 in length before it does in chapters 4 and 5.
/// There infinity less infinity is NaN, which lies in no range.
#[test]
fn the_length_of_the_direction_matters_where_exponents_run_out() {
    let rows = [
        (-538, ["NaN", "infinite", "a miss"]),
        (-537, ["right", "wrong", "wrong"]),
        (-511, ["right"; 3]),
        (-300, ["right"; 3]),
        (0, ["right"; 3]),
        (510, ["right"; 3]),
        (511, ["NaN", "right", "right"]),
        (512, ["NaN", "NaN", "a miss"]),
    ];
    for (exponent, expected) in rows {
        let s = f64::exp2(f64::from(exponent));
        let (center, ray) = (Vec3::NEG_Z, Ray::new(Point3::ZERO, s * Vec3::NEG_Z));
        let hit = Sphere::new(center, 0.5).hit(&ray, 0.0, f64::INFINITY);
        let answers = [
            normals::hit_sphere(center, 0.5, &ray),
            half_b_sphere::hit_sphere(center, 0.5, &ray),
            hit.map(|hit| hit.t),
        ];
        let found = answers.map(|t| match t {
            None => "a miss",
            Some(t) if t.is_nan() => "NaN",
            Some(t) if t.is_infinite() => "infinite",
            Some(t) if t == 0.5 / s => "right",
            Some(_) => "wrong",
        });
        assert_eq!(found, expected, "for a length of 2^{exponent}");
    }
}

/// Below 2⁻¹⁰²² there are fewer digits the smaller a number is, and h² is smaller
/// than b²: where the last digit of one is lost, the other may have it still.
#[test]
fn a_length_of_two_to_minus_515_tells_the_two_formulas_apart() {
    let cases = samples(&strategies::anywhere(), CASES);
    let differ = share(&cases, |case| {
        let direction = f64::exp2(-515.0) * case.ray.direction.normalize();
        let case = case.with_ray(case.ray.origin, direction);
        let full = case.solve(&normals::hit_sphere);
        let half = case.solve(&half_b_sphere::hit_sphere);
        full.zip(half).is_some_and(|(full, half)| full != half)
    });
    assert!(differ > 0.1, "{differ}");
}

fn assert_rows(rows: &[Row], found: impl Fn(&Method, &[Case]) -> f64) {
    for (row, (methods, rays, level, range)) in rows.iter().enumerate() {
        let cases = samples(&rays(*level), CASES);
        for method in *methods {
            let (name, found) = (method.name, found(method, &cases));
            assert!(
                range.contains(&found),
                "row {row}: {found} for {name}, not {range:?}: if it is better, say so there"
            );
        }
    }
}

/// The share of the cases that count.
fn share(cases: &[Case], is_counted: impl Fn(&Case) -> bool) -> f64 {
    cases.iter().filter(|case| is_counted(case)).count() as f64 / cases.len() as f64
}

/// The error of the nearer root, in ulps of the method's precision, that this share of the
/// hits does not exceed.
fn percentile(method: &Method, cases: &[Case], share: f64) -> f64 {
    let ulp = method.precision().epsilon() / f64::EPSILON;
    let error = |case: &Case| {
        let case = case.rounded(method.precision());
        let exact = Exact::of(&case);
        let found = case.put_to(method, f64::NEG_INFINITY, f64::INFINITY)?;
        Some(exact.nearer_root()?.error_in_ulps(found) / ulp)
    };
    let mut errors: Vec<f64> = cases.iter().filter_map(error).collect();
    errors.sort_by(f64::total_cmp);
    errors[((errors.len() - 1) as f64 * share) as usize]
}
