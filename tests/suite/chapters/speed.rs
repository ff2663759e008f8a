//! Many pixels at once: the engine's blocks, rings and threads draw what a loop over pixels
//! draws, and what the book's program in C++ draws.

#[cfg(target_os = "linux")]
use std::fs;
use std::io::ErrorKind;
#[cfg(target_os = "linux")]
use std::io::Read;
use std::path::Path;
use std::process::Command;
#[cfg(target_os = "linux")]
use std::process::Stdio;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;

use common::rtweekend::*;
use measure::rival;
use slips::Chapter;

#[cfg(target_os = "linux")]
use suite::command::program_with;
use suite::drawn::p3;
use suite::drawn::p3_with_threads;
use suite::left_out::left_out;

#[test]
#[ignore = "compiles C++"]
fn the_books_program_in_cpp_draws_the_same_bytes() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("rival");
    let program = match rival::build(&folder) {
        Ok(program) => program,
        Err(cause) if cause.kind() == ErrorKind::NotFound => {
            left_out(&format!(
                "there is no C++ compiler to build book/measure/rival/book.cc ({cause})"
            ));
            return;
        }
        Err(cause) => panic!("book/measure/rival/book.cc does not compile:\n{cause}"),
    };
    // The build test has no part in the race.
    for chapter in &Chapter::OF_THE_BOOK[1..] {
        for width in [1, 79, 80, 81, 161, 257] {
            let drawn = Command::new(&program)
                .args([chapter.name(), &width.to_string()])
                .output()
                .expect("the program starts");
            assert!(
                drawn.stdout == p3(&chapter.picture(width)),
                "{} at {width} wide is not what the C++ draws",
                chapter.name()
            );
        }
    }
}

/// A block of 80 pixels may hang over the edge of the picture, a strip of blocks
/// may end within a row.
#[test]
fn every_width_and_every_number_of_threads_gives_what_a_loop_over_pixels_gives() {
    let world = hittable_list::world();
    for width in [1, 2, 79, 80, 81, 159, 160, 161, 400] {
        let camera = Camera::new(width);
        let mut expected = format!("P3\n{width} {}\n255\n", camera.image_height);
        let mut bytes = Vec::new();
        for j in 0..camera.image_height {
            for i in 0..width {
                let mut pixel = [0; 3];
                write_color(
                    &mut pixel,
                    hittable_list::ray_color(&camera.ray(i, j), &world),
                );
                let [red, green, blue] = pixel;
                expected += &format!("{red} {green} {blue}\n");
                bytes.extend(pixel);
            }
        }
        let picture = hittable_list::picture(width);
        assert!(picture.rgb() == bytes, "the bytes at {width} wide");
        for threads in [1, 2, 5] {
            assert!(
                p3_with_threads(&picture, threads) == expected.as_bytes(),
                "the text at {width} wide from {threads} threads"
            );
        }
    }
}

/// Where there are no threads to be had, as in a browser, one must do.
#[test]
fn one_thread_starts_no_other_and_two_share_the_work() {
    let here = thread::current().id();
    let elsewhere = Arc::new(AtomicBool::new(false));
    let seen = Arc::clone(&elsewhere);
    let picture = Picture::paint(400, 225, move |_, _| {
        seen.fetch_or(thread::current().id() != here, Ordering::Relaxed);
        Color::ZERO
    });
    picture.rgb_with_threads(1);
    assert!(
        !elsewhere.load(Ordering::Relaxed),
        "one thread was asked for"
    );
    picture.rgb_with_threads(2);
    assert!(
        elsewhere.load(Ordering::Relaxed),
        "two threads were asked for"
    );
}

/// `speed.md` says so. The widest picture is not waited for: its memory
/// is at its height when the first megabytes are there.
#[cfg(target_os = "linux")]
#[test]
#[ignore = "builds the programs of two chapters"]
fn printing_takes_less_than_6_mib_of_memory_at_any_width() {
    for (chapter, width) in [
        ("hittable_list", "400"),
        ("normals", "3840"),
        ("hittable_list", "16384"),
    ] {
        let mut command = program_with(chapter, &["--width", width, "-"]);
        let mut child = command.stdout(Stdio::piped()).spawn().expect("it starts");
        let mut out = child.stdout.take().expect("it was asked for");
        let mut text = vec![0; if width == "400" { 1 << 19 } else { 8 << 20 }];
        out.read_exact(&mut text).expect("it prints");
        let status = fs::read_to_string(format!("/proc/{}/status", child.id())).expect("it runs");
        child.kill().expect("it is ours");
        child.wait().expect("it ends");
        let most = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let most = most.and_then(|line| line.trim().strip_suffix(" kB"));
        let kibibytes: u32 = most
            .and_then(|number| number.parse().ok())
            .expect("a number");
        println!("{chapter} at {width}: {kibibytes} KiB");
        assert!(
            kibibytes < 6 << 10,
            "{chapter} at {width} wide: {kibibytes} KiB"
        );
    }
}

#[test]
fn every_level_becomes_the_number_that_print_makes_of_it() {
    let levels: Vec<u8> = (0..=255).flat_map(|n| [n, 255 - n, n / 2]).collect();
    let expected: String = levels
        .as_chunks::<3>()
        .0
        .iter()
        .map(|[red, green, blue]| format!("{red} {green} {blue}\n"))
        .collect();
    let picture = Picture::from_rgb(256, 1, levels).expect("three bytes a pixel");
    assert_eq!(
        String::from_utf8(p3(&picture)).expect("text"),
        format!("P3\n256 1\n255\n{expected}")
    );
}

/// The components around each boundary between two levels; and NaN, infinities, and
/// numbers far out of range.
#[test]
fn many_components_become_the_levels_that_write_color_makes_of_them() {
    let mut components = vec![f64::NAN, -0.0, -1e-300, -1.0, 1e300, 1e-320];
    components.extend([f64::INFINITY, f64::NEG_INFINITY, f64::MAX, 2.0_f64.powi(31)]);
    for level in -1..=257 {
        let exact = f64::from(level) / 255.999;
        components.extend([exact.next_down(), exact, exact.next_up(), exact + 0.002]);
    }
    let expected: Vec<u8> = components
        .iter()
        .flat_map(|&component| {
            let mut pixel = [0; 3];
            write_color(&mut pixel, Color::splat(component));
            pixel
        })
        .collect();
    let width = components.len();
    let picture = Picture::paint(width as u32, 1, move |i, _| {
        Color::splat(components[i as usize])
    });
    assert_eq!(picture.rgb(), expected);
}

#[test]
fn a_writer_that_fails_ends_the_picture_on_any_number_of_threads() {
    struct Full;
    impl std::io::Write for Full {
        fn write(&mut self, text: &[u8]) -> std::io::Result<usize> {
            match text.len() {
                ..100 => Ok(text.len()),
                _ => Err(ErrorKind::StorageFull.into()),
            }
        }
        fn flush(&mut self) -> std::io::Result<()> {
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
