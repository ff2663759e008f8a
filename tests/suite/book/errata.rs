//! Errata: sentences of the notes or the book that are not so, and the facts instead.
//!
//! The page `book/notes/errata.md` shows some of these tests beside its sentences.

use common::rtweekend::*;
use difference::differing_pixels;
use hittable_list::{Hittable, Sphere};
use slips::{Chapter, ChapterCode};

use fixtures::slip;

#[test]
fn two_real_roots_may_both_lie_behind_the_ray() {
    let behind = Point3::new(0.0, 0.0, 1.0);
    let ahead = Ray::new(Point3::ZERO, Vec3::NEG_Z);

    assert!(red_sphere::hit_sphere(behind, 0.5, &ahead));
    assert_eq!(normals::hit_sphere(behind, 0.5, &ahead), Some(-1.5));
    // The farther root is the nearer one of the ray turned round, negated.
    let turned = Ray::new(Point3::ZERO, Vec3::Z);
    assert_eq!(normals::hit_sphere(behind, 0.5, &turned), Some(0.5));
}

#[test]
fn a_ratio_typed_as_1_7778_loses_a_row() {
    let height = |aspect_ratio: f64| (400.0 / aspect_ratio) as u32;
    assert_eq!(height(16.0 / 9.0), 225);
    assert_eq!(height(1.7778), 224);
}

#[test]
fn a_square_picture_hides_what_a_wide_one_shows() {
    let swapped = slip("header-swapped");
    let draws_the_right_picture = |chapter: Chapter| {
        let right = chapter.picture(256);
        swapped.program(chapter).run(256).picture() == right
    };
    assert!(draws_the_right_picture(Chapter::BuildTest));
    assert!(!draws_the_right_picture(Chapter::Gradient));
}

#[test]
fn without_the_half_pixel_a_fifth_of_the_gradient_changes() {
    let right = gradient::picture(400);
    let wrong = slip("grid-not-inset").program(Chapter::Gradient);
    let wrong = wrong.run(400).picture();
    assert_eq!(differing_pixels(&right, &wrong).count(), 20_778);
    let mut levels = right.rgb().iter().zip(wrong.rgb());
    assert!(levels.all(|(r, w)| r.abs_diff(*w) <= 1));
}

#[test]
fn a_sphere_behind_the_camera_is_drawn_in_chapter_2_and_not_in_chapter_3() {
    let behind = slip("sphere-at-plus-one");
    let drawn = |chapter| behind.program(chapter).run(400).picture();
    assert_eq!(drawn(Chapter::RedSphere), red_sphere::picture(400));
    assert_eq!(drawn(Chapter::Normals), gradient::picture(400));
}

#[test]
fn a_negative_radius_counts_as_zero() {
    let center = Point3::NEG_Z;
    assert_eq!(Sphere::new(center, -0.5), Sphere::new(center, 0.0));
}

#[test]
fn the_build_test_reaches_its_edge_and_the_camera_stays_half_a_pixel_inside() {
    let build_test = build_test::picture(256);
    let (pixels, _) = build_test.rgb().as_chunks::<3>();
    assert_eq!(pixels[255], [255, 0, 0]);

    let camera = Camera::with_size(256, 256);
    let half_a_pixel = 0.5 * camera.pixel_delta_u.x;
    let right_edge = 1.0;
    let last = camera.ray(255, 0).direction.x;
    assert_eq!(last, right_edge - half_a_pixel);
}

#[test]
fn a_root_at_the_very_start_of_the_interval_is_no_hit() {
    let sphere = Sphere::new(Point3::NEG_Z, 0.5);
    let on_the_surface = Ray::new(Point3::new(0.0, 0.0, -0.5), Vec3::NEG_Z);
    let hit = sphere.hit(&on_the_surface, 0.0, f64::INFINITY);
    assert_eq!(hit.map(|hit| hit.t), Some(1.0));
}
