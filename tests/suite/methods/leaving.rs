//! Rays that leave a surface: what `proven_offset` promises, for spheres and points that
//! a search for trouble would draw. The judges are exact arithmetic and the plain tests
//! themselves.

use std::ops::RangeInclusive;

use common::rtweekend::*;
use laws::Case;
use laws::oracle::Exact;
use laws::strategies::samples;
use measure::scene_file::find_scene;
use proptest::prelude::*;
use speed_vs_accuracy::{Method, Precision, proven_offset};

/// The scene of the specks, in `f32`: the ground shades itself in spite of 0.001, and not
/// if the ray starts where it should. A small ball casts no shadow because of 0.001.
#[test]
fn a_thousandth_is_too_little_on_a_large_ground_and_too_much_under_a_small_ball() {
    let scene = find_scene("shadows").expect("it is one of the seven");
    let sun = scene.sun.expect("it casts shadows");
    let (center, radius) = scene.spheres[1];
    let camera = Camera::new(100);
    let pixels = (0..camera.image_height).flat_map(|j| (0..100).map(move |i| (i, j)));
    let leaving = pixels.filter_map(|(i, j)| {
        let ground = Case {
            center,
            radius,
            ray: scene.ray(&camera.ray(i, j)),
        };
        let t = ground.put_to(&Method::HALF_B_F32, 0.0, f64::INFINITY)?;
        let point = ground.point(t, Precision::Single);
        Some(ground.with_ray(point, sun).rounded(Precision::Single))
    });
    let is_met = |case: &Case, t_min| {
        case.put_to(&Method::HALF_B_F32, t_min, f64::INFINITY)
            .is_some()
    };
    let leaving: Vec<Case> = leaving.collect();
    let specks = leaving.iter().filter(|case| is_met(case, 0.001)).count();
    assert!(100 * specks > leaving.len(), "{specks}");
    for case in leaving {
        assert!(!is_met(&moved(&case, Precision::Single), 0.0), "{case}");
    }

    let ball = Case {
        center: Point3::new(0.0, 1.0005, 0.0),
        radius: 0.0004,
        ray: Ray::new(Point3::Y, Vec3::Y),
    };
    let ground = Case {
        center: Point3::ZERO,
        radius: 1.0,
        ..ball
    };
    let from_there = ball.with_ray(moved(&ground, Precision::Double).ray.origin, Vec3::Y);
    let hits = |case: &Case, t_min| case.put_to(&Method::HALF_B, t_min, f64::INFINITY);
    assert_eq!(hits(&ball, 0.001), None);
    assert!(hits(&from_there, 0.0).is_some());
}

/// By whichever test: every third ray that goes out does so, as exact arithmetic sees it.
#[test]
fn a_ray_that_leaves_at_once_may_meet_its_own_sphere() {
    let asked = samples(&crate::hostile::leaving_the_surface(0.0..=3.0), 4000);
    let out: Vec<Case> = asked.into_iter().filter(|case| !goes_in(case)).collect();
    let met = out.iter().filter(|case| is_met(case, &Method::EXACT));
    let share = met.count() as f64 / out.len() as f64;
    assert!((0.2..0.5).contains(&share), "{share}");
}

#[test]
fn the_proven_offset_lets_no_ray_out_into_its_sphere_and_no_ray_in_beside_it() {
    for precision in Precision::ALL {
        // Those whose answer is proved.
        let methods: &[Method] = match precision {
            Precision::Double => &[Method::EXACT, Method::HALF_B, Method::HALF_B_Q],
            Precision::Single => &[Method::EXACT, Method::HALF_B_F32],
        };
        for case in hostile(precision) {
            for method in methods {
                let name = method.name;
                let is_met = is_met(&moved(&case, precision), method);
                assert_eq!(is_met, goes_in(&case), "{name} in {precision:?}: {case}");
            }
        }
    }
}

/// |c| > 8u·M is what the filter of the certified methods asks for.
#[test]
fn the_sign_of_c_survives_its_rounding_at_the_proven_offset() {
    for case in hostile(Precision::Double) {
        let moved = moved(&case, Precision::Double);
        let away = if goes_in(&case) {
            -moved.c()
        } else {
            moved.c()
        };
        let band = 4.0 * f64::EPSILON * moved.m();
        assert!(away > band, "{away} of {band}: {case}");
    }
}

