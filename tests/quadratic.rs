//! What each chapter's intersection promises, and where its promise ends.

use common::rtweekend::*;
use hittable_list::{Hittable, HittableList, Sphere};
use proptest::prelude::*;

fn point() -> impl Strategy<Value = Point3> {
    let coordinate = || -10.0..10.0;
    (coordinate(), coordinate(), coordinate()).prop_map(|(x, y, z)| Point3::new(x, y, z))
}

proptest! {
    #[test]
    fn half_b_is_the_full_formula_to_the_last_bit(
        center in point(), radius in 0.0..10.0, origin in point(), direction in point(),
    ) {
        let ray = Ray::new(origin, direction);
        let full = normals::hit_sphere(center, radius, &ray);
        let half = half_b_sphere::hit_sphere(center, radius, &ray);
        prop_assert_eq!(full.map(f64::to_bits), half.map(f64::to_bits));
    }

    #[test]
    fn the_red_sphere_is_hit_exactly_when_there_is_a_root(
        center in point(), radius in 0.0..10.0, origin in point(), direction in point(),
    ) {
        let ray = Ray::new(origin, direction);
        prop_assert_eq!(
            red_sphere::hit_sphere(center, radius, &ray),
            normals::hit_sphere(center, radius, &ray).is_some()
        );
    }
}

/// A ray along the axis of the scene: every number below is exact.
fn ahead() -> Ray {
    Ray::new(Point3::ZERO, Vec3::new(0.0, 0.0, -1.0))
}

const IN_FRONT: Point3 = Point3::new(0.0, 0.0, -1.0);
const BEHIND: Point3 = Point3::new(0.0, 0.0, 1.0);

#[test]
fn the_nearer_root_is_half_a_unit_away() {
    assert_eq!(normals::hit_sphere(IN_FRONT, 0.5, &ahead()), Some(0.5));
    assert_eq!(
        half_b_sphere::hit_sphere(IN_FRONT, 0.5, &ahead()),
        Some(0.5)
    );
}

#[test]
fn chapter_2_cannot_tell_a_sphere_behind_the_camera_from_one_in_front() {
    let camera = Camera::new(64);
    for j in 0..camera.image_height {
        for i in 0..camera.image_width {
            let ray = camera.ray(i, j);
            assert_eq!(
                red_sphere::hit_sphere(IN_FRONT, 0.5, &ray),
                red_sphere::hit_sphere(BEHIND, 0.5, &ray),
                "column {i}, row {j}"
            );
        }
    }
}

#[test]
fn from_chapter_3_on_a_sphere_behind_the_camera_has_a_negative_root() {
    assert_eq!(normals::hit_sphere(BEHIND, 0.5, &ahead()), Some(-1.5));
    assert_eq!(half_b_sphere::hit_sphere(BEHIND, 0.5, &ahead()), Some(-1.5));
    assert_eq!(nearest(&Sphere::new(BEHIND, 0.5), &ahead()), None);
}

#[test]
fn from_inside_only_chapter_5_finds_the_root_ahead() {
    assert_eq!(normals::hit_sphere(Point3::ZERO, 2.0, &ahead()), Some(-2.0));
    assert_eq!(
        nearest(&Sphere::new(Point3::ZERO, 2.0), &ahead()),
        Some(2.0)
    );
}

#[test]
fn a_tangent_is_a_hit() {
    let beside = Ray::new(Point3::new(0.5, 0.0, 0.0), Vec3::new(0.0, 0.0, -1.0));
    assert!(red_sphere::hit_sphere(IN_FRONT, 0.5, &beside));
    assert_eq!(normals::hit_sphere(IN_FRONT, 0.5, &beside), Some(1.0));
    assert_eq!(half_b_sphere::hit_sphere(IN_FRONT, 0.5, &beside), Some(1.0));
    assert_eq!(nearest(&Sphere::new(IN_FRONT, 0.5), &beside), Some(1.0));
}

#[test]
fn both_ends_of_the_interval_are_left_out() {
    let sphere = Sphere::new(IN_FRONT, 0.5);
    let hit = |t_min, t_max| sphere.hit(&ahead(), t_min, t_max).map(|hit| hit.t);
    assert_eq!(hit(0.0, 0.5), None);
    assert_eq!(hit(0.5, 1.5), None);
    assert_eq!(hit(0.5, 2.0), Some(1.5));
    assert_eq!(hit(0.0, 0.5_f64.next_up()), Some(0.5));
}

#[test]
fn the_normal_points_against_the_ray_on_either_side() {
    for (center, front_face) in [(IN_FRONT, true), (Point3::ZERO, false)] {
        let sphere = Sphere::new(center, 0.5);
        let hit = sphere
            .hit(&ahead(), 0.0, f64::INFINITY)
            .expect("the sphere is ahead");
        let record = hit.record(&ahead());
        assert_eq!(record.front_face, front_face);
        assert_eq!(record.point, Point3::new(0.0, 0.0, -0.5));
        assert_eq!(record.normal, Vec3::new(0.0, 0.0, 1.0));
    }
}

#[test]
fn the_nearest_of_a_list_wins_in_any_order() {
    let far = Sphere::new(Point3::new(0.0, 0.0, -5.0), 0.5);
    let near = Sphere::new(IN_FRONT, 0.5);
    for order in [[far, near], [near, far]] {
        let mut list = HittableList::default();
        let mut nested = HittableList::default();
        for sphere in order {
            list.add(sphere);
            let mut inner = HittableList::default();
            inner.add(sphere);
            nested.add(inner);
        }
        assert_eq!(nearest(&list, &ahead()), Some(0.5));
        assert_eq!(nearest(&nested, &ahead()), Some(0.5));
    }
}

#[test]
fn an_empty_list_is_missed() {
    assert_eq!(nearest(&HittableList::default(), &ahead()), None);
}

#[test]
fn a_negative_radius_counts_as_zero() {
    let point = Sphere::new(IN_FRONT, -1.0);
    assert_eq!(point, Sphere::new(IN_FRONT, 0.0));
}

fn nearest(thing: &dyn Hittable, ray: &Ray) -> Option<f64> {
    thing.hit(ray, 0.0, f64::INFINITY).map(|hit| hit.t)
}
