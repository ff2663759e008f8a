//! Strategies: rays and spheres that lead to the hard places on purpose.
//!
//! Each strategy builds its ray so that the answer is known beforehand, or lies
//! where a method may fail. Nothing is filtered out. What shrinks to the plainest case comes
//! first in each choice, because proptest shrinks towards it.

use std::f64::consts::{PI, SQRT_2};
use std::ops::RangeInclusive;

use common::rtweekend::*;
use proptest::array::uniform10;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, RngSeed, TestRunner};

use crate::camera::{CameraPixel, height};
use crate::case::{Case, IntervalCase, ray_from};
use crate::list::World;
use crate::oracle::ExactCase;

mod numbers;

pub use numbers::{ahead_if_zero, number, ordinary_sphere, unit, whole_vector};

/// Returns the configuration of every property test: each run makes equal cases, so that a failure
/// is never luck. The environment variable `PROPTEST_RNG_SEED` chooses other cases, and
/// `PROPTEST_CASES` their number.
///
/// Random numbers come by xorshift: cargo builds dependencies without optimization, and proptest's
/// usual ChaCha would then take three quarters of the time.
pub fn config() -> Config {
    let config = Config::default();
    let rng_seed = match config.rng_seed {
        RngSeed::Random => RngSeed::Fixed(0),
        chosen => chosen,
    };
    Config {
        rng_seed,
        rng_algorithm: RngAlgorithm::XorShift,
        // What is found once is found again: no file need keep it.
        failure_persistence: None,
        ..config
    }
}

/// Draws the first `count` values of a strategy, always the same ones, in the order in which a test
/// would try them.
///
/// # Panics
/// If the strategy filters out too many values; none here filters.
pub fn samples<T: std::fmt::Debug>(strategy: &impl Strategy<Value = T>, count: u32) -> Vec<T> {
    let mut runner = TestRunner::new(config());
    let sample = |_| {
        let tree = strategy.new_tree(&mut runner);
        tree.expect("no strategy here filters anything out")
            .current()
    };
    (0..count).map(sample).collect()
}

/// Makes the rays and spheres of [`ordinary`], each with an interval from [`with_interval`].
pub fn ordinary_with_interval() -> impl Strategy<Value = IntervalCase> {
    with_interval(ordinary())
}

/// Makes rays and spheres near and far, from inside and behind, with directions of any length.
/// Rounding decides none of the hits, except that some rays are exact tangents.
pub fn ordinary() -> impl Strategy<Value = Case> {
    prop_oneof![
        3 => integers(),
        2 => book_rays(),
        2 => far(0.5..=2.0),
        2 => grazing(0.3..=1.5),
        2 => inside(),
        1 => tangents(),
        1 => on_the_surface(),
    ]
}

/// Makes rays and spheres by any of the strategies here for one sphere, from small whole numbers to
/// cases where rounding decides.
pub fn any_case() -> impl Strategy<Value = Case> {
    prop_oneof![
        integers(),
        book_rays(),
        tangents(),
        on_the_surface(),
        with_h_zero(),
        inside(),
        grazing(0.0..=15.0),
        far(0.5..=15.0),
        near_the_surface(1.0..=15.0),
        above_the_ground(2.0..=9.0),
        log_uniform(),
        extreme_directions(),
    ]
}

/// Makes pixels that lie in pictures 1 to 400 pixels wide with the aspect ratio 16:9.
pub fn pixels() -> impl Strategy<Value = CameraPixel> {
    (1..=400_u32, any::<[u32; 2]>()).prop_map(|(width, [i, j])| CameraPixel {
        width,
        i: i % width,
        j: j % height(width),
    })
}

/// Makes rays of the book's camera, but for rounding, each with one of the two spheres of chapter 5.
pub fn book_rays() -> impl Strategy<Value = Case> {
    let ball = (Point3::new(0.0, 0.0, -1.0), 0.5);
    let ground = (Point3::new(0.0, -100.5, -1.0), 100.0);
    (pixels(), select(vec![ball, ground]))
        .prop_map(|(pixel, (center, radius))| Case::new(center, radius, pixel.expected_ray()))
}

