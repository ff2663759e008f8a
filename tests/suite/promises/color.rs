//! The color of a ray, and the bytes that it becomes in a picture.

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

/// Compares to the bit: the eight bits of a picture would hide another formula.
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

/// Returns the color of a ray in each chapter that colors a hit by its normal.
fn colors_by_normal(ray: &Ray) -> [Color; 3] {
    [
        normals::ray_color(ray),
        half_b_sphere::ray_color(ray),
        hittable_list::ray_color(ray, &hittable_list::world()),
    ]
}

/// The sphere is at z = −1. The first ray starts beyond it, the second on its surface, where
/// the farther root is t = 0, exactly.
#[test]
fn what_is_behind_the_ray_is_not_drawn_from_chapter_3_on() {
    for (z, direction) in [(-3.0, Vec3::new(0.0, 0.25, -1.0)), (-0.5, Vec3::Z)] {
        let away = Ray::new(Point3::new(0.0, 0.0, z), direction);
        assert_eq!(colors_by_normal(&away), [sky(&away); 3], "{away:?}");
    }
}

/// The range of t starts at 0, not at 0.001, and has no end. The rays are oblique, so that near and
/// far side have other normals.
#[test]
fn what_is_close_to_the_eye_or_far_from_it_is_drawn() {
    let towards = Vec3::new(0.1, -0.2, -1.0);
    let on_the_surface = Point3::new(0.0, 0.0, -0.5);
    // The normal there is (0, 0, 1). From 1e5 away t has four digits less.
    let expected = Color::new(0.5, 0.5, 1.0);
    for t in [1e-9, 1e-4, 0.01, 1e5] {
        for color in colors_by_normal(&Ray::new(on_the_surface - t * towards, towards)) {
            let off = (color - expected).abs().max_element();
            assert!(
                off < 1e-4,
                "{color} from {t} directions away, for {expected}"
            );
        }
    }
}

/// In chapters 3 and 4 a ray that starts on the surface has its nearer root at t = 0.
#[test]
fn a_ray_into_the_sphere_from_its_surface_does_not_see_it_in_chapters_3_and_4() {
    let inwards = Ray::new(Point3::new(0.0, 0.0, -0.5), Vec3::NEG_Z);
    assert_eq!(colors_by_normal(&inwards)[..2], [sky(&inwards); 2]);
}

/// Chapter 2 asks whether there is a root, not where.
#[test]
fn chapter_2_draws_what_is_behind_the_ray() {
    let away = Ray::new(Point3::new(0.0, 0.0, -3.0), Vec3::new(0.0, 0.25, -1.0));
    assert_eq!(red_sphere::ray_color(&away), Color::new(1.0, 0.0, 0.0));
}
