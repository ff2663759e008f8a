//! Many pixels at once: the engine's blocks, rings and threads paint and print what a plain
//! loop over pixels does.

use std::io::{self, ErrorKind, Write};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;

use common::rtweekend::*;

fn p3_with_threads(picture: &Picture, threads: usize) -> io::Result<String> {
    let mut text = Vec::new();
    picture.write_p3_with_threads(threads, &mut text)?;
    Ok(String::from_utf8(text).expect("text"))
}

/// Returns the three bytes of a pixel with this color.
fn bytes_of(color: Color) -> [u8; 3] {
    let mut pixel = [0; 3];
    write_color(&mut pixel, color);
    pixel
}

/// A block of 80 pixels may hang over the edge of the picture, a strip of blocks may end
/// within a row.
#[test]
fn every_width_and_every_number_of_threads_gives_what_a_loop_over_pixels_gives() {
    let world = hittable_list::world();
    for width in [1, 2, 79, 80, 81, 159, 160, 161, 400] {
        let camera = Camera::new(width);
        let mut expected = format!("P3\n{width} {}\n255\n", camera.image_height);
        let mut bytes = Vec::new();
        for j in 0..camera.image_height {
            for i in 0..width {
                let color = hittable_list::ray_color(&camera.ray(i, j), &world);
                let [red, green, blue] = bytes_of(color);
                expected += &format!("{red} {green} {blue}\n");
                bytes.extend([red, green, blue]);
            }
        }
        let picture = hittable_list::picture(width);
        assert!(picture.rgb() == bytes, "the bytes at {width} wide");
        for threads in [1, 2, 5, 100] {
            let what = format!("{width} wide from {threads} threads");
            let text = p3_with_threads(&picture, threads).expect("memory takes it");
            assert!(text == expected, "the text at {what}");
            assert!(
                picture.rgb_with_threads(threads) == bytes,
                "the bytes at {what}"
            );
        }
    }
}

/// In a browser there are no other threads: one must do.
#[test]
fn one_thread_starts_no_other_and_two_share_the_work() {
    let here = thread::current().id();
    let elsewhere = Arc::new(AtomicBool::new(false));
    let seen = Arc::clone(&elsewhere);
    let picture = Picture::paint(400, 225, move |_, _| {
        seen.fetch_or(thread::current().id() != here, Ordering::Relaxed);
        Color::ZERO
    });
    for (threads, others) in [(1, false), (2, true)] {
        picture.rgb_with_threads(threads);
        assert_eq!(
            elsewhere.load(Ordering::Relaxed),
            others,
            "{threads} threads"
        );
    }
}

#[test]
fn every_level_becomes_the_number_that_print_makes_of_it() {
    let levels: Vec<u8> = (0..=255).flat_map(|n| [n, 255 - n, n / 2]).collect();
    let lines = levels.as_chunks::<3>().0.iter();
    let lines = lines.map(|[red, green, blue]| format!("{red} {green} {blue}\n"));
    let expected = format!("P3\n256 1\n255\n{}", lines.collect::<String>());
    let picture = Picture::from_rgb(256, 1, levels).expect("three bytes a pixel");
    assert_eq!(
        p3_with_threads(&picture, 1).expect("memory takes it"),
        expected
    );
}

/// Tries components around each boundary between two levels; NaN, infinities, and numbers far out
/// of range.
#[test]
fn many_components_become_the_levels_that_write_color_makes_of_them() {
    let mut components = vec![f64::NAN, -0.0, -1e-300, -1.0, 1e300, 1e-320];
    components.extend([f64::INFINITY, f64::NEG_INFINITY, f64::MAX, 2.0_f64.powi(31)]);
    for level in -1..=257 {
        let exact = f64::from(level) / 255.999;
        components.extend([exact.next_down(), exact, exact.next_up(), exact + 0.002]);
    }
    let colors: Vec<Color> = components.into_iter().map(Color::splat).collect();
    let expected: Vec<u8> = colors.iter().flat_map(|&color| bytes_of(color)).collect();
    let picture = Picture::paint(colors.len() as u32, 1, move |i, _| colors[i as usize]);
    assert_eq!(picture.rgb(), expected);
}

#[test]
fn a_writer_that_fails_ends_the_picture_on_any_number_of_threads() {
    struct Full;
    impl Write for Full {
        fn write(&mut self, text: &[u8]) -> io::Result<usize> {
            if text.len() < 100 {
                Ok(text.len())
            } else {
                Err(ErrorKind::StorageFull.into())
            }
        }
        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }
    for threads in [1, 2, 7] {
        let written = gradient::picture(1000).write_p3_with_threads(threads, &mut Full);
        assert_eq!(
            written.expect_err("it is full").kind(),
            ErrorKind::StorageFull
        );
    }
}
