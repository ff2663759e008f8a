//! The camera maps pixels to rays as the book's does.

use common::rtweekend::*;
use tests::laws::Verdict;
use tests::mappings;

#[test]
fn the_height_is_rounded_down_and_at_least_one() {
    for (width, height) in [
        (1, 1),
        (2, 1),
        (3, 1),
        (4, 2),
        (16, 9),
        (17, 9),
        (100, 56),
        (400, 225),
    ] {
        assert_eq!(Camera::new(width).image_height, height, "at {width} wide");
    }
    // Rounding to the nearest integer, as the notes say, would give 226.
    assert_eq!(Camera::new(401).image_height, 225);
}

#[test]
fn the_ray_of_a_pixel_goes_through_its_center() {
    let ray =
        |[width, height]: [u32; 2], [i, j]: [u32; 2]| Camera::with_size(width, height).ray(i, j);
    for size in [[1, 1], [7, 5], [16, 9], [400, 225], [5, 7], [3840, 2160]] {
        let [width, height] = size;
        for pixel in [
            [0, 0],
            [width - 1, 0],
            [0, height - 1],
            [width / 2, height / 3],
        ] {
            assert_holds(mappings::the_ray_of_a_pixel_goes_through_its_center(
                &ray, size, pixel,
            ));
        }
    }
}

#[test]
fn dot_multiplies_equal_letters() {
    let dot = |u: Vec3, v: Vec3| u.dot(v);
    for vectors in [
        [[1, 2, 3], [5, 7, 11]],
        [[1, 0, 0], [0, 1, 0]],
        [[0, 1, 0], [0, 0, 1]],
        [[0, 0, 1], [1, 0, 0]],
        [[-4, 9, 2], [3, -8, 6]],
    ] {
        assert_holds(mappings::dot_multiplies_equal_letters(&dot, vectors));
    }
}

#[test]
fn a_swapped_letter_in_dot_breaks_its_law() {
    let swapped = |u: Vec3, v: Vec3| u.x * v.x + u.y * v.y + u.z * u.z;
    let verdict = mappings::dot_multiplies_equal_letters(&swapped, [[1, 2, 3], [5, 7, 11]]);
    assert!(verdict.is_err());
}

#[test]
fn pixels_are_squares_even_where_the_picture_is_not_quite_16_to_9() {
    for width in [1, 5, 100, 401] {
        let camera = Camera::new(width);
        let (u, v) = (camera.pixel_delta_u.x, -camera.pixel_delta_v.y);
        // Each side is a quotient or two away from exact: 4 roundings at most.
        assert!(
            (u - v).abs() <= 4.0 * f64::EPSILON * u,
            "at {width} wide: {u} × {v}"
        );
    }
}

#[test]
fn the_grid_is_inset_by_half_a_pixel() {
    // 4 × 2 pixels on a viewport 4 wide and 2 high: each pixel is a unit square.
    let camera = Camera::with_size(4, 2);
    assert_eq!(camera.ray(0, 0).direction, Vec3::new(-1.5, 0.5, -1.0));
    assert_eq!(camera.ray(3, 1).direction, Vec3::new(1.5, -0.5, -1.0));
}

#[test]
fn colors_are_cut_off_not_rounded_and_stay_in_range() {
    let levels = [
        (0.0, 0),
        (0.5, 127),
        (0.999, 255),
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
fn the_sky_of_the_prelude_is_the_gradient_of_chapter_1() {
    let camera = Camera::new(31);
    for (i, j) in [(0, 0), (15, 8), (30, 16), (4, 11)] {
        let ray = camera.ray(i, j);
        assert_eq!(sky(&ray), gradient::ray_color(&ray));
    }
}

fn assert_holds(verdict: Verdict) {
    if let Err(broken) = verdict {
        panic!("\n\nA law is broken.\n\n{broken}\n");
    }
}
