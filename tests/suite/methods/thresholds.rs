//! Where the quadratic stops working, and that it works until there: a table of methods, of
//! rays of one kind, and of how often they are decided wrongly.
//!
//! Each row asserts both sides of a threshold: an improvement is noticed as surely as a
//! regression. `half_b` is chapter 5 to the last bit. A decision is in danger where |D| is not
//! above its bound in `speed_vs_accuracy::bounds`.

use std::ops::RangeInclusive;

use common::rtweekend::*;
use hittable_list::{Hittable, Sphere};
use laws::Case;
use laws::strategies::{self, samples};
use measure::accuracy::exact;
use proptest::prelude::*;
use speed_vs_accuracy::Method;

use crate::methods::hostile;
use crate::methods::promised::in_front;
use crate::methods::question;

const CASES: u32 = 4000;

/// Makes rays of one kind, at its level k.
type Rays = fn(f64) -> BoxedStrategy<Case>;

const BOOK: Rays = |_| strategies::book_rays().boxed();
const FAR: Rays = |k| strategies::far(k..=k).boxed();
const GRAZING: Rays = |k| strategies::grazing(k..=k).boxed();
const LEAVING: Rays = |k| hostile::leaving_the_surface(k..=k).boxed();
const NEAR: Rays = |k| strategies::near_the_surface(k..=k).boxed();

/// Tangents of whole numbers whose radius is an ulp too small: all are misses.
const BESIDE_TANGENTS: Rays = |_| {
    let smaller = |case: Case| Case {
        radius: case.radius.next_down(),
        ..case
    };
    strategies::tangents().prop_map(smaller).boxed()
};

const PLAIN: &[Method] = &[Method::HALF_B, Method::HALF_B_Q];
const DISTANCE: &[Method] = &[Method::CROSS_Q, Method::COMPENSATED];
const FEW_DIGITS_OF_C: &[Method] = &[Method::HALF_B_Q, Method::CROSS_Q];
const DIGITS_OF_C: &[Method] = &[Method::COMPENSATED, Method::DOUBLE_DOUBLE];
const DOUBLE_DOUBLE: &[Method] = &[Method::DOUBLE_DOUBLE];
const CERTAIN: &[Method] = &[Method::CERTIFIED_HIT, Method::CERTIFIED_T, Method::EXACT];
const WIDENED: &[Method] = &[Method::WIDENED_HALF_B_Q_F32];
const SINGLE: &[Method] = &[Method::HALF_B_F32, Method::WIDENED_HALF_B_Q_F32];

type Row = (&'static [Method], Rays, f64, RangeInclusive<f64>);

/// Some methods, rays at a level, and between what shares of them each of the methods decides wrongly.
const ROWS: [Row; 22] = [
    // At 10ᵏ radii D/(a·M) is (1 − m²)·10⁻²ᵏ for a line that passes the center at m radii.
    // At k = 7 the band of 3e-15 reaches the rays that come within 10 % of the rim; at
    // k = 9 r² is less than one rounding of oc·oc, and nothing is left of it in c.
    (PLAIN, FAR, 5.0, 0.0..=0.001),
    (PLAIN, FAR, 7.0, 0.001..=0.05),
    (PLAIN, FAR, 9.0, 0.25..=0.6),
    (DISTANCE, FAR, 11.0, 0.0..=0.0),
    (&[Method::CROSS_Q], FAR, 15.0, 0.01..=0.06),
    (&[Method::COMPENSATED], FAR, 15.0, 0.0..=0.001),
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

#[test]
fn each_method_decides_wrongly_as_often_as_its_row_says() {
    for (row, (methods, rays, level, range)) in ROWS.iter().enumerate() {
        let cases = samples(&rays(*level), CASES);
        for method in *methods {
            let found = share(&cases, |case| {
                let given = question(case).rounded(method.precision());
                let exact = exact(&given).expect("the cases are finite");
                let is_hit = exact.nearest_root_in(0.0, f64::INFINITY).is_some();
                in_front(&given, method).is_some() != is_hit
            });
            assert!(
                range.contains(&found),
                "row {row}: {found} for {}, not {range:?}: if it is better, say so there",
                method.name
            );
        }
    }
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
    let cases = samples(&strategies::any_case(), CASES);
    let differ = share(&cases, |case| {
        let direction = f64::exp2(-515.0) * case.ray.direction.normalize();
        let case = case.with_ray(case.ray.origin, direction);
        let full = case.solve(&normals::hit_sphere);
        let half = case.solve(&half_b_sphere::hit_sphere);
        full.zip(half).is_some_and(|(full, half)| full != half)
    });
    assert!(differ > 0.1, "{differ}");
}

/// Returns the share of the cases that count.
fn share(cases: &[Case], is_counted: impl Fn(&Case) -> bool) -> f64 {
    cases.iter().filter(|case| is_counted(case)).count() as f64 / cases.len() as f64
}
