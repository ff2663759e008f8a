//! Strategies for methods that claim to be right for every input: what only arithmetic
//! without end gets right.

use common::rtweekend::*;
use laws::oracle::ExactCase;
use laws::strategies::{
    ahead_if_zero, any_case, far, number, ordinary_sphere, tangents, unit, whole_vector,
};
use laws::{Case, IntervalCase};
use proptest::prelude::*;
use proptest::sample::select;
use std::ops::RangeInclusive;

/// Makes cases of numbers that programs forget: zeros of either sign, the least, the largest, and
/// one.
fn specks() -> impl Strategy<Value = Case> {
    let least = f64::from_bits(1);
    let sizes = [0.0, 1.0, least, f64::MIN_POSITIVE, 1e154, f64::MAX];
    let number = select(sizes.map(|size| [size, -size]).concat());
    proptest::array::uniform10(number).prop_map(Case::from_numbers)
}

/// Makes cases that are hard for any method: one of all kinds in this file.
pub(crate) fn hostile() -> impl Strategy<Value = Case> {
    prop_oneof![
        4 => any_case(),
        1 => specks(),
        1 => far(15.0..=17.0),
        1 => leaving_the_surface(0.0..=9.0),
        1 => almost_tangents(),
        1 => whole_number_tangents_an_ulp_off(),
        1 => in_another_unit(any_case()),
        1 => moved_away(any_case()),
        1 => any_numbers(),
    ]
}

/// Makes rays that start on the surface up to one rounding of each coordinate, as the book scatters
/// them: in the direction of the normal plus any unit vector. The radius is 10ᵏ.
pub(crate) fn leaving_the_surface(k: RangeInclusive<f64>) -> impl Strategy<Value = Case> {
    (number(k), ordinary_sphere(), unit(), unit()).prop_map(|(k, (center, _), normal, scatter)| {
        let radius = 10f64.powf(k);
        Case {
            center,
            radius,
            ray: Ray::new(center + radius * normal, normal + scatter),
        }
    })
}

/// Makes cases of whole numbers, with a radius within three ulps of the line's distance from the
/// center.
fn almost_tangents() -> impl Strategy<Value = Case> {
    (whole_vector(50), whole_vector(50), whole_vector(50), -3..=3).prop_map(
        |(center, origin, direction, ulps)| {
            let d = ahead_if_zero(direction);
            let across = d.cross(center - origin);
            let distance = (across.length_squared() / d.length_squared()).sqrt();
            Case {
                center,
                radius: ulps_away(distance, ulps),
                ray: Ray::new(origin, d),
            }
        },
    )
}

/// Makes [`tangents`] whose radius is one ulp too small, right, or one too large.
fn whole_number_tangents_an_ulp_off() -> impl Strategy<Value = Case> {
    (tangents(), -1..=1).prop_map(|(case, ulps)| Case {
        radius: ulps_away(case.radius, ulps),
        ..case
    })
}

/// Scales the lengths of cases, and separately their directions, by powers of two from 2⁻⁵⁰⁰ to
/// 2⁵⁰⁰, which changes no digit.
fn in_another_unit(cases: impl Strategy<Value = Case>) -> impl Strategy<Value = Case> {
    (cases, -500..=500, -500..=500).prop_map(|(case, length, direction)| {
        let [length, direction] = [length, direction].map(|k| f64::exp2(f64::from(k)));
        in_units(&case, length, direction)
    })
}

/// Multiplies the lengths of the case by `length`, and its direction by `direction`.
pub(crate) fn in_units(case: &Case, length: f64, direction: f64) -> Case {
    Case {
        center: length * case.center,
        radius: length * case.radius,
        ray: Ray::new(length * case.ray.origin, direction * case.ray.direction),
    }
}

/// Moves sphere and ray together by up to 2⁶⁰: C and Q have fewer digits in common with C − Q,
/// which is then rounded.
fn moved_away(cases: impl Strategy<Value = Case>) -> impl Strategy<Value = Case> {
    (cases, unit(), number(0.0..=60.0)).prop_map(|(case, way, exponent)| {
        let by = f64::exp2(exponent) * way;
        Case {
            center: case.center + by,
            ..case.with_ray(case.ray.origin + by, case.ray.direction)
        }
    })
}

/// Makes cases of any ten finite numbers: all bits at random.
fn any_numbers() -> impl Strategy<Value = Case> {
    use proptest::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    proptest::array::uniform10(POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO)
        .prop_map(Case::from_numbers)
}

/// Makes rays towards the center of a sphere, with a direction of that length.
pub(crate) fn directions_of(length: f64) -> BoxedStrategy<Case> {
    let towards = move |way: Vec3| Case {
        center: Point3::ZERO,
        radius: 0.5,
        ray: Ray::new(-2.0 * way, length * way),
    };
    unit().prop_map(towards).boxed()
}

/// Adds intervals to cases. Half of the ends are those that a program asks for, 0 and ∞; others are
/// a root up to two ulps, 0, ±1, the largest numbers or ±∞; one in a hundred is NaN.
pub(crate) fn with_hostile_interval(
    cases: impl Strategy<Value = Case>,
) -> impl Strategy<Value = IntervalCase> {
    (cases, end(), end()).prop_map(|(case, low, high)| IntervalCase {
        case,
        t_min: end_of(low, &case).unwrap_or(0.0),
        t_max: end_of(high, &case).unwrap_or(f64::INFINITY),
    })
}

/// An end of a hostile interval: so many ulps from the nearer root or the farther one, or a
/// number whatever the roots are; `None` for what a program asks, 0 and ∞.
type End = Option<Result<(bool, i32), f64>>;

fn end() -> impl Strategy<Value = End> {
    let fixed = vec![
        0.0,
        1.0,
        -1.0,
        f64::MIN,
        f64::MAX,
        f64::NEG_INFINITY,
        f64::INFINITY,
    ];
    prop_oneof![
        50 => Just(None),
        40 => (any::<bool>(), -2..=2).prop_map(|root| Some(Ok(root))),
        9 => select(fixed).prop_map(|number| Some(Err(number))),
        1 => Just(Some(Err(f64::NAN))),
    ]
}

fn end_of(end: End, case: &Case) -> Option<f64> {
    let (nearer, ulps) = match end? {
        Ok(root) => root,
        Err(number) => return Some(number),
    };
    let exact = ExactCase::of(case);
    let root = if nearer {
        exact.nearer_root()
    } else {
        exact.farther_root()
    };
    Some(ulps_away(root?.rounded(), ulps))
}

/// Returns the number that is `ulps` steps above `x`, or below it if `ulps` is negative.
pub(crate) fn ulps_away(x: f64, ulps: i32) -> f64 {
    let step = if ulps > 0 {
        f64::next_up
    } else {
        f64::next_down
    };
    (0..ulps.abs()).fold(x, |x, _| step(x))
}