/// Makes rays towards spheres, from outside, as a camera sees them: a function's author believes
/// these first. All numbers are whole but a radius of ½: the plainest case is the ball of chapter 2.
pub fn in_front() -> impl Strategy<Value = Case> {
    // In the order in which proptest makes them smaller: first the ray is turned to the center.
    (whole_vector(3), whole_vector(9), 1..=9, whole_vector(9)).prop_map(
        |(sideways, oc, radius, origin)| {
            let oc = ahead_if_zero(oc);
            let outside = (oc.length().ceil() - 1.0).max(0.5);
            let direction = match oc + sideways {
                direction if direction.dot(oc) > 0.0 => direction,
                _ => oc,
            };
            let ray = ray_from(origin, direction);
            Case::new(origin + oc, f64::from(radius).min(outside), ray)
        },
    )
}

/// Makes rays and spheres of whole numbers from −18 to 18, so that answers can be checked by hand.
/// No radius and no direction is zero.
pub fn integers() -> impl Strategy<Value = Case> {
    (whole_vector(9), 1..=9, whole_vector(9), whole_vector(9)).prop_map(
        |(oc, radius, origin, direction)| {
            let ray = ray_from(origin, ahead_if_zero(direction));
            // So made, proptest may shrink the origin alone, and the answer stays.
            Case::new(origin + oc, f64::from(radius), ray)
        },
    )
}

/// Makes rays that start inside of a sphere, in its center or with a direction at a right angle to
/// the vector to the center: h = d·oc is 0 exactly, because all numbers are whole.
pub fn with_h_zero() -> impl Strategy<Value = Case> {
    let turn = prop_oneof![Just(Vec3::ZERO), whole_vector(3)];
    (whole_vector(9), whole_vector(3), turn, 1..=9).prop_map(|(origin, direction, turn, depth)| {
        let direction = ahead_if_zero(direction);
        let oc = direction.cross(turn);
        let radius = oc.length().ceil() + f64::from(depth);
        Case::new(origin + oc, radius, ray_from(origin, direction))
    })
}

/// Makes rays whose line passes the center of a sphere, about three radii away, at a distance of
/// r·(1 ± 10⁻ᵏ), for k in the range: the larger k, the closer to a tangent.
pub fn grazing(k: RangeInclusive<f64>) -> impl Strategy<Value = Case> {
    aimed(Just(3.0), about_one(k))
}

/// Makes rays and spheres whose center is about 10ᵏ radii away from the ray's origin, for k in the
/// range; the line passes the center within 1.2 radii.
pub fn far(k: RangeInclusive<f64>) -> impl Strategy<Value = Case> {
    aimed(number(k).prop_map(|k| 10f64.powf(k)), number(0.0..=1.2))
}

/// Makes rays that start about `away` radii before the center of a sphere, and whose lines pass the
/// center at `miss_by` radii. The directions have lengths from √⅛ to √8.
fn aimed(
    away: impl Strategy<Value = f64>,
    miss_by: impl Strategy<Value = f64>,
) -> impl Strategy<Value = Case> {
    let turn_and_length = (number(0.0..=2.0), number(-3.0..=3.0));
    (away, miss_by, ordinary_sphere(), unit(), turn_and_length).prop_map(
        |(away, miss_by, (center, radius), forward, (turn, exponent))| {
            let (sin, cos) = (turn * PI).sin_cos();
            let across = forward.any_orthonormal_vector();
            let sideways = cos * across + sin * forward.cross(across);
            let closest = center + radius * miss_by * sideways;
            let origin = closest - radius * away * forward;
            let direction = SQRT_2.powf(exponent) * forward;
            Case::new(center, radius, ray_from(origin, direction))
        },
    )
}

/// Makes rays in any direction that start at a distance of r·(1 ± 10⁻ᵏ) from the center, for k in
/// the range, as rays do that are reflected by the surface.
pub fn near_the_surface(k: RangeInclusive<f64>) -> impl Strategy<Value = Case> {
    from(about_one(k))
}

