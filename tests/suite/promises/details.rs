//! Promises of the chapters beside their laws: copies that agree to the last bit,
//! answers to nonsense, and the small print of chapter 5.

use common::rtweekend::*;
use hittable_list::{HitRecord, Hittable, HittableList, Sphere};
use laws::list::World;
use laws::{config, strategies};
use proptest::prelude::*;

proptest! {
    #![proptest_config(config())]

    /// Equal discriminants have equal signs, even where rounding decides. The sign of the
    /// radius does not matter.
    #[test]
    fn chapter_2_hits_exactly_when_chapter_3_has_a_root(case in strategies::any_case()) {
        let is_hit = red_sphere::hit_sphere(case.center, -case.radius, &case.ray);
        prop_assert_eq!(is_hit, case.solve(&normals::hit_sphere).is_some(), "{}", case);
    }

    /// The factors 2 and 4 that half-b leaves out are powers of two: they never round. And on
    /// the whole line, the nearest root of chapter 5 is the nearer one.
    #[test]
    fn chapters_3_to_5_find_the_same_root_to_the_last_bit(case in strategies::any_case()) {
        prop_assume!(case.is_well_scaled());
        let full = case.solve(&normals::hit_sphere);
        prop_assert_eq!(case.solve(&half_b_sphere::hit_sphere), full, "{}", case);
        let sphere = Sphere::new(case.center, case.radius);
        let hit = sphere.hit(&case.ray, f64::NEG_INFINITY, f64::INFINITY);
        prop_assert_eq!(hit.map(|hit| hit.t), full, "{}", case);
    }

    /// Each sphere lies in a list with the list of all that follow it.
    #[test]
    fn a_list_in_a_list_is_no_different(world in strategies::worlds()) {
        let nested = world.spheres.iter().rfold(HittableList::default(), |inner, &sphere| {
            let mut outer = list(&[sphere]);
            outer.add(inner);
            outer
        });
        prop_assert_eq!(nearest(&nested, &world), nearest(&list(&world.spheres), &world));
    }
}

fn list(spheres: &[(Point3, f64)]) -> HittableList {
    let mut list = HittableList::default();
    for &(center, radius) in spheres {
        list.add(Sphere::new(center, radius));
    }
    list
}

fn nearest(list: &HittableList, world: &World) -> Option<f64> {
    let hit = list.hit(&world.ray, world.t_min, world.t_max);
    hit.map(|hit| hit.t)
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

/// The book multiplies by 1/radius, and 49 · (1/49) is not 1.
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
fn an_empty_list_is_missed() {
    let empty = HittableList::default();
    let ahead = Ray::new(Point3::ZERO, Vec3::NEG_Z);
    assert_eq!(empty.hit(&ahead, f64::NEG_INFINITY, f64::INFINITY), None);
}

#[test]
fn of_two_that_are_equally_near_the_first_is_hit() {
    let mut list = HittableList::default();
    list.add(Sphere::new(Point3::NEG_Z, 0.5));
    // The ray starts inside this one.
    list.add(Sphere::new(Point3::new(0.0, 0.0, 0.5), 1.0));
    let ahead = Ray::new(Point3::ZERO, Vec3::NEG_Z);
    let nearest = list.hit(&ahead, 0.0, f64::INFINITY);
    let record = nearest.expect("both are ahead");
    assert_eq!((record.t, record.front_face), (0.5, true));
}

/// No chapter checks its input: a scene has no such rays or spheres.
#[test]
fn nonsense_is_answered_without_a_panic() {
    let (center, ahead) = (Point3::NEG_Z, Ray::new(Point3::ZERO, Vec3::NEG_Z));
    let along = |direction| Ray::new(Point3::ZERO, direction);
    let nowhere = along(Vec3::ZERO);
    let lost = Ray::new(Point3::new(f64::NAN, 0.0, 0.0), Vec3::NEG_Z);
    let endless = along(Vec3::new(0.0, 0.0, f64::NEG_INFINITY));
    let too_long = along(Vec3::new(0.0, 0.0, -1e200));

    // A discriminant of NaN is not negative, so chapters 3 and 4 go on and return NaN,
    // for which their `t > 0.0` draws the sky. To chapter 2 it is a miss, and to chapter 5
    // it lies in no range. A direction of zero has a discriminant of zero.
    for (ray, radius, is_hit) in [
        (nowhere, 0.5, true),
        (lost, 0.5, false),
        (endless, 0.5, false),
        (too_long, 0.5, false),
        (ahead, f64::NAN, false),
    ] {
        for hit_sphere in [normals::hit_sphere, half_b_sphere::hit_sphere] {
            let t = hit_sphere(center, radius, &ray).expect("a root, of a kind");
            assert!(t.is_nan(), "{t} for {ray:?} and radius {radius}");
        }
        assert_eq!(red_sphere::hit_sphere(center, radius, &ray), is_hit);
    }
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
    let endless = Sphere::new(center, f64::INFINITY);
    assert_eq!(endless.hit(&ahead, 0.0, f64::INFINITY), None);
}
