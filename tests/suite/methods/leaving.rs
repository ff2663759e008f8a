//! Rays that leave a surface: what `proven_offset` promises, for spheres and points that
//! nobody would draw. The judges are exact arithmetic and the plain tests themselves.

use std::ops::RangeInclusive;

use common::rtweekend::*;
use figures::records::Shadows;
use figures::table::{Record, Table};
use laws::Case;
use laws::oracle::Exact;
use laws::strategies::samples;
use measure::shadows;
use proptest::prelude::*;
use speed_vs_accuracy::{Departure, Method, Precision, proven_offset};

mod the_proven_offset {
    use super::*;

    #[test]
    fn lets_no_ray_out_into_its_sphere_and_no_ray_in_beside_it() {
        for precision in Precision::ALL {
            for case in hostile(precision) {
                let left = leave(&case, precision);
                assert_eq!(left.t_min, 0.0);
                for method in plain(precision).iter().chain([&Method::EXACT]) {
                    assert_eq!(
                        is_met(&case, &left, method),
                        goes_in(&case),
                        "{} in {}: {case}",
                        method.name,
                        precision.name()
                    );
                }
            }
        }
    }

    /// |c| > 8u·M is what the filter of the certified methods asks for.
    #[test]
    fn starts_where_the_sign_of_c_survives_its_rounding() {
        for case in hostile(Precision::Double) {
            let Departure { ray, .. } = leave(&case, Precision::Double);
            let oc_squared = (case.center - ray.origin).length_squared();
            let r_squared = case.radius * case.radius;
            let c = oc_squared - r_squared;
            let away = if goes_in(&case) { -c } else { c };
            let band = 4.0 * f64::EPSILON * (oc_squared + r_squared);
            assert!(away > band, "{away} of {band}: {case}");
        }
    }

    /// The proof says from 15.4u·r + 0.9u·|C| to 29u·r + 3.1u·|C|.
    #[test]
    fn goes_as_far_as_is_proved_and_no_farther() {
        for precision in Precision::ALL {
            let u = precision.epsilon() / 2.0;
            for case in hostile(precision) {
                let left = leave(&case, precision);
                let moved = case.with_ray(left.ray.origin, left.ray.direction);
                // With x = |P − C|/r, the margin is (x² − 1) / (x² + 1).
                let margin = Exact::of(&moved).origin_margin();
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
    fn is_none_where_there_may_be_no_such_point() {
        let leave = |center: Point3, radius: f64, point: Point3| {
            proven_offset(center, radius, point, Vec3::X, Precision::Double)
        };
        assert!(leave(Point3::ZERO, 1.0, Point3::X).is_some());
        for radius in [0.0, -1.0, 1e-80, 1e80, f64::INFINITY, f64::NAN] {
            assert_eq!(leave(Point3::ZERO, radius, Point3::X), None, "{radius}");
        }
        for point in [0.0, 1e-80, 1e80, f64::INFINITY, f64::NAN] {
            let point = Point3::new(point, 0.0, 0.0);
            assert_eq!(leave(Point3::ZERO, 1.0, point), None, "{point}");
        }
        // On either side of the sizes for which there is a proof.
        let single = |radius: f64| {
            let point = radius * Point3::X;
            proven_offset(Point3::ZERO, radius, point, Vec3::X, Precision::Single).is_some()
        };
        assert_eq!(
            [0.9e-7, 1.1e-7, 0.9e9, 1.1e9].map(single),
            [false, true, true, false]
        );
        let at = |away: f64| leave(away / f64::EPSILON * Point3::Y, 1.0, Point3::ZERO).is_some();
        assert_eq!([0.49, 0.51].map(at), [true, false]);
        // Where numbers are 2 apart, there is no room for a sphere.
        for center in [1e16, f64::INFINITY, f64::NAN] {
            let center = Point3::new(center, 0.0, 0.0);
            assert_eq!(leave(center, 1.0, Point3::ZERO), None, "{center}");
        }
    }
}

/// `measured/shadows.csv`
mod what_was_measured {
    use super::*;

    /// So many that the first five hundred clear ones are among them.
    #[test]
    fn is_answered_as_it_was_when_a_part_is_asked_again() {
        let again = shadows::table(700, 1).rows;
        let recorded = recorded();
        assert_eq!(recorded.len(), again.len(), "rows of {}", Shadows::FILE);
        for (old, new) in recorded.iter().zip(&again) {
            let key = |row: &Shadows| (row.leaving.clone(), row.level, row.tester.clone());
            assert_eq!(
                (key(old), old.answers),
                (key(new), new.answers),
                "it was measured otherwise. If that was meant:\n\
                 cargo bench -p measure --bench accuracy -- --record"
            );
        }
    }

    #[test]
    fn is_wrong_with_the_others_at_their_scales() {
        for row in recorded() {
            let [dark, light] = wrong(&row).map(|share| share > 0.0);
            let k = row.level;
            let expected = match (&*row.leaving, row.precision) {
                ("at_once", _) => [true, false],
                ("after_t_min", Precision::Double) => [false, k <= 3],
                ("after_t_min", Precision::Single) => [k >= 1, k <= -1],
                ("integer_offset", _) => [k != 0, k <= -2],
                ("optix_offset", Precision::Double) => [k == 7 && row.tester == "exact", false],
                _ => [false, false],
            };
            assert_eq!([dark, light], expected, "{row:?}");
        }
    }

    fn wrong(row: &Shadows) -> [f64; 2] {
        [row.false_shadows_per_million, row.light_leaks_per_million]
    }

    fn recorded() -> Vec<Shadows> {
        let file = include_str!("../../../book/notes/measured/shadows.csv");
        Table::read(file).expect("the file is well-formed").rows
    }
}

/// Methods whose answer is proved.
fn plain(precision: Precision) -> &'static [Method] {
    match precision {
        Precision::Double => &[Method::HALF_B, Method::HALF_B_Q],
        Precision::Single => &[Method::HALF_B_F32],
    }
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

fn unit() -> impl Strategy<Value = Vec3> {
    let number = || -1.0..1.0;
    (number(), number(), number())
        .prop_map(|(x, y, z)| Vec3::new(x, y, z).try_normalize().unwrap_or(Vec3::X))
}

fn leave(case: &Case, precision: Precision) -> Departure {
    let Ray { origin, direction } = case.ray;
    proven_offset(case.center, case.radius, origin, direction, precision)
        .unwrap_or_else(|| panic!("there is no way to leave: {case}"))
}

/// As the function itself sees it: the ray turns towards the center.
fn goes_in(case: &Case) -> bool {
    case.ray.direction.dot(case.ray.origin - case.center) < 0.0
}

fn is_met(case: &Case, left: &Departure, method: &Method) -> bool {
    let case = case.with_ray(left.ray.origin, left.ray.direction);
    case.put_to(method, left.t_min, f64::INFINITY).is_some()
}