/// The proof says from 15.4u·r + 0.9u·|C| to 29u·r + 3.1u·|C|.
#[test]
fn the_proven_offset_goes_as_far_as_is_proved_and_no_farther() {
    for precision in Precision::ALL {
        let u = precision.epsilon() / 2.0;
        for case in hostile(precision) {
            // With x = |P − C|/r, the margin is (x² − 1) / (x² + 1).
            let margin = Exact::of(&moved(&case, precision)).origin_margin();
            let x = ((1.0 + margin) / (1.0 - margin)).sqrt();
            let away = (x - 1.0).abs();
            let center = u * case.center.length() / case.radius;
            // What is found here is itself rounded to f64.
            let rounding = 4.0 * f64::EPSILON;
            let [least, most] = [15.4 * u + 0.9 * center, 29.0 * u + 3.1 * center];
            let proved = least - rounding..=most + rounding;
            assert!(proved.contains(&away), "{away} of {proved:?}: {case}");
        }
    }
}

#[test]
fn there_is_no_proven_offset_where_there_may_be_no_such_point() {
    let is_some = |precision, away: f64, radius: f64, point: f64| {
        let center = away * Point3::Y;
        proven_offset(center, radius, point * Point3::X, Vec3::X, precision).is_some()
    };
    let double = |away, radius, point| is_some(Precision::Double, away, radius, point);
    assert!(double(0.0, 1.0, 1.0));
    for size in [0.0, -1.0, 1e-80, 1e80, f64::INFINITY, f64::NAN] {
        assert!(!double(0.0, size, 1.0), "{size}");
        assert!(size == -1.0 || !double(0.0, 1.0, size), "{size}");
    }
    // On either side of the sizes for which there is a proof.
    let single = |size| is_some(Precision::Single, 0.0, size, size);
    let found = [0.9e-7, 1.1e-7, 0.9e9, 1.1e9].map(single);
    assert_eq!(found, [false, true, true, false]);
    let far = [0.49, 0.51, f64::INFINITY, f64::NAN].map(|away| away / f64::EPSILON);
    let found = far.map(|away| double(away, 1.0, 0.0));
    assert_eq!(found, [true, false, false, false]);
}

/// Spheres, points on them or far off, as the origins of rays, and directions as near to a
/// tangent as may be.
fn hostile(precision: Precision) -> Vec<Case> {
    let (sizes, distances, offs, least) = match precision {
        Precision::Double => (-60.0..=60.0, -3.0..=15.0, -17.0..=1.0, 1e-67),
        Precision::Single => (-5.0..=7.0, -3.0..=6.0, -8.0..=1.0, 1e-7),
    };
    let size = |k: RangeInclusive<f64>| k.prop_map(|k| 10_f64.powf(k));
    let sign = || prop_oneof![Just(1.0), Just(-1.0)];
    let unit = laws::strategies::unit;
    let strategy = (
        (size(sizes), size(distances), unit()),
        (unit(), unit(), sign(), size(offs)),
        (sign(), size(-20.0..=0.0), size(-3.0..=3.0)),
    );
    let strategy = strategy.prop_map(move |(sphere, place, way)| {
        let (radius, distance, where_to) = sphere;
        let (normal, across, above, off) = place;
        let (turn, height, length) = way;
        let center = radius * distance * where_to;
        let point = center + radius * (1.0 + above * off) * normal;
        let direction = length * (normal.cross(across) + turn * height * normal);
        let ray = Ray::new(point, direction);
        Case {
            center,
            radius,
            ray,
        }
        .rounded(precision)
    });
    // A point nearer to the center may have no way to leave.
    let is_off_center = |case: &Case| (case.ray.origin - case.center).length() >= least;
    let cases = samples(&strategy, 6000).into_iter();
    cases.filter(is_off_center).collect()
}

/// The same ray, from where it should start.
fn moved(case: &Case, precision: Precision) -> Case {
    let Ray { origin, direction } = case.ray;
    let from = proven_offset(case.center, case.radius, origin, direction, precision)
        .unwrap_or_else(|| panic!("there is no way to leave: {case}"));
    case.with_ray(from, direction)
}

/// As the function itself sees it: the ray turns towards the center.
fn goes_in(case: &Case) -> bool {
    case.ray.direction.dot(case.ray.origin - case.center) < 0.0
}

fn is_met(case: &Case, method: &Method) -> bool {
    case.put_to(method, 0.0, f64::INFINITY).is_some()
}
