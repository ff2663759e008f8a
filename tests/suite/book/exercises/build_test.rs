//! Answers to the exercises of the build test.

use common::rtweekend::*;

/// The build test at two pixels wide, as the program prints it.
const TWO_BY_TWO: &str = "\
P3
2 2
255
0 0 0
255 0 0
0 255 0
255 255 0
";

#[test]
fn four_pixels_are_four_lines_below_the_header() {
    let mut text = Vec::new();
    let printed = build_test::picture(2).write_p3(&mut text);
    printed.expect("memory takes it");
    assert_eq!(String::from_utf8(text).as_deref(), Ok(TWO_BY_TWO));
}

/// Counts those of the components 0, 1/n, 2/n … 1 that a scale turns into `level`.
fn share(scale: f64, level: f64, n: u32) -> usize {
    (0..=n)
        .map(|k| f64::from(k) / f64::from(n))
        .filter(|component| (scale * component).floor() == level)
        .count()
}

#[test]
fn a_scale_of_255_gives_the_brightest_level_to_a_single_number() {
    assert_eq!(share(255.0, 255.0, 25_500), 1);
    assert_eq!(share(255.0, 254.0, 25_500), 100);
    // A scale of 256 needs a level that no byte has.
    assert_eq!(share(256.0, 256.0, 25_600), 1);
    assert_eq!(share(256.0, 255.0, 25_600), 100);
}

#[test]
fn a_scale_of_255_999_is_fair_and_stays_in_range() {
    assert_eq!(share(255.999, 256.0, 25_600), 0);
    for level in 0..=255 {
        let share = share(255.999, f64::from(level), 25_600);
        assert!((100..=101).contains(&share), "{share} for level {level}");
    }
    let mut pixel = [0; 3];
    write_color(&mut pixel, Color::splat(1.0));
    assert_eq!(pixel, [255; 3]);
}
