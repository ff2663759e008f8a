//! Each slip is a program that differs from the right one as it says.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::fs;
use std::iter;
use std::path::Path;

use check::comparison::Comparison;
use check::known::Known;
use check::scene::Scene;
use common::rtweekend::*;
use hittable_list::{HittableList, Sphere};
use slips::{Ball, Chapter, Edition, Letters, PROBES, Program, Slip, Unseen};

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
                "{} at {width} wide: the steps in book/judge/slips/src/program.rs are not those of the \
                 chapter. If another test fails too, it is the chapter that is wrong",
                chapter.name()
            );
        }
    }
}

#[test]
fn a_program_without_a_slip_hits_what_the_chapter_hits_in_every_probe() {
    for probe in PROBES {
        let camera = probe
            .put_to(Program::right(Chapter::HittableList))
            .expect("chapter 5 takes any number of spheres")
            .camera(probe.width);
        for &Ball { center, radius } in probe.spheres.into_iter().flatten() {
            for ray in &rays(&camera) {
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
        let program = probe
            .put_to(Program::right(Chapter::HittableList))
            .expect("chapter 5 takes any number of spheres");
        let mut world = HittableList::default();
        for ball in program.world.iter() {
            world.add(Sphere::new(ball.center, ball.radius));
        }
        let camera = program.camera(probe.width);
        let picture = Picture::paint(camera.image_width, camera.image_height, move |i, j| {
            hittable_list::ray_color(&camera.ray(i, j), &world)
        });
        assert_eq!(
            Comparison::of(&picture, &program.run(probe.width).picture()),
            Comparison::Equal,
            "probe {}",
            probe.name
        );
    }
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
    for Slip { name, source, .. } in slips::all() {
        assert!(workspace.join(source).is_file(), "{name}: {source}");
    }
}

/// The judge looks for these lines in what a reader typed.
#[test]
fn in_rust_a_slip_is_said_as_our_chapters_are_typed() {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let typed = |file: &str| {
        let text = fs::read_to_string(workspace.join(file)).expect("a source");
        tokens_of(&text)
    };
    let mut unlike = String::new();
    for slip in slips::all().filter(|slip| slip.is_in_a_chapter()) {
        for &chapter in slip.chapters {
            let in_rust = slip.words(Letters::Rust, chapter);
            let in_book = slip.words(Letters::Book(Edition::V4), chapter);
            // Where both say it alike, it is said in words; or it is another chapter's line.
            let is_equivalent = matches!(slip.unseen_in(chapter), Some(Unseen::Equivalent(_)));
            if in_rust.right == in_book.right || is_equivalent {
                continue;
            }
            let typed: String = sources(chapter).map(typed).collect();
            let [wrong, right] = [&in_rust.wrong, &in_rust.right].map(|line| tokens_of(line));
            // What is forgotten leaves a part of the right line.
            let rest = typed.replace(&right, " ");
            if !typed.contains(&right) || rest.contains(&wrong) {
                writeln!(unlike, "{} in {chapter:?}: {in_rust:?}", slip.name)
                    .expect("a string takes it");
            }
        }
    }
    assert!(unlike.is_empty(), "{unlike}");
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
            for &chapter in slip.chapters {
                let words = slip.words(*letters, chapter);
                assert_ne!(words.wrong, words.right, "{} in {letters:?}", slip.name);
            }
        }
    }
}

/// Where a chapter is typed.
fn sources(chapter: Chapter) -> impl Iterator<Item = &'static str> {
    // The sky of the later chapters is what was typed in the first one.
    let own: &[&str] = match chapter {
        Chapter::BuildTest => &["chapters/0_build_test/src/lib.rs"],
        Chapter::Gradient => &[],
        Chapter::RedSphere => &["chapters/2_red_sphere/src/lib.rs"],
        Chapter::Normals => &["chapters/3_normals/src/lib.rs"],
        Chapter::HalfBSphere => &["chapters/4_half_b_sphere/src/lib.rs"],
        _ => &[
            "chapters/5_hittable_list/src/lib.rs",
            "chapters/5_hittable_list/src/hittable.rs",
            "chapters/5_hittable_list/src/hittable_list.rs",
            "chapters/5_hittable_list/src/sphere.rs",
        ],
    };
    iter::once("chapters/1_gradient/src/lib.rs").chain(own.iter().copied())
}

/// Each token between spaces, and no `let`.
fn tokens_of(code: &str) -> String {
    let is_sign = |c: char| !c.is_alphanumeric() && c != '_';
    let apart = code.split_inclusive(is_sign).flat_map(|part| {
        let sign = part.rfind(is_sign).unwrap_or(part.len());
        let (word, sign) = part.split_at(sign);
        [word, sign.trim()]
    });
    let tokens = apart.filter(|&token| !matches!(token, "" | "let"));
    tokens.fold(" ".to_owned(), |tokens, token| tokens + token + " ")
}

fn rays(camera: &Camera) -> Vec<Ray> {
    (0..camera.image_height)
        .flat_map(|j| (0..camera.image_width).map(move |i| camera.ray(i, j)))
        .collect()
}