/// Makes rays in any direction from anywhere inside of a sphere.
pub fn inside() -> impl Strategy<Value = Case> {
    from(number(0.0..=1.0))
}

/// Makes rays in any direction that start `away` radii from the center.
fn from(away: impl Strategy<Value = f64>) -> impl Strategy<Value = Case> {
    (away, ordinary_sphere(), unit(), unit()).prop_map(
        |(away, (center, radius), normal, direction)| {
            let origin = center + radius * away * normal;
            Case::new(center, radius, ray_from(origin, direction))
        },
    )
}

/// Makes numbers 1 ± 10⁻ᵏ.
fn about_one(k: RangeInclusive<f64>) -> impl Strategy<Value = f64> {
    (number(k), sign()).prop_map(|(k, sign)| 1.0 - sign * 10f64.powf(-k))
}

fn sign() -> impl Strategy<Value = f64> {
    prop_oneof![Just(1.0), Just(-1.0)]
}

/// Makes rays in any direction that start 0.01 to 10 units above a ground sphere of radius 10ᵏ, for
/// k in the range.
pub fn above_the_ground(k: RangeInclusive<f64>) -> impl Strategy<Value = Case> {
    (number(k), number(0.01..=10.0), unit()).prop_map(|(k, height, direction)| {
        let radius = 10f64.powf(k);
        let center = Point3::new(0.0, -(radius + height), 0.0);
        Case::new(center, radius, ray_from(Point3::ZERO, direction))
    })
}

/// Makes rays whose line touches a sphere exactly, from right triangles with whole sides: every
/// operation of the quadratic is exact, too.
pub fn tangents() -> impl Strategy<Value = Case> {
    let legs_and_hypotenuse = vec![[3.0, 4.0, 5.0], [5.0, 12.0, 13.0], [8.0, 15.0, 17.0]];
    // In three planes, so that each letter of a dot product has its turn.
    let planes: Vec<fn(f64, f64) -> Vec3> = vec![
        |p, q| Vec3::new(p, q, 0.0),
        |p, q| Vec3::new(0.0, p, q),
        |p, q| Vec3::new(q, 0.0, p),
    ];
    (
        select(legs_and_hypotenuse),
        select(planes),
        1..=9,
        1..=9,
        whole_vector(99),
    )
        .prop_map(|([p, q, hypotenuse], plane, t, k, origin)| {
            // As long as the direction and at a right angle to it: the line
            // passes the center at k hypotenuses, and touches at t.
            let (direction, sideways) = (plane(p, q), plane(-q, p));
            let center = origin + f64::from(t) * direction + f64::from(k) * sideways;
            let ray = ray_from(origin, direction);
            Case::new(center, f64::from(k) * hypotenuse, ray)
        })
}

/// Makes rays that start on a sphere and go inside: the nearer root is 0 exactly, and no operation
/// rounds.
pub fn on_the_surface() -> impl Strategy<Value = Case> {
    // The sides of boxes whose diagonal is a whole number.
    let boxes = vec![
        Vec3::new(1.0, 0.0, 0.0),
        Vec3::new(1.0, 2.0, 2.0),
        Vec3::new(2.0, 3.0, 6.0),
    ];
    (whole_vector(9), select(boxes), 1..=9, whole_vector(9)).prop_map(
        |(origin, sides, size, direction)| {
            let oc = f64::from(size) * sides;
            let inside = match direction.dot(oc) {
                0.0 => oc,
                h => h.signum() * direction,
            };
            Case::new(origin + oc, oc.length(), ray_from(origin, inside))
        },
    )
}

/// Makes rays and spheres of numbers from 2⁻²⁰ to 2²⁰ in size, all orders of magnitude equally
/// likely; radii are positive.
pub fn log_uniform() -> impl Strategy<Value = Case> {
    let sized = (number(-20.0..=20.0), sign()).prop_map(|(k, sign)| sign * f64::exp2(k));
    uniform10(sized).prop_map(|numbers| {
        let case = Case::from_numbers(numbers);
        Case {
            radius: case.radius.abs(),
            ..case
        }
    })
}

