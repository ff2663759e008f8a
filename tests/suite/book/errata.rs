//! What the notes or the book say that is not so, and what is so instead.
//!
//! The page `book/notes/errata.md` shows these tests beside its sentences.

use check::comparison::differing_pixels;
use common::rtweekend::*;
use hittable_list::{HitRecord, Hittable, Sphere};
use laws::{sampling, strategies};
use slips::Chapter;

use suite::slip;

#[test]
fn the_second_listing_of_the_notes_finds_minus_the_far_root() {
    let (center, radius) = (Point3::NEG_Z, 0.5);
    let ahead = Ray::new(Point3::ZERO, Vec3::NEG_Z);
    let notes = slip("minus-h").program(Chapter::HalfBSphere);

    let right = half_b_sphere::hit_sphere(center, radius, &ahead);
    assert_eq!(right, Some(0.5));
    assert_eq!(notes.hit_sphere(center, radius, &ahead), Some(-1.5));
}

#[test]
fn the_second_listing_of_the_notes_draws_the_plain_gradient() {
    let notes = slip("minus-h").program(Chapter::HalfBSphere);
    assert_eq!(notes.run(400).picture(), gradient::picture(400));
}

#[test]
fn equation_5_holds_for_every_point_and_equation_6_on_the_sphere_only() {
    let (center, radius) = (Point3::new(0.0, 0.0, -1.0), 0.5);
    let on_it = Point3::new(0.0, 0.5, -1.0);
    let elsewhere = Point3::new(3.0, -2.0, 7.0);
    for point in [on_it, elsewhere] {
        let [x, y, z] = (center - point).to_array();
        let dot = (center - point).dot(center - point);
        assert_eq!(dot, x * x + y * y + z * z);
        assert_eq!(dot == radius * radius, point == on_it);
    }
}

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
fn the_height_is_rounded_down_and_not_to_the_nearest_integer() {
    assert_eq!(Camera::new(401).image_height, 225);
    assert_eq!((401.0_f64 / (16.0 / 9.0)).round(), 226.0);

    let differs = |width: &u32| {
        let nearest = (f64::from(*width) / (16.0 / 9.0)).round();
        f64::from(Camera::new(*width).image_height) != nearest
    };
    assert_eq!((1..=2000).filter(differs).count(), 999);
}

#[test]
fn the_real_ratio_is_16_to_9_at_every_sixteenth_width_and_above_it_elsewhere() {
    // At a width of 1 the height is not rounded down, but kept at 1.
    for width in 2..=2000 {
        let Camera { image_height, .. } = Camera::new(width);
        let (ideal, real) = (16 * image_height, 9 * width);
        assert_eq!(real == ideal, width % 16 == 0, "width {width}");
        assert!(real >= ideal, "width {width}");
    }
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
fn rows_run_downwards_while_y_points_up() {
    let camera = Camera::new(400);
    let height = |row| camera.ray(0, row).direction.y;
    assert!(height(0) > 0.0);
    assert!(height(224) < 0.0);
    assert!((0..224).all(|row| height(row) > height(row + 1)));
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
fn the_weight_of_blue_goes_from_0_147_to_0_853_in_the_picture() {
    let camera = Camera::new(400);
    let weight = |(i, j)| 0.5 * (camera.ray(i, j).direction.normalize().y + 1.0);
    let pixels = (0..225).flat_map(|j| (0..400).map(move |i| (i, j)));
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for a in pixels.map(weight) {
        (least, most) = (a.min(least), a.max(most));
    }
    assert_eq!(format!("{least:.3} to {most:.3}"), "0.147 to 0.853");
}

#[test]
fn three_vectors_dotted_by_three_vectors_are_nine_numbers() {
    let terms = [
        Vec3::new(1.0, 2.0, 3.0),
        Vec3::new(-4.0, 5.0, 6.0),
        Vec3::new(7.0, -8.0, 9.0),
    ];
    let nine = terms.iter().flat_map(|u| terms.iter().map(|v| u.dot(*v)));
    let whole: Vec3 = terms.iter().sum();
    assert_eq!(nine.clone().count(), 9);
    assert_eq!(nine.sum::<f64>(), whole.dot(whole));
}

#[test]
fn a_sphere_behind_the_camera_is_drawn_in_chapter_2_and_not_in_chapter_3() {
    let behind = slip("sphere-at-plus-one");
    let drawn = |chapter| behind.program(chapter).run(400).picture();
    assert_eq!(drawn(Chapter::RedSphere), red_sphere::picture(400));
    assert_eq!(drawn(Chapter::Normals), gradient::picture(400));
}

#[test]
fn from_inside_a_sphere_the_smallest_root_is_not_the_one_that_is_seen() {
    let (center, radius) = (Point3::new(0.0, 0.0, -1.0), 2.0);
    let ahead = Ray::new(Point3::ZERO, Vec3::NEG_Z);

    let smallest = half_b_sphere::hit_sphere(center, radius, &ahead);
    assert_eq!(smallest, Some(-1.0));
    let sphere = Sphere::new(center, radius);
    let seen = sphere.hit(&ahead, 0.0, f64::INFINITY);
    assert_eq!(seen.map(|hit| hit.t), Some(3.0));
}

/// From 10ᵏ radii away, t is wrong by about 10ᵏ⁺ᵏ⁻¹⁶ radii: so far is the point
/// from the sphere, and the length of its normal from 1.
#[test]
fn dividing_by_the_radius_makes_a_unit_vector_of_a_point_that_is_on_the_sphere() {
    assert!(worst_length_of_a_normal(1.0) < 1e-12);
    assert!((1e-10..1e-6).contains(&worst_length_of_a_normal(4.0)));
    assert!(worst_length_of_a_normal(8.0) > 0.1);
}

/// How far a normal's length is from 1, on a sphere 10ᵏ radii away.
fn worst_length_of_a_normal(k: f64) -> f64 {
    let cases = sampling::samples(&strategies::far(k..=k), 200);
    let errors = cases.iter().filter_map(|case| {
        let sphere = Sphere::new(case.center, case.radius);
        let record = sphere.hit(&case.ray, 0.0, f64::INFINITY)?;
        Some((record.normal.length() - 1.0).abs())
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn a_negative_radius_counts_as_zero() {
    let center = Point3::NEG_Z;
    assert_eq!(Sphere::new(center, -0.5), Sphere::new(center, 0.0));
}

#[test]
fn a_ray_at_a_right_angle_is_inside_for_the_code_and_outside_for_the_words() {
    let (ray, outward_normal) = (Ray::new(Point3::ZERO, Vec3::X), Vec3::Y);
    let mut record = HitRecord {
        front_face: true,
        ..HitRecord::default()
    };
    record.set_face_normal(&ray, outward_normal);
    let inside_for_the_code = !record.front_face;
    let inside_for_the_words = ray.direction.dot(outward_normal) > 0.0;
    assert!(inside_for_the_code && !inside_for_the_words);
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
