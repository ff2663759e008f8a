//! Each slip is a program that differs from the right one as it says.

use std::collections::BTreeSet;

use common::rtweekend::*;
use difference::Comparison;
use hittable_list::{HittableList, Sphere};
use slips::{Chapter, ChapterCode, ChapterProgram, Edit, Languages, PROBES};

use fixtures::drawn::p3;

#[test]
fn a_program_without_a_slip_is_the_chapter_to_the_last_bit() {
    for chapter in Chapter::OF_THE_BOOK {
        for width in [1, 2, 3, 50, 110, chapter.book_width()] {
            assert_eq!(
                Comparison::of(
                    &chapter.picture(width),
                    &ChapterProgram::right(chapter).run(width).picture()
                ),
                Comparison::Equal,
                "{} at {width} wide: the interpreter draws another picture of its text, in \
                 book/judge/slips/texts, than the compiler",
                chapter.name()
            );
        }
    }
}

/// The loop and the levels of a right program are done without their text.
#[test]
fn the_text_around_a_chapter_does_what_is_done_without_it() {
    for chapter in Chapter::OF_THE_BOOK {
        let right = ChapterProgram::right(chapter);
        let edits = [
            Edit::new("255.999", "255.9990"),
            Edit::new("[i, j]", "[i + 0, j]"),
        ];
        let same = right.with_edits(&edits).expect("they stand there");
        assert!(
            right.run(33).pixels().eq(same.run(33).pixels()),
            "{chapter:?}"
        );
    }
}

#[test]
fn a_program_without_a_slip_draws_every_probe_as_chapter_5_does() {
    for probe in PROBES {
        let program = probe.applied_to(&ChapterProgram::right(Chapter::HittableList));
        let program = program.expect("chapter 5 takes any number of spheres");
        let mut world = HittableList::default();
        for ball in probe.spheres.into_iter().flatten() {
            world.add(Sphere::new(ball.center, ball.radius));
        }
        if probe.spheres.is_none() {
            world = hittable_list::world();
        }
        let output = program.run(probe.width);
        let (width, height) = output.size();
        let places = (0..height).flat_map(|j| (0..width).map(move |i| (i, j)));
        for (i, j) in places.step_by(5) {
            let ray = program.ray(probe.width, i, j);
            let ray = ray.expect("chapter 5 has a camera");
            let mut pixel = [0; 3];
            write_color(&mut pixel, hittable_list::ray_color(&ray, &world));
            let drawn = output.pixel(j * width + i);
            assert_eq!(drawn, pixel.map(i32::from), "{} at {i}, {j}", probe.name);
        }
    }
}

#[test]
fn the_text_of_a_program_without_a_slip_is_the_p3_of_its_picture() {
    for chapter in Chapter::OF_THE_BOOK {
        let output = ChapterProgram::right(chapter).run(31);
        let text = p3(&output.picture());
        assert_eq!(output.to_string().into_bytes(), text, "{chapter:?}");
    }
}

#[test]
fn the_names_are_distinct_and_easy_to_type() {
    let names: BTreeSet<&str> = slips::all().map(|slip| slip.name).collect();
    assert_eq!(names.len(), slips::all().count(), "two slips share a name");
    let is_easy = |byte| matches!(byte, b'a'..=b'z' | b'0'..=b'9' | b'-');
    for name in names {
        assert!(name.bytes().all(is_easy), "{name} is awkward to type");
    }
}

/// In each chapter that has its line, the text with the slip is a program with another meaning.
#[test]
fn every_slip_makes_another_program() {
    for slip in slips::all().chain(slips::unnamed()) {
        for chapter in slip.chapters() {
            let right = ChapterProgram::right(chapter);
            let wrong = slip.program(chapter);
            let text =
                |program: &ChapterProgram| format!("{:?}", program.functions().collect::<Vec<_>>());
            let is_another = text(&right) != text(&wrong) || slip.name == "single-precision";
            assert!(is_another, "{} in {chapter:?}", slip.name);
        }
        assert!(
            slip.chapters().next().is_some(),
            "{} stands nowhere",
            slip.name
        );
    }
}

#[test]
fn in_both_languages_a_slip_changes_its_line() {
    for slip in slips::all().chain(slips::unnamed()) {
        for chapter in slip.chapters() {
            for line in slip.lines_in(Languages::Both, chapter) {
                assert_ne!(line.wrong, line.right, "{} in {chapter:?}", slip.name);
            }
        }
    }
}
