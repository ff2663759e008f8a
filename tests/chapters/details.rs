//! What the chapters promise beside their laws: copies that agree to the last bit,
//! answers to nonsense, and the small print of chapter 5.

use common::rtweekend::*;
use hittable_list::{HitRecord, Hittable, HittableList, Sphere};
use laws::runner::holds;
use laws::{nearer_root, strategies};

#[test]
fn chapter_2_hits_exactly_when_chapter_3_has_a_root() {
    holds(&strategies::anywhere(), |case| {
        let decide =
            |center, radius, ray: &Ray| red_sphere::hit_sphere(center, radius, ray).then_some(0.0);
        nearer_root::it_hits_exactly_when_the_other_does(&decide, &normals::hit_sphere, case)
    });
}

#[test]
fn half_b_is_the_full_formula_to_the_last_bit() {
    holds(&strategies::anywhere(), |case| {
        nearer_root::two_chapters_agree_to_the_last_bit(
            &half_b_sphere::hit_sphere,
            &normals::hit_sphere,
            case,
        )
    });
}

#[test]
fn the_sphere_of_chapter_5_is_the_half_b_of_chapter_4_to_the_last_bit() {
    // On the whole line, the nearest root is the nearer one.
    let nearer = |center, radius, ray: &Ray| {
        let sphere = Sphere::new(center, radius);
        let hit = sphere.hit(ray, f64::NEG_INFINITY, f64::INFINITY);
        hit.map(|hit| hit.t)
    };
    holds(&strategies::anywhere(), |case| {
        nearer_root::two_chapters_agree_to_the_last_bit(&nearer, &half_b_sphere::hit_sphere, case)
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

/// What the chapters say to input that is no ray or no sphere. None of it
/// is checked for: a scene has no such things.
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
