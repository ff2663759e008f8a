//! Answers to the exercises of chapter 1.

use common::rtweekend::*;

/// Returns the rows of the picture whose rays neither climb nor fall.
fn level_rows(width: u32) -> Vec<u32> {
    let camera = Camera::new(width);
    let is_level = |&j: &u32| camera.ray(0, j).direction.y.abs() < 1e-12;
    (0..camera.image_height).filter(is_level).collect()
}

#[test]
fn only_a_middle_row_is_blended_from_equal_parts() {
    assert_eq!(level_rows(400), [112]);
    assert!(level_rows(320).is_empty());
    let picture = gradient::picture(400);
    let (pixels, _) = picture.rgb().as_chunks::<3>();
    let row = &pixels[112 * 400..][..400];
    assert!(row.iter().all(|pixel| *pixel == [191, 217, 255]));
}

/// Returns the distance of the point at t = 1, for the nearest and for the farthest pixel of the
/// picture.
fn distances_at_1(width: u32) -> (f64, f64) {
    range_of(width, |ray| (ray.at(1.0) - ray.origin).length())
}

/// Returns the least and the greatest weight of blue in the picture.
fn weights(width: u32) -> (f64, f64) {
    range_of(width, |ray| 0.5 * (ray.direction.normalize().y + 1.0))
}

/// Returns the least and the greatest `number` of all rays of the picture.
fn range_of(width: u32, number: impl Fn(&Ray) -> f64) -> (f64, f64) {
    let camera = Camera::new(width);
    let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
    for j in 0..camera.image_height {
        for i in 0..camera.image_width {
            let number = number(&camera.ray(i, j));
            least = least.min(number);
            greatest = greatest.max(number);
        }
    }
    (least, greatest)
}

#[test]
fn the_pixel_that_the_page_works_through_has_these_numbers() {
    let direction = Camera::new(400).ray(300, 50).direction;
    let height = direction.normalize().y;
    let numbers = [direction.x, direction.y, direction.length(), height];
    let said = numbers.map(|number| format!("{number:.5}"));
    assert_eq!(said, ["0.89333", "0.55111", "1.44975", "0.38014"]);
    assert_eq!(format!("{:.5}", 0.5 * (height + 1.0)), "0.69007");
    let first = 3 * (50 * 400 + 300);
    let picture = gradient::picture(400);
    assert_eq!(picture.rgb()[first..first + 3], [167, 203, 255]);
}

#[test]
fn t_is_1_for_every_pixel_and_the_distance_is_not() {
    let (nearest, farthest) = distances_at_1(400);
    assert_eq!(format!("{nearest:.2} {farthest:.2}"), "1.00 2.27");
}

#[test]
fn the_picture_is_never_white_and_never_blue() {
    let (least, greatest) = weights(400);
    assert_eq!(format!("{least:.3} {greatest:.3}"), "0.147 0.853");
}

#[test]
fn the_sky_is_bluest_above_the_middle_and_not_in_the_corners() {
    let blue = |i| 1.0 - gradient::ray_color(&Camera::new(400).ray(i, 0)).x;
    assert!((0..400).all(|i| blue(i) <= blue(199)));
    assert!(blue(0) < 0.85 * blue(199));
}
