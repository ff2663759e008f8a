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
    let towards = |y: f64, z: f64| sky(&Ray::new(Point3::ZERO, Vec3::new(0.0, y, z)));
    assert_eq!(towards(-3.0, 0.0), Color::new(1.0, 1.0, 1.0));
    assert_eq!(towards(2.0, 0.0), Color::new(0.5, 0.7, 1.0));
    assert_eq!(towards(0.0, -1.0), Color::new(0.75, 0.85, 1.0));
}

#[test]
fn the_sky_of_the_prelude_is_the_gradient_of_chapter_1() {
    let camera = Camera::new(31);
    for j in 0..camera.image_height {
        for i in 0..camera.image_width {
            let ray = camera.ray(i, j);
            assert_eq!(sky(&ray), gradient::ray_color(&ray));
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

/// However near: the range of t starts at 0, not at 0.001.
#[test]
fn what_is_close_to_the_eye_is_drawn() {
    let world = hittable_list::world();
    let close = Ray::new(Point3::new(0.0, 0.0, -0.499_999), Vec3::new(0.0, 0.0, -1.0));
    assert_eq!(
        hittable_list::ray_color(&close, &world),
        Color::new(0.5, 0.5, 1.0)
    );
    assert_eq!(normals::ray_color(&close), Color::new(0.5, 0.5, 1.0));
}
