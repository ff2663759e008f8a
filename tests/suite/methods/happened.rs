//! Failures that happened to others: the rays that failed, by the same formula, and by the
//! methods that survive. The page of measurements tells of each.

use common::rtweekend::*;
use speed_vs_accuracy::{Case, METHODS, Method};

use crate::methods::promised::in_front;

const BALL_OF: fn(f64, Ray) -> Case = |radius, ray| Case::new(Point3::ZERO, radius, ray);

/// pytracer, issue 22: a ray from far away, parallel to x, misses a small ball that it hits.
/// No digit of D is left: it is 0, which the report's program takes for a miss, and `half_b`
/// for a tangent, a third of a radius from the surface.
#[test]
fn a_small_ball_has_no_discriminant_from_400_away_in_f32_and_from_ten_million_in_f64() {
    let from = |x: f64| BALL_OF(0.1, Ray::new(Point3::new(-x, 0.095, 0.0), Vec3::X));
    let rows = [
        (
            400.0,
            Method::HALF_B_F32,
            &[Method::WIDENED_HALF_B_Q_F32][..],
        ),
        (1e7, Method::HALF_B, &[Method::CROSS_Q, Method::CERTIFIED_T]),
    ];
    for (x, fails, survive) in rows {
        let case = from(x);
        assert_eq!(in_front(&case, &fails), Some(x));
        let right = in_front(&case.rounded(fails.precision()), &Method::EXACT).expect("it hits");
        assert!(x - right > 0.03);
        for method in survive {
            let t = in_front(&case, method).expect("it hits");
            let ulp = method.precision().epsilon() * x;
            assert!((t - right).abs() <= 2.0 * ulp, "{}: {t}", method.name);
        }
    }
}

/// Mitsuba 3, issue 512: rings on a unit ball that is seen from 1000 away, in `f32`.
#[test]
fn a_ball_has_rings_from_a_thousand_radii_away_in_f32() {
    let farthest = |method: &Method| {
        let off = (0..100).filter_map(|n| {
            let x = f64::from(n) / 101.0;
            let case = BALL_OF(1.0, Ray::new(Point3::new(x, 0.0, 1000.0), Vec3::NEG_Z));
            let t = in_front(&case, method)?;
            Some((case.point(t, method.precision()).length() - 1.0).abs())
        });
        off.fold(0.0, f64::max)
    };
    assert!(farthest(&Method::HALF_B_F32) > 0.01);
    assert!(farthest(&Method::WIDENED_HALF_B_Q_F32) < 1e-4);
}

/// POV-Ray, issue 469: a limit of 10⁷ for every distance is not rounding. No digits help
/// where the range of t ends too soon.
#[test]
fn what_lies_behind_the_end_of_the_range_is_missed_by_every_method() {
    let case = BALL_OF(1e6, Ray::new(Point3::new(0.0, 0.0, 2e7), Vec3::NEG_Z));
    for method in METHODS {
        assert_eq!(case.put_to(method, 0.0, 1e7), None, "{}", method.name);
        assert!(in_front(&case, method).is_some(), "{}", method.name);
    }
}

/// ArborX, pull request 461: q needs a sign of h where h is 0, or both roots are lost.
#[test]
fn a_ray_across_the_way_to_the_center_keeps_its_root() {
    let case = BALL_OF(1.0, Ray::new(Point3::new(0.6, 0.0, 0.0), Vec3::Y));
    for method in METHODS {
        let t = in_front(&case, method).unwrap_or_default();
        let allowed = 8.0 * method.precision().epsilon();
        assert!((t - 0.8).abs() <= allowed, "{}: {t}", method.name);
    }
}

/// `precomputed_atmospheric_scattering`, issue 21: an Earth in meters, in `f32`. The report has
/// no ray; from the height of an eye the distance of the ground is wrong by tens of percents.
#[test]
fn an_earth_in_meters_is_at_a_wrong_distance_in_f32() {
    let worst = |method: &Method| {
        let off = (1..90).filter_map(|degrees| {
            let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
            let ray = Ray::new(Point3::Y, Vec3::new(cos, -sin, 0.0));
            let earth = Case::new(Point3::new(0.0, -6_360_000.0, 0.0), 6_360_000.0, ray);
            let right = in_front(&earth, &Method::EXACT)?;
            Some((in_front(&earth, method)? / right - 1.0).abs())
        });
        off.fold(0.0, f64::max)
    };
    assert!(worst(&Method::HALF_B_F32) > 0.1);
    assert!(worst(&Method::WIDENED_HALF_B_Q_F32) < 1e-6);
}
