//! Each chapter's intersection, under the laws that it is old enough for.
//!
//! The laws and their bounds are in `src/laws.rs`, `src/intervals.rs` and
//! `src/hits.rs`; the rays and spheres come from `src/strategies.rs`.

use ::hittable_list::{HitRecord, Hittable, HittableList, Sphere};
use common::rtweekend::*;
use laws::Case;
use laws::list::{World, worlds};
use laws::runner::holds;
use laws::shrinker::Simplify;
use laws::verdict::Verdict;
use laws::{intervals, nearer_root, record, runner, strategies};
use proptest::prelude::*;

/// A test for each law that is named, with the name of the law.
macro_rules! laws_hold_for {
    ($solve:expr => $($law:ident)*) => {
        $(
            #[test]
            fn $law() {
                runner::judge(nearer_root::$law, &$solve);
            }
        )*
    };
}

/// The same for all laws of a nearer root, `nearer_root::NEARER_ROOT`.
macro_rules! every_law_holds_for {
    ($solve:expr) => {
        laws_hold_for! { $solve =>
            a_ray_aimed_at_the_sphere_hits_and_one_aimed_past_it_misses
            the_line_hits_exactly_when_there_is_a_root
            the_point_lies_on_the_sphere
            the_root_is_the_nearer_one_to_the_digits_that_remain
            a_tangent_is_a_hit
            the_root_of_a_tangent_is_exact
            the_two_roots_add_and_multiply_to_the_coefficients
            a_scene_in_another_unit_has_the_same_digits
            a_scene_in_a_mirror_has_the_same_bits
            a_scene_that_is_moved_has_almost_the_same_root
            finite_input_never_gives_nan
        }
    };
}

mod red_sphere {
    use super::*;

    /// Chapter 2 only says whether there is a root: any number stands for it.
    fn decide(center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
        ::red_sphere::hit_sphere(center, radius, ray).then_some(0.0)
    }

    laws_hold_for! { decide =>
        a_ray_aimed_at_the_sphere_hits_and_one_aimed_past_it_misses
        the_line_hits_exactly_when_there_is_a_root
        a_tangent_is_a_hit
    }

    #[test]
    fn it_hits_exactly_when_chapter_3_has_a_root() {
        holds(&strategies::anywhere(), |case| {
            nearer_root::it_hits_exactly_when_the_other_does(&decide, &::normals::hit_sphere, case)
        });
    }
}

mod normals {
    use super::*;

    every_law_holds_for! { ::normals::hit_sphere }
}

mod half_b_sphere {
    use super::*;

    every_law_holds_for! { ::half_b_sphere::hit_sphere }

    #[test]
    fn it_is_the_full_formula_to_the_last_bit() {
        holds(&strategies::anywhere(), |case| {
            nearer_root::two_chapters_agree_to_the_last_bit(
                &::half_b_sphere::hit_sphere,
                &::normals::hit_sphere,
                case,
            )
        });
    }
}

mod hittable_list_sphere {
    use super::*;

    fn hit(center: Point3, radius: f64, ray: &Ray, t_min: f64, t_max: f64) -> Option<f64> {
        let sphere = Sphere::new(center, radius);
        sphere.hit(ray, t_min, t_max).map(|hit| hit.t)
    }

    /// On the whole line, the nearest root is the nearer one.
    pub(super) fn nearer(center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
        hit(center, radius, ray, f64::NEG_INFINITY, f64::INFINITY)
    }

    every_law_holds_for! { nearer }

    #[test]
    fn the_nearest_root_in_the_interval_is_returned() {
        holds(
            &strategies::with_interval(strategies::anywhere()),
            |asked| intervals::the_nearest_root_in_the_interval_is_returned(&hit, asked),
        );
    }

    #[test]
    fn no_t_outside_the_interval_is_returned() {
        let cases = prop_oneof![strategies::anywhere(), strategies::specks()];
        holds(&strategies::with_interval(cases), |asked| {
            intervals::no_t_outside_the_interval_is_returned(&hit, asked)
        });
    }

    #[test]
    fn the_farther_root_is_the_nearer_one_of_the_ray_turned_round() {
        holds(
            &strategies::with_interval(strategies::anywhere()),
            |asked| {
                intervals::the_farther_root_is_the_nearer_one_of_the_ray_turned_round(&hit, asked)
            },
        );
    }

    #[test]
    fn it_is_the_half_b_of_chapter_4_to_the_last_bit() {
        holds(&strategies::anywhere(), |case| {
            nearer_root::two_chapters_agree_to_the_last_bit(
                &nearer,
                &::half_b_sphere::hit_sphere,
                case,
            )
        });
    }

    #[test]
    fn the_point_of_a_record_is_where_the_ray_is_at_t() {
        let ray = Ray::new(Point3::new(0.5, 1.0, 3.0), Vec3::new(0.0, -0.25, -2.0));
        let sphere = Sphere::new(Point3::new(0.25, 0.5, -1.0), 1.5);
        let record = sphere.hit(&ray, 0.0, f64::INFINITY).expect("it is ahead");
        assert_eq!(record.point, ray.at(record.t));
        assert!(record.front_face);
    }

