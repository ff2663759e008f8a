//! The cases and the scenes by which chapter 6 is measured.

use common::rtweekend::*;
use laws::oracle::ExactCase;
use measure::scene_file::find_scene;
use speed_vs_accuracy::{
    Arithmetic, Case, Lens, Method, Precision, REGIMES, Scene, exact_discriminant,
};

mod cases {
    use super::*;

    fn of_all_regimes() -> impl Iterator<Item = Case> {
        let regimes = REGIMES.iter();
        regimes.flat_map(|regime| regime.cases(Precision::Double, 4, 300))
    }

    #[test]
    fn have_the_discriminant_of_half_b_to_the_bit() {
        for case in of_all_regimes() {
            let found = case.put_to(&Method::HALF_B, f64::NEG_INFINITY, f64::INFINITY);
            let discriminant = case.discriminant();
            let expected =
                (discriminant >= 0.0).then(|| (case.h() - discriminant.sqrt()) / case.a());
            assert_eq!(found, expected.filter(|t| t.is_finite()), "{case}");
        }
    }

    /// The oracle of the laws computes the discriminant by other code.
    #[test]
    fn have_an_exact_discriminant_that_is_the_oracle_s() {
        for case in of_all_regimes() {
            let asked = laws::Case::new(case.center, case.radius, case.ray);
            let exact = ExactCase::of(&asked);
            let found = exact_discriminant(case.center, case.radius, &case.ray).expect("finite");
            assert_eq!(found.total_cmp(&0.0), exact.discriminant(), "{case}");
            // a and M are off by some 3u each, and three more operations round.
            let expected = exact.discriminant_margin() * asked.a() * asked.m();
            let bound = 8.0 * f64::EPSILON * expected.abs();
            assert!(
                (found - expected).abs() <= bound,
                "{found} and {expected}: {case}"
            );
        }
        let far = Case::from_numbers([f64::INFINITY, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
        assert_eq!(exact_discriminant(far.center, far.radius, &far.ray), None);
    }
}

mod a_scene {
    use super::*;

    /// A ball straight ahead, and a smaller one nearer to where the top should be.
    #[test]
    fn stands_upright_wherever_the_camera_looks() {
        for (direction, top) in [
            ([0.0, 0.0, -1.0], Vec3::Y),
            ([3.0, 0.0, 0.0], Vec3::Y),
            ([0.0, 0.0, 1e300], Vec3::Y),
            ([0.0, 5e-324, 0.0], Vec3::NEG_Z),
            ([0.0, -2.0, 0.0], Vec3::NEG_Z),
            ([-1.0, -1.0, 0.0], Vec3::new(-1.0, 1.0, 0.0).normalize()),
        ] {
            let direction = Vec3::from(direction);
            let ahead = 5.0 * (direction / direction.abs().max_element()).normalize();
            let scene = Scene {
                lens: Lens::new(Point3::ZERO, direction, [1.0; 2]),
                spheres: vec![(ahead, 1.0), (ahead + 2.0 * top, 0.5)],
                ..Scene::telescope()
            };
            let camera = Camera::new(33);
            let seen = |i, j| {
                let sight = scene.look(Arithmetic::Exact, &camera.ray(i, j));
                sight.hit.map(|hit| hit.sphere)
            };
            assert_eq!(
                [seen(16, 9), seen(16, 5), seen(16, 13)],
                [Some(0), Some(1), None]
            );
            assert_eq!([seen(10, 9), seen(22, 9)], [None, None], "{direction}");
        }
    }

    #[test]
    fn of_the_book_is_the_picture_of_chapter_5() {
        let book = find_scene("book").expect("it is one of the seven");
        let drawn = book.seen_by([Arithmetic::Method(Method::HALF_B); 2], 100);
        assert_eq!(drawn, hittable_list::picture(100));
    }
}