/// Makes rays that are aimed at a sphere about three radii away, as by [`far`], with directions
/// that are 10⁻¹⁵⁰ to 10¹⁵⁰ times as long.
pub fn extreme_directions() -> impl Strategy<Value = Case> {
    (number(-150.0..=150.0), far(0.5..=0.5)).prop_map(|(exponent, case)| {
        case.with_ray(case.ray.origin, 10f64.powf(exponent) * case.ray.direction)
    })
}

/// Adds to each ray and sphere an interval. Its ends lie up to three chords before or after the
/// nearer root, some of them exactly at a root; or it begins at 0, or goes on to infinity. Few
/// intervals are empty.
pub fn with_interval(cases: impl Strategy<Value = Case>) -> impl Strategy<Value = IntervalCase> {
    let end = || {
        prop_oneof![
            Just(None),
            number(-3.0..=3.0).prop_map(Some),
            select(vec![Some(0.0), Some(1.0)]),
        ]
    };
    let may_be_empty = proptest::bool::weighted(0.1);
    (cases, end(), end(), may_be_empty).prop_map(|(case, low, high, may_be_empty)| {
        let low = low.map_or(0.0, |share| on_the_way(&case, share));
        let high = high.map_or(f64::INFINITY, |share| on_the_way(&case, share));
        let [t_min, t_max] = match (may_be_empty, low < high) {
            (true, _) | (_, true) => [low, high],
            (false, false) if low == high => [low, f64::INFINITY],
            (false, false) => [high, low],
        };
        IntervalCase { case, t_min, t_max }
    })
}

/// Makes lists of one to three spheres near the ray's origin, which is (0, 0, 0), of whole numbers
/// that can be checked by hand. The interval is the open one from 0 to infinity.
pub fn whole_worlds() -> impl Strategy<Value = World> {
    let radius = (1..=3).prop_map(f64::from);
    (vec((whole_vector(4), radius), 1..4), whole_vector(3)).prop_map(|(spheres, direction)| World {
        spheres,
        ray: ray_from(Point3::ZERO, ahead_if_zero(direction)),
        t_min: 0.0,
        t_max: f64::INFINITY,
    })
}

/// Makes lists of one to eleven spheres with a ray and an interval, which are made for one of them.
/// The others have their centers on the line from the ray's origin through the center of that one:
/// in front of it, behind it, overlapping it, or behind the ray's origin.
pub fn worlds() -> impl Strategy<Value = World> {
    let asked = with_interval(prop_oneof![
        integers(),
        book_rays(),
        far(0.5..=3.0),
        inside(),
    ]);
    let move_and_size = (number(-3.0..=3.0), number(0.5..=2.0));
    (asked, vec(move_and_size, 0..11), 0..11usize).prop_map(|(asked, others, place)| {
        let IntervalCase { case, t_min, t_max } = asked;
        let towards = case.center - case.ray.origin;
        let mut spheres: Vec<(Point3, f64)> = others
            .into_iter()
            .map(|(by, size)| (case.center + by * towards, size * case.radius))
            .collect();
        spheres.insert(place.min(spheres.len()), (case.center, case.radius));
        World {
            spheres,
            ray: case.ray,
            t_min,
            t_max,
        }
    })
}

/// Returns the `t` at a share of the way from the nearer root, at 0, to the farther one, at 1; if
/// the line misses, of the way from 0 to [`Case::t_scale`].
fn on_the_way(case: &Case, share: f64) -> f64 {
    let exact = ExactCase::of(case);
    let roots = exact.nearer_root().zip(exact.farther_root());
    let [nearer, farther] = roots.map_or([0.0, case.t_scale()], |(nearer, farther)| {
        [nearer.rounded(), farther.rounded()]
    });
    (1.0 - share) * nearer + share * farther
}