    #[test]
    fn a_ray_at_a_right_angle_to_the_normal_counts_as_coming_from_inside() {
        let along = Ray::new(Point3::ZERO, Vec3::X);
        let mut record = HitRecord {
            front_face: true,
            ..HitRecord::default()
        };
        record.set_face_normal(&along, Vec3::Y);
        assert!(!record.front_face);
        assert_eq!(record.normal, -Vec3::Y);
    }

    /// As the book does. 49 · (1/49) is not 1.
    #[test]
    fn a_normal_is_a_product_with_the_reciprocal_of_the_radius() {
        let sphere = Sphere::new(Point3::ZERO, 49.0);
        let towards = Ray::new(Point3::new(50.0, 0.0, 0.0), Vec3::NEG_X);
        let record = sphere.hit(&towards, 0.0, 2.0).expect("it is ahead");
        assert_eq!(record.point.x, 49.0);
        assert_eq!(record.normal.x, 49.0 * (1.0 / 49.0));
        assert_ne!(record.normal.x, 1.0);
    }

    #[test]
    fn the_normal_is_a_unit_vector() {
        for_each_record(|case, _, record| record::the_normal_is_a_unit_vector(case, record.normal));
    }

    #[test]
    fn the_normal_points_against_the_ray() {
        for_each_record(|case, _, record| {
            record::the_normal_points_against_the_ray(case, record.normal)
        });
    }

    #[test]
    fn the_front_face_is_where_the_ray_enters() {
        for_each_record(|case, nearer, record| {
            record::the_front_face_is_where_the_ray_enters(case, nearer, record.front_face)
        });
    }

    /// Applies `law` to the record of each root. The nearer one is what an
    /// endless range finds, the farther one what a range behind it finds.
    fn for_each_record(law: impl Fn(&Case, bool, &HitRecord) -> Verdict) {
        holds(
            &strategies::anywhere().prop_map(Recorded),
            |Recorded(case)| {
                let sphere = Sphere::new(case.center, case.radius);
                let mut t_min = f64::NEG_INFINITY;
                for nearer in [true, false] {
                    let Some(record) = sphere.hit(&case.ray, t_min, f64::INFINITY) else {
                        return Ok(());
                    };
                    law(case, nearer, &record)?;
                    t_min = record.t;
                }
                Ok(())
            },
        );
    }

    /// A case of which the records matter.
    #[derive(Clone, Debug)]
    struct Recorded(Case);

    impl Simplify for Recorded {
        fn simpler(&self) -> Vec<Self> {
            self.0.simpler().into_iter().map(Self).collect()
        }

        fn as_test(&self) -> String {
            format!(
                "{}\nlet sphere = Sphere::new(center, radius);\n\
                 let nearer = sphere.hit(&ray, f64::NEG_INFINITY, f64::INFINITY).unwrap();\n\
                 let farther = sphere.hit(&ray, nearer.t, f64::INFINITY).unwrap();\n\
                 for (record, front_face) in [(nearer, true), (farther, false)] {{\n    \
                 assert!((record.normal.length() - 1.0).abs() < 1e-9);\n    \
                 assert!(ray.direction.dot(record.normal) <= 0.0);\n    \
                 assert_eq!(record.front_face, front_face);\n}}",
                self.0
            )
        }
    }
}

mod hittable_list {
    use super::*;
    use laws::list;

    #[test]
    fn the_nearest_of_all_members_is_returned() {
        for_flat_and_nested_lists(list::the_nearest_of_all_members_is_returned);
    }

    #[test]
    fn the_order_of_members_does_not_matter() {
        for_flat_and_nested_lists(list::the_order_of_members_does_not_matter);
    }

    #[test]
    fn a_list_of_one_is_that_one() {
        holds(&worlds(), |world| {
            let (center, radius) = world.spheres[0];
            let sphere = Sphere::new(center, radius);
            let alone = World {
                spheres: vec![(center, radius)],
                ..world.clone()
            };
            list::both_find_the_same(&flat, &|world| nearest(&sphere, world), &alone)
        });
    }

    #[test]
    fn a_nested_list_is_the_flat_list() {
        holds(&worlds(), |world| {
            list::both_find_the_same(&nested, &flat, world)
        });
    }

    #[test]
    fn an_empty_list_is_missed() {
        let empty = HittableList::default();
        let ahead = Ray::new(Point3::ZERO, Vec3::NEG_Z);
        assert_eq!(empty.hit(&ahead, f64::NEG_INFINITY, f64::INFINITY), None);
    }

