//! The texts by which the judge goes, beside the chapters, `common` and what the book's program
//! prints.
//!
//! The judge hangs on no chapter, and of `common` on the types and the engine alone, so a reader may
//! change the rest. Here, and nowhere else, all have to do the same; how they are written is free.

use check::lawful;
use common::rtweekend::*;
use difference::Comparison;
use fixtures::command::{cargo, run, text};
use fixtures::drawn::p3;
use hittable_list::{HitRecord, Hittable, HittableList, Sphere};
use laws::Case;
use laws::prelude::Prelude;
use laws::question::{Question, decided, numbers_of_hit, numbers_of_ray};
use laws::record::RecordedHit;
use laws::strategies::{pixels, samples};
use sha2::{Digest, Sha256};
use slips::{Chapter, ChapterCode, ChapterProgram, PROBES};

/// While a chapter does not compile, all of these still do, and answer.
#[test]
fn what_judges_is_made_of_no_chapter() {
    let mut tree = cargo();
    tree.args([
        "tree",
        "--offline",
        "--edges",
        "normal,build",
        "--prefix",
        "none",
    ]);
    for package in ["companion", "launcher", "check", "skeletons", "page"] {
        tree.args(["--package", package]);
    }
    tree.args(["--features", "page/judge"]);
    let output = run(tree.current_dir(fixtures::workspace()));
    // Cargo may say that it waits for another one.
    assert!(output.status.success(), "{}", text(&output.stderr));
    let parts = text(&output.stdout);
    let mut chapters = parts.lines().filter(|line| line.contains("/chapters/"));
    assert_eq!(chapters.next(), None, "{parts}");
    assert!(parts.contains("/common)"), "{parts}");
}

/// The widest picture whose sum is compared here.
const WIDEST: u32 = 400;

#[test]
fn the_texts_draw_what_the_books_program_prints() {
    let table = include_str!("../../chapters/reference_sums.txt").lines();
    for line in table.filter(|line| !line.starts_with('#')) {
        let [sum, name, width] = line.split(' ').collect::<Vec<_>>()[..] else {
            panic!("{line} is not `sum chapter width`");
        };
        let (chapter, width) = (Chapter::find(name), width.parse().expect("a number"));
        if width > WIDEST {
            continue;
        }
        let text = p3(&chapter.expect("a chapter").picture(width));
        let bytes = Sha256::digest(&text);
        let drawn = bytes.iter().map(|byte| format!("{byte:02x}"));
        assert_eq!(drawn.collect::<String>(), sum, "{name} at {width} wide");
    }
}

#[test]
fn the_texts_draw_what_the_chapters_draw() {
    let chapters: [fn(u32) -> Picture; 6] = [
        build_test::picture,
        gradient::picture,
        red_sphere::picture,
        normals::picture,
        half_b_sphere::picture,
        hittable_list::picture,
    ];
    for (chapter, draw) in Chapter::OF_THE_BOOK.into_iter().zip(chapters) {
        for width in [1, 97, chapter.book_width()] {
            assert_eq!(
                Comparison::of(&chapter.picture(width), &draw(width)),
                Comparison::Equal,
                "{chapter:?} at {width} wide: {WHICH}"
            );
        }
    }
}

#[test]
fn the_texts_answer_as_the_chapters_do() {
    for chapter in Chapter::TYPED {
        let places = samples(&pixels(), 300).into_iter().map(Question::PixelRay);
        let questions = lawful::questions(chapter).into_iter().chain(places);
        let answers = lawful::answers_of(&ChapterProgram::right(chapter), questions);
        for answered in answers.given {
            let theirs = answer_of(chapter, &answered.question);
            let bits = |numbers: &[f64]| -> Vec<u64> {
                // One NaN is as good as another.
                let one = |number: &f64| if number.is_nan() { f64::NAN } else { *number };
                numbers.iter().map(|number| one(number).to_bits()).collect()
            };
            assert_eq!(
                bits(&answered.answer),
                bits(&theirs),
                "{chapter:?} answers {theirs:?} to {:?}, and the text {:?}: {WHICH}",
                answered.question,
                answered.answer
            );
        }
    }
}

#[test]
fn the_texts_draw_every_probe_as_chapter_5_does() {
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

/// Says which of the two is wrong.
const WHICH: &str =
    "if `cargo test -p chapters` passes, the text in book/judge/slips/texts is wrong";

/// Asks the function of a chapter, or of `common`, that the question is about.
fn answer_of(chapter: Chapter, question: &Question) -> Vec<f64> {
    match question {
        Question::Prelude(asked) => asked.put_to(&Prelude::of_common()),
        Question::PixelRay(at) => numbers_of_ray(Camera::new(at.width).ray(at.i, at.j)),
        Question::RayColor(ray) => ray_color(chapter, ray).to_array().to_vec(),
        Question::Decision(case) => {
            decided(red_sphere::hit_sphere(case.center, case.radius, &case.ray))
        }
        Question::Root(case) => {
            let solve = match chapter {
                Chapter::Normals => normals::hit_sphere,
                _ => half_b_sphere::hit_sphere,
            };
            case.solve(&solve).into_iter().collect()
        }
        Question::Record(asked) => {
            let Case {
                center,
                radius,
                ray,
            } = asked.case;
            let hit = Sphere::new(center, radius).hit(&ray, asked.t_min, asked.t_max);
            numbers_of_hit(asked, hit.map(recorded))
        }
        Question::Nearest(world) => {
            let mut list = HittableList::default();
            for (center, radius) in &world.spheres {
                list.add(Sphere::new(*center, *radius));
            }
            let hit = list.hit(&world.ray, world.t_min, world.t_max);
            hit.map(|record| record.t).into_iter().collect()
        }
    }
}

fn ray_color(chapter: Chapter, ray: &Ray) -> Color {
    match chapter {
        Chapter::Gradient => gradient::ray_color(ray),
        Chapter::RedSphere => red_sphere::ray_color(ray),
        Chapter::Normals => normals::ray_color(ray),
        Chapter::HalfBSphere => half_b_sphere::ray_color(ray),
        _ => hittable_list::ray_color(ray, &hittable_list::world()),
    }
}

fn recorded(record: HitRecord) -> RecordedHit {
    RecordedHit {
        t: record.t,
        point: record.point,
        normal: record.normal,
        front_face: record.front_face,
    }
}
