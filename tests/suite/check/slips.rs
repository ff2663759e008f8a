//! Each slip is a program that differs from the right one as it says.

use std::collections::BTreeSet;
use std::path::Path;

use check::comparison::Comparison;
use check::known::Known;
use check::scene::Scene;
use common::rtweekend::*;
use hittable_list::{HittableList, Sphere};
use slips::{Ball, Chapter, Edit, Edition, Letters, PROBES, Probe, Program};

use suite::drawn::p3;

#[test]
fn a_program_without_a_slip_is_the_chapter_to_the_last_bit() {
    for chapter in Chapter::OF_THE_BOOK {
        for width in [1, 2, 3, 50, 110, chapter.book_width()] {
            assert_eq!(
                Comparison::of(
                    &chapter.picture(width),
                    &Program::right(chapter).run(width).picture()
                ),
                Comparison::Equal,
                "{} at {width} wide: the text around it, in book/judge/slips/src/text, does not do \
                 what `common` does. If another test fails too, it is the chapter that is wrong",
                chapter.name()
            );
        }
    }
}

/// The loop and the levels of a right program are done without their text.
#[test]
fn the_text_around_a_chapter_does_what_is_done_without_it() {
    for chapter in Chapter::OF_THE_BOOK {
        let right = Program::right(chapter);
        let edits = [
            Edit::new("255.999", "255.9990"),
            Edit::new("[i, j]", "[i + 0, j]"),
        ];
        let same = right.with(&edits).expect("they stand there");
        assert!(
            right.run(33).pixels().eq(same.run(33).pixels()),
            "{chapter:?}"
        );
    }
}

#[test]
fn a_program_without_a_slip_hits_what_the_chapter_hits_in_every_probe() {
    for probe in PROBES {
        let program = probed(probe);
        for &Ball { center, radius } in probe.spheres.into_iter().flatten() {
            for (_, _, ray) in &rays(&program, probe.width, 7) {
                let hit = |chapter| Program::right(chapter).hit_sphere(center, radius, ray);
                let [red, full, half] =
                    [Chapter::RedSphere, Chapter::Normals, Chapter::HalfBSphere].map(hit);
                assert_eq!(red.is_some(), red_sphere::hit_sphere(center, radius, ray));
                assert_eq!(full, normals::hit_sphere(center, radius, ray));
                assert_eq!(half, half_b_sphere::hit_sphere(center, radius, ray));
            }
        }
    }
}

#[test]
fn a_program_without_a_slip_draws_every_probe_as_chapter_5_does() {
    for probe in PROBES {
        let program = probed(probe);
        let mut world = HittableList::default();
        for ball in probe.spheres.into_iter().flatten() {
            world.add(Sphere::new(ball.center, ball.radius));
        }
        if probe.spheres.is_none() {
            world = hittable_list::world();
        }
        let output = program.run(probe.width);
        let (width, _) = output.size();
        for (i, j, ray) in rays(&program, probe.width, 5) {
            let mut pixel = [0; 3];
            write_color(&mut pixel, hittable_list::ray_color(&ray, &world));
            let drawn = output.pixel(j * width + i);
            assert_eq!(drawn, pixel.map(i32::from), "{} at {i}, {j}", probe.name);
        }
    }
}

fn probed(probe: Probe) -> Program {
    let right = Program::right(Chapter::HittableList);
    let probed = probe.put_to(&right);
    probed.expect("chapter 5 takes any number of spheres")
}

#[test]
fn the_text_of_a_program_without_a_slip_is_the_p3_of_its_picture() {
    for chapter in Chapter::OF_THE_BOOK {
        let output = Program::right(chapter).run(31);
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

/// A report is silent about a file that is not there.
#[test]
fn every_slip_leads_to_a_file_that_has_it_right() {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for slip in slips::all() {
        let source = slip.source().expect("its line stands somewhere");
        assert!(workspace.join(&source).is_file(), "{}: {source}", slip.name);
    }
}

/// Wherever its line stands, what is typed there instead is a program.
#[test]
fn every_slip_makes_another_program() {
    for slip in slips::all().chain(slips::unnamed()) {
        for chapter in slip.chapters() {
            let right = Program::right(chapter);
            let wrong = slip.program(chapter);
            let text = |program: &Program| format!("{:?}", program.functions().collect::<Vec<_>>());
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

/// Whoever follows version 3 has no such line as version 4's, in whatever language.
#[test]
fn a_slip_of_an_older_edition_is_said_in_its_words() {
    let scene = Scene::new(Chapter::Gradient, None).expect("it has the book's scene");
    let scene = scene.only_by(Edition::V3);
    for letters in [
        None,
        Some(Letters::Python(Edition::V4)),
        Some(Letters::Rust),
    ] {
        let known = Known {
            letters,
            ..Known::default()
        };
        for (slip, line) in [
            ("deltas-from-last-pixel", "u = (i + 0.5) / …"),
            ("viewport-mirrored", "horizontal = (-viewport_width, 0, 0)"),
        ] {
            let words = known.words(suite::slip(slip), &scene);
            assert!(
                words.wrong.starts_with(line),
                "{slip} in {letters:?} is said as {}",
                words.wrong
            );
        }
    }
}

#[test]
fn in_every_language_a_slip_changes_its_line() {
    let books = Edition::ALL.map(Letters::Book);
    let pythons = Edition::ALL.map(Letters::Python);
    for slip in slips::all().chain(slips::unnamed()) {
        for letters in [Letters::Rust].iter().chain(&books).chain(&pythons) {
            for chapter in slip.chapters() {
                let words = slip.words(*letters, chapter);
                assert_ne!(words.wrong, words.right, "{} in {letters:?}", slip.name);
            }
        }
    }
}

/// Every nth of the program's rays, with its column and row.
fn rays(program: &Program, width: u32, nth: usize) -> Vec<(u32, u32, Ray)> {
    let (columns, rows) = program.run(width).size();
    let places = (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j)));
    let ray = |(i, j)| Some((i, j, program.ray(width, i, j)?));
    places.step_by(nth).filter_map(ray).collect()
}
