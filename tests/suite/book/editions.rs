//! Editions of the book: the signs of two of them, and what becomes of every mixture.
//!
//! The page `book/notes/editions.md` says what these tests confirm.

use common::rtweekend::*;
use laws::Case;
use laws::strategies::{self, samples};
use slips::{Chapter, ChapterProgram};

use fixtures::slip;

/// Finds the nearer root with half of b as version 3 of the book does.
fn hit_sphere_of_version_3(center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
    let oc = ray.origin - center;
    let a = ray.direction.length_squared();
    let half_b = oc.dot(ray.direction);
    let c = oc.length_squared() - radius * radius;
    let discriminant = half_b * half_b - a * c;
    if discriminant < 0.0 {
        return None;
    }
    Some((-half_b - discriminant.sqrt()) / a)
}

#[test]
fn both_versions_find_the_same_root() {
    for case in cases() {
        let version_3 = case.solve(&hit_sphere_of_version_3);
        let version_4 = case.solve(&half_b_sphere::hit_sphere);
        assert_eq!(version_3, version_4);
    }
}

/// Zeros are equal whatever their sign, so no comparison with t sees the sign.
#[test]
fn only_the_sign_of_a_zero_tells_the_versions_apart() {
    let bits = |t: Option<f64>| t.map(f64::to_bits);
    for case in cases() {
        let version_3 = case.solve(&hit_sphere_of_version_3);
        let version_4 = case.solve(&half_b_sphere::hit_sphere);
        assert!(bits(version_3) == bits(version_4) || version_4 == Some(0.0));
    }

    // A ray that begins where it touches the sphere: h = 0 and c = 0.
    let touching = Ray::new(Point3::ZERO, Vec3::X);
    let version_3 = hit_sphere_of_version_3(Point3::Y, 1.0, &touching);
    let version_4 = half_b_sphere::hit_sphere(Point3::Y, 1.0, &touching);
    assert_eq!(bits(version_3), bits(Some(-0.0)));
    assert_eq!(bits(version_4), bits(Some(0.0)));
}

/// An even number of turned signs cancels. An odd one traces the ray backwards.
#[test]
fn every_mixture_finds_the_root_of_the_ray_or_of_the_ray_turned_round() {
    for (chapter, signs) in SIGNS {
        for turned in subsets(signs) {
            let program = with_slips(chapter, &turned);
            for case in cases() {
                let found = case.solve(&|c, r, ray: &Ray| program.hit_sphere(c, r, ray));
                let way = if turned.len() % 2 == 0 { 1.0 } else { -1.0 };
                let asked = case.with_ray(case.ray.origin, way * case.ray.direction);
                let expected = asked.solve(&half_b_sphere::hit_sphere);
                assert_eq!(found, expected, "{turned:?} in {chapter:?}: {case}");
            }
        }
    }
}

#[test]
fn in_chapter_5_one_turned_sign_hangs_the_ground_in_the_sky() {
    cancel_each_other("minus-h", "oc-reversed", 128);
}

#[test]
fn rows_from_below_and_an_edge_that_points_up_belong_together() {
    cancel_each_other("rows-from-below", "viewport-upside-down", 100);
}

/// Panics unless each of the two slips draws the same wrong picture of chapter 5, and both the
/// right one.
fn cancel_each_other(one: &str, other: &str, width: u32) {
    let draw = |names: &[&str]| {
        with_slips(Chapter::HittableList, names)
            .run(width)
            .picture()
    };
    let right = hittable_list::picture(width);
    assert_ne!(draw(&[one]), right);
    assert_eq!(draw(&[one]), draw(&[other]));
    assert_eq!(draw(&[one, other]), right);
}

/// The slips that turn a sign, in each chapter that has one to turn.
const SIGNS: [(Chapter, &[&str]); 2] = [
    (Chapter::Normals, &["oc-reversed", "b-sign", "plus-b"]),
    (Chapter::HalfBSphere, &["oc-reversed", "minus-h"]),
];

/// Returns rays and spheres whose numbers overflow nowhere on the way.
fn cases() -> impl Iterator<Item = Case> {
    let all = samples(&strategies::any_case(), 300);
    all.into_iter().filter(Case::is_well_scaled)
}

/// Makes these slips in the right program of the chapter.
fn with_slips(chapter: Chapter, names: &[&str]) -> ChapterProgram {
    let make = |program, name: &&str| slip(name).applied_to(&program);
    names.iter().fold(ChapterProgram::right(chapter), make)
}

/// Lists every choice of some of the names, none and all of them included.
fn subsets<'a>(names: &[&'a str]) -> Vec<Vec<&'a str>> {
    names.iter().fold(vec![Vec::new()], |chosen, name| {
        let with_name = chosen.iter().map(|names| {
            let names = names.iter().chain([name]);
            names.copied().collect()
        });
        with_name.chain(chosen.clone()).collect()
    })
}