    #[test]
    fn of_two_that_are_equally_near_the_first_is_hit() {
        let mut list = HittableList::default();
        list.add(Sphere::new(Point3::new(0.0, 0.0, -1.0), 0.5));
        // The ray starts inside this one.
        list.add(Sphere::new(Point3::new(0.0, 0.0, 0.5), 1.0));
        let ahead = Ray::new(Point3::ZERO, Vec3::NEG_Z);
        let record = list
            .hit(&ahead, 0.0, f64::INFINITY)
            .expect("both are ahead");
        assert_eq!((record.t, record.front_face), (0.5, true));
    }

    fn for_flat_and_nested_lists(law: fn(&list::Search, &World) -> Verdict) {
        holds(&worlds(), |world| law(&flat, world));
        holds(&worlds(), |world| law(&nested, world));
    }

    fn flat(world: &World) -> Option<f64> {
        let mut list = HittableList::default();
        for &(center, radius) in &world.spheres {
            list.add(Sphere::new(center, radius));
        }
        nearest(&list, world)
    }

    /// Each sphere in a list with all that follow it.
    fn nested(world: &World) -> Option<f64> {
        let mut list = HittableList::default();
        for &(center, radius) in world.spheres.iter().rev() {
            let mut outer = HittableList::default();
            outer.add(Sphere::new(center, radius));
            outer.add(list);
            list = outer;
        }
        nearest(&list, world)
    }

    fn nearest(thing: &dyn Hittable, world: &World) -> Option<f64> {
        thing
            .hit(&world.ray, world.t_min, world.t_max)
            .map(|hit| hit.t)
    }
}

mod every_chapter {
    use super::*;

    #[test]
    fn solves_the_cases_that_were_once_special() {
        for case in regressions() {
            runner::one_case(&::normals::hit_sphere, &case);
            runner::one_case(&::half_b_sphere::hit_sphere, &case);
            runner::one_case(&hittable_list_sphere::nearer, &case);
        }
    }

    /// What the chapters say to input that is no ray or no sphere. None of it
    /// is checked for: a scene has no such things.
    #[test]
    fn answers_nonsense_without_a_panic() {
        let ahead = Ray::new(Point3::ZERO, Vec3::NEG_Z);
        let center = Point3::new(0.0, 0.0, -1.0);
        let nowhere = Ray::new(Point3::ZERO, Vec3::ZERO);
        let lost = Ray::new(Point3::new(f64::NAN, 0.0, 0.0), Vec3::NEG_Z);
        let endless = Ray::new(Point3::ZERO, Vec3::new(0.0, 0.0, f64::NEG_INFINITY));
        let too_long = Ray::new(Point3::ZERO, Vec3::new(0.0, 0.0, -1e200));

        // A discriminant of NaN is not negative, so chapters 3 and 4 go on and
        // return NaN. Their `t > 0.0` then draws the sky.
        for (ray, radius) in [
            (nowhere, 0.5),
            (lost, 0.5),
            (endless, 0.5),
            (too_long, 0.5),
            (ahead, f64::NAN),
        ] {
            for hit_sphere in [::normals::hit_sphere, ::half_b_sphere::hit_sphere] {
                let t = hit_sphere(center, radius, &ray).expect("a root, of a kind");
                assert!(t.is_nan(), "{t} for {ray:?} and radius {radius}");
            }
        }
        // To chapter 2 a NaN is a miss, a direction of zero is a hit.
        assert!(!::red_sphere::hit_sphere(center, 0.5, &lost));
        assert!(!::red_sphere::hit_sphere(center, 0.5, &endless));
        assert!(!::red_sphere::hit_sphere(center, 0.5, &too_long));
        assert!(!::red_sphere::hit_sphere(center, f64::NAN, &ahead));
        assert!(::red_sphere::hit_sphere(center, 0.5, &nowhere));

        // Chapter 5 asks whether t lies in the range, and NaN lies in none.
        let sphere = Sphere::new(center, 0.5);
        for ray in [nowhere, lost, endless, too_long] {
            assert_eq!(sphere.hit(&ray, 0.0, f64::INFINITY), None);
        }
        assert_eq!(sphere.hit(&ahead, f64::NAN, f64::INFINITY), None);
        assert_eq!(sphere.hit(&ahead, 0.0, f64::NAN), None);
        // A radius that is negative or NaN counts as 0, as in the book.
        for radius in [-1.0, f64::NAN] {
            assert_eq!(Sphere::new(center, radius), Sphere::new(center, 0.0));
        }
        // A sphere without end contains every ray, and its surface is nowhere.
        assert_eq!(
            Sphere::new(center, f64::INFINITY).hit(&ahead, 0.0, f64::INFINITY),
            None
        );
    }

    fn regressions() -> Vec<Case> {
        include_str!("regressions.txt")
            .lines()
            .filter(|line| !line.is_empty() && !line.starts_with('#'))
            .map(|line| {
                let numbers: Vec<f64> = line
                    .split_whitespace()
                    .map(|number| number.parse().expect("regressions.txt holds numbers"))
                    .collect();
                let numbers = numbers.try_into().expect("a case is ten numbers");
                Case::from_numbers(numbers)
            })
            .collect()
    }
}
