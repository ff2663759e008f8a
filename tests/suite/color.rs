//! What a ray returns, and what becomes of it in a picture.

use common::rtweekend::*;

#[test]
fn colors_are_cut_off_not_rounded_and_stay_in_range() {
    let levels = [
        (0.0, 0),
        (0.5, 127),
        (0.9999, 255),
        (1.0, 255),
        (1.5, 255),
        (-0.1, 0),
        (f64::NAN, 0),
    ];
    for (component, level) in levels {
        let mut pixel = [7; 3];
        write_color(&mut pixel, Color::splat(component));
        assert_eq!(pixel, [level; 3], "for {component}");
    }
}

#[test]
fn red_green_and_blue_are_stored_in_this_order() {
    let mut pixel = [0; 3];
    write_color(&mut pixel, Color::new(0.1, 0.2, 0.3));
    assert_eq!(pixel, [25, 51, 76]);
}

#[test]
fn the_sky_is_white_straight_down_blue_straight_up_and_half_way_between() {
    for sky in [sky, gradient::ray_color] {
        let towards = |y: f64, z: f64| sky(&Ray::new(Point3::ZERO, Vec3::new(0.0, y, z)));
        assert_eq!(towards(-3.0, 0.0), Color::new(1.0, 1.0, 1.0));
        assert_eq!(towards(2.0, 0.0), Color::new(0.5, 0.7, 1.0));
        assert_eq!(towards(0.0, -1.0), Color::new(0.75, 0.85, 1.0));
    }
}

/// To the bit: the eight bits of a picture would hide another formula.
#[test]
fn the_sky_is_the_books_formula_for_a_direction_and_not_for_a_place() {
    let camera = Camera::new(31);
    for j in 0..camera.image_height {
        for i in 0..camera.image_width {
            let direction = camera.ray(i, j).direction;
            let reciprocal = 1.0 / direction.length();
            let a = 0.5 * (direction.y * reciprocal + 1.0);
            let expected = [0.5, 0.7, 1.0].map(|blue| (1.0 - a) * 1.0 + a * blue);
            for origin in [Point3::ZERO, Point3::new(3.0, -5.0, 7.0)] {
                let ray = Ray::new(origin, direction);
                assert_eq!(sky(&ray).to_array(), expected, "column {i}, row {j}");
                assert_eq!(gradient::ray_color(&ray).to_array(), expected);
            }
        }
    }
}

#[test]
fn a_build_test_of_one_pixel_is_black() {
    assert_eq!(build_test::picture(1).rgb(), [0, 0, 0]);
    assert_eq!(
        build_test::picture(2).rgb(),
        [0, 0, 0, 255, 0, 0, 0, 255, 0, 255, 255, 0]
    );
}

/// A color is (n + 1) / 2, so n can be read from it up to two roundings.
#[test]
fn normals_have_length_one_and_point_against_the_ray() {
    let camera = Camera::new(60);
    let world = hittable_list::world();
    for j in 0..camera.image_height {
        for i in 0..camera.image_width {
            let ray = camera.ray(i, j);
            let colors = [
                normals::ray_color(&ray),
                half_b_sphere::ray_color(&ray),
                hittable_list::ray_color(&ray, &world),
            ];
            for color in colors.into_iter().filter(|&color| color != sky(&ray)) {
                let normal = 2.0 * color - Vec3::ONE;
                let off = (normal.length() - 1.0).abs();
                assert!(off <= 8.0 * f64::EPSILON, "column {i}, row {j}: {off:e}");
                let along = ray.direction.dot(normal);
                assert!(along < 0.0, "column {i}, row {j}: d·n = {along}");
            }
        }
    }
}

/// The sphere of chapters 2 to 4 is at z = −1; these rays start beyond it.
#[test]
fn from_chapter_3_on_a_sphere_behind_the_ray_is_not_drawn() {
    let away = Ray::new(Point3::new(0.0, 0.0, -3.0), Vec3::new(0.0, 0.25, -1.0));
    assert_eq!(red_sphere::ray_color(&away), Color::new(1.0, 0.0, 0.0));
    assert_eq!(normals::ray_color(&away), sky(&away));
    assert_eq!(half_b_sphere::ray_color(&away), sky(&away));
    assert_eq!(
        hittable_list::ray_color(&away, &hittable_list::world()),
        sky(&away)
    );
}

/// A ray from the surface itself has its nearer root at t = 0, exactly.
#[test]
fn a_sphere_that_the_ray_touches_only_at_its_origin_is_not_drawn() {
    let away = Ray::new(Point3::new(0.0, 0.0, -0.5), Vec3::new(0.0, 0.0, 1.0));
    for hit_sphere in [normals::hit_sphere, half_b_sphere::hit_sphere] {
        let behind = hit_sphere(Point3::new(0.0, 0.0, -1.0), 0.5, &away);
        assert_eq!(behind, Some(-1.0), "the nearer root is the far side");
    }
    assert_eq!(
        hittable_list::ray_color(&away, &hittable_list::world()),
        sky(&away)
    );

    let in_front = Ray::new(Point3::new(0.0, 0.0, -0.5), Vec3::new(0.0, 0.0, -1.0));
    assert_eq!(normals::ray_color(&in_front), sky(&in_front));
    assert_eq!(half_b_sphere::ray_color(&in_front), sky(&in_front));
}

/// However near or far: the range of t starts at 0, not at 0.001, and has no end.
/// The rays are oblique, so that near and far side have other normals.
#[test]
fn what_is_close_to_the_eye_or_far_from_it_is_drawn() {
    let world = hittable_list::world();
    let towards = Vec3::new(0.1, -0.2, -1.0);
    let on_the_surface = Point3::new(0.0, 0.0, -0.5);
    for t in [1e-9, 1e-4, 0.01, 1e5] {
        let ray = Ray::new(on_the_surface - t * towards, towards);
        // The normal there is (0, 0, 1). From 1e5 away t has four digits less.
        let expected = Color::new(0.5, 0.5, 1.0);
        for color in [
            normals::ray_color(&ray),
            half_b_sphere::ray_color(&ray),
            hittable_list::ray_color(&ray, &world),
        ] {
            assert!(
                (color - expected).abs().max_element() < 1e-4,
                "{color} from {t} directions away, where {expected} is right"
            );
        }
    }
}

/// P(t) − C needs the origin of the ray in P. At the book's eye that is 0.
#[test]
fn a_moved_eye_sees_the_same_normals_in_chapters_3_to_5() {
    let ray = Ray::new(Point3::new(0.3, 0.2, 2.0), Vec3::new(-0.05, -0.1, -1.0));
    let color = normals::ray_color(&ray);
    let normal = 2.0 * color - Vec3::ONE;
    // The point that has this normal lies on the ray.
    let point = Point3::new(0.0, 0.0, -1.0) + 0.5 * normal;
    let t = (point - ray.origin).z / ray.direction.z;
    assert!(
        (ray.at(t) - point).length() < 1e-12,
        "{point} is not on {ray:?}"
    );
    assert_eq!(half_b_sphere::ray_color(&ray), color);
    let in_a_list = hittable_list::ray_color(&ray, &hittable_list::world());
    assert!((in_a_list - color).length() < 1e-12);
}
