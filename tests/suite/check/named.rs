//! A wrong picture is diagnosed: each slip is drawn, and has to be named.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use check::diagnosis::{But, Explains, Scene};
use check::judge::{Check, Finding, check};
use check::png;
use common::rtweekend::*;
use slips::Chapter;
use slips::{self, Ball, Edition, PROBES, Probe, Program, Slip};

use suite::slip;

#[test]
fn each_slip_is_named() {
    let all: Vec<&Slip> = slips::all().collect();
    let next = AtomicUsize::new(0);
    let threads = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some(slip) = all.get(next.fetch_add(1, Ordering::Relaxed)) {
                    is_named(slip);
                }
            });
        }
    });
}

#[test]
fn right_pictures_are_right_in_every_format_and_size() {
    for chapter in Chapter::OF_THE_BOOK {
        for width in [1, 2, 57, 400] {
            let picture = chapter.picture(width);
            let text = scene(chapter).program(&[]).run(width).to_string();
            for bytes in [png::encode(&picture), text.into_bytes()] {
                let Check::Right(right) = check(&scene(chapter), &bytes, 0) else {
                    panic!("{chapter:?} at {width} is refused");
                };
                assert_eq!((right.width, right.off), (width, 0));
            }
        }
    }
}

#[test]
fn what_is_tolerated_is_right_and_no_more() {
    let noisy = png::encode(&with_noise(&normals::picture(100)));
    let exit = |tolerance| check(&scene(Chapter::Normals), &noisy, tolerance).exit_code();
    assert_eq!((exit(0), exit(1)), (1, 0));
    let other = png::encode(&red_sphere::picture(100));
    assert_eq!(check(&scene(Chapter::Normals), &other, 100).exit_code(), 1);
    assert_eq!(check(&scene(Chapter::Normals), &other, 255).exit_code(), 0);
}

#[test]
fn harmless_deviations_are_named() {
    for name in ["rounded", "times-255", "times-256-clamped", "times-255-99"] {
        let output = slip(name).program(Chapter::HittableList).run(100);
        let Check::Wrong(finding) = check(
            &scene(Chapter::HittableList),
            &png::encode(&output.picture()),
            0,
        ) else {
            panic!("{name} is another picture");
        };
        assert_eq!(finding.levels, 1);
        assert!(
            names(&finding)[0].iter().any(|found| found == name),
            "{:?}",
            names(&finding)
        );
    }
}

#[test]
fn two_slips_at_once_are_both_named() {
    use Chapter::{Gradient, HalfBSphere, HittableList, Normals, RedSphere};
    for (chapter, one, other) in [
        (HittableList, "minus-h", "times-255"),
        (HittableList, "focal-length-two", "white-and-blue-swapped"),
        (HittableList, "channels-reversed", "closest-ignored"),
        (HittableList, "rows-from-below", "far-root"),
        (HittableList, "minus-h", "range-not-tested"),
        (HalfBSphere, "minus-h", "behind-drawn"),
        (Normals, "plus-b", "behind-drawn"),
        (Normals, "oc-reversed", "behind-drawn"),
        (
            Gradient,
            "direction-not-normalized",
            "blend-without-brackets",
        ),
        (
            RedSphere,
            "sum-with-swapped-letter",
            "divided-with-swapped-letter",
        ),
    ] {
        let scene = scene(chapter);
        let output = scene.program(&[slip(one), slip(other)]).run(120);
        let wrong = check(&scene, &png::encode(&output.picture()), 0);
        let finding = wrong.finding().expect("it is wrong");
        let sets = names(finding);
        let both = |names: &String| names.contains(one) && names.contains(other);
        assert!(
            sets.iter().flatten().any(both),
            "{one} and {other}: {sets:?}"
        );
        assert_eq!(
            finding.diagnosis.sets.iter().map(|set| set.explains).min(),
            Some(Explains::All)
        );
    }
}

/// As who types another height, and keeps the viewport of the book.
#[test]
fn a_viewport_of_the_books_shape_is_named_in_a_picture_of_another() {
    let slip = slip("ideal-viewport-ratio");
    for edition in [Edition::V4, Edition::V3, Edition::V1InDouble] {
        let scene = scene(Chapter::Normals);
        let chosen = Program {
            image_height: |width, _| (0.75 * width) as u32,
            ..scene.only_by(edition).program(&[])
        };
        let output = slip.put_to(chosen).run(120);
        let wrong = check(&scene, &png::encode(&output.picture()), 0);
        let names = names(wrong.finding().expect("it is wrong"));
        assert!(
            names[0].iter().any(|name| name == slip.name),
            "{edition}: {names:?}"
        );
    }
}

#[test]
fn a_slip_that_explains_most_is_named_with_what_is_left() {
    let mut rgb = slip("far-root")
        .program(Chapter::Normals)
        .run(200)
        .picture()
        .rgb()
        .to_vec();
    // A stripe that no slip draws.
    rgb[3 * 200 * 5..3 * 200 * 7].fill(9);
    let picture = Picture::from_rgb(200, 112, rgb).expect("the same size");
    let wrong = check(&scene(Chapter::Normals), &png::encode(&picture), 0);
    let finding = wrong.finding().expect("it is wrong");
    let set = &finding.diagnosis.sets[0];
    assert_eq!(set.mistakes[0][0].name, "far-root");
    assert_eq!(set.explains, Explains::Most);
    assert_eq!((set.fit.far, set.fit.compared), (400, 200 * 112));
}

#[test]
fn a_probe_tells_a_set_apart() {
    let output = slip("minus-h").program(Chapter::HalfBSphere).run(100);
    let wrong = check(
        &scene(Chapter::HalfBSphere),
        &png::encode(&output.picture()),
        0,
    );
    let set = &wrong.finding().expect("it is wrong").diagnosis.sets[0];
    let telling = set.telling.as_ref().expect("a probe");
    assert_eq!(telling.probe.name, "behind");
    let place = |name| {
        set.mistakes
            .iter()
            .position(|mistake| mistake[0].name == name)
    };
    let group = |name| {
        telling
            .groups
            .iter()
            .position(|group| group.contains(&place(name).expect("in the set")))
    };
    assert_eq!(group("minus-h"), group("oc-reversed"));
    assert_ne!(group("minus-h"), group("discriminant-with-four"));
}

#[test]
fn in_a_probe_the_probe_is_judged() {
    let probe = slips::find_probe("inside").expect("a probe");
    let scene = Scene::new(Chapter::HittableList, Some(probe)).expect("room for a sphere");
    let draw = |slips: &[&Slip]| png::encode(&scene.program(slips).run(64).picture());
    assert_eq!(check(&scene, &draw(&[]), 0).exit_code(), 0);
    let wrong = check(&scene, &draw(&[slip("face-normal-missing")]), 0);
    assert!(
        names(wrong.finding().expect("wrong"))[0]
            .iter()
            .any(|name| name == "face-normal-missing")
    );
    assert!(Scene::new(Chapter::Gradient, Some(probe)).is_none());
}

#[test]
fn a_wrong_shape_is_named_with_the_slips_that_give_it() {
    for (name, chapter) in [
        ("integer-aspect-ratio", Chapter::HittableList),
        ("inverted-aspect-ratio", Chapter::Gradient),
        ("height-rounded", Chapter::Normals),
    ] {
        let text = slip(name).program(chapter).run(97).to_string();
        let doubted = check(&scene(chapter), text.as_bytes(), 0);
        assert_eq!(doubted.exit_code(), 1);
        let Check::Right(right) = doubted else {
            panic!("{name} draws what is right in its shape");
        };
        assert!(right.shape_given_by.iter().any(|slip| slip.name == name));
    }
    let text = slip("header-swapped")
        .program(Chapter::RedSphere)
        .run(97)
        .to_string();
    let wrong = check(&scene(Chapter::RedSphere), text.as_bytes(), 0);
    assert_eq!(wrong.exit_code(), 1, "it is a picture");
    let Check::WrongShape { cause, finding } = wrong else {
        panic!("its rows are torn as well");
    };
    assert_eq!(cause.name, "wrong-shape");
    assert!(cause.fix.contains("header-swapped"), "{cause}");
    let named = names(&finding.expect("it has pixels"));
    assert!(named[0].iter().any(|found| found == "header-swapped"));
}

#[test]
fn a_shape_that_no_slip_gives_was_chosen_and_is_right() {
    for (chapter, width, height) in [
        (Chapter::BuildTest, 40, 30),
        (Chapter::Normals, 64, 48),
        (Chapter::HittableList, 100, 30),
    ] {
        let picture = png::encode(&scene(chapter).right(width, height));
        let Check::Right(right) = check(&scene(chapter), &picture, 0) else {
            panic!("{chapter:?} at {width} × {height} is refused");
        };
        assert!(right.scene.has_another_shape());
    }
}

#[test]
fn numbers_that_are_no_levels_name_the_mistake_that_prints_them() {
    for (name, chapter, words) in [
        ("times-256", Chapter::BuildTest, "above 255, up to 256"),
        ("normal-not-mapped", Chapter::Normals, "below 0"),
        (
            "normal-only-shifted",
            Chapter::HalfBSphere,
            "above 255, up to 511",
        ),
        ("minus-h", Chapter::HittableList, "below 0"),
    ] {
        let text = slip(name).program(chapter).run(80).to_string();
        let Check::NotAPicture { cause, finding } = check(&scene(chapter), text.as_bytes(), 0)
        else {
            panic!("{name} prints no valid picture");
        };
        assert_eq!(cause.name, "levels-outside");
        assert!(cause.problem.contains(words), "{cause}");
        assert!(
            names(&finding.expect("it has pixels"))[0]
                .iter()
                .any(|found| found == name)
        );
    }
}

#[test]
fn nan_as_cpp_prints_it_does_not_hide_the_mistake() {
    let output = slip("focal-length-forgotten")
        .program(Chapter::Gradient)
        .run(17);
    // Seventeen columns and nine rows have a middle, where the ray is no ray.
    let mut lines: Vec<String> = output.to_string().lines().map(str::to_owned).collect();
    lines[3 + 4 * 17 + 8] = "-2147483648 -2147483648 -2147483648".to_owned();
    let wrong = check(&scene(Chapter::Gradient), lines.join("\n").as_bytes(), 0);
    assert_eq!(
        names(wrong.finding().expect("it has pixels"))[0][0],
        "focal-length-forgotten"
    );
}

#[test]
fn levels_that_wrap_around_do_not_hide_the_mistake() {
    let output = slip("normal-only-shifted")
        .program(Chapter::Normals)
        .run(80);
    let rgb = output.pixels().flatten().map(|level| level as u8).collect();
    let (width, height) = output.size();
    let picture = Picture::from_rgb(width, height, rgb).expect("the same size");
    let wrong = check(&scene(Chapter::Normals), &png::encode(&picture), 0);
    assert_eq!(
        names(wrong.finding().expect("wrong"))[0],
        ["normal-only-shifted"]
    );
}

#[test]
fn a_sphere_elsewhere_is_the_readers_own() {
    const SMALL: &[Ball] = &[Ball::new(0.0, 0.0, -1.0, 0.4)];
    const ASIDE: &[Ball] = &[Ball::new(0.3, 0.0, -1.0, 0.5)];
    for world in [SMALL, ASIDE] {
        let right = Program::right(Chapter::Normals);
        let picture = Program { world, ..right }.run(160).picture();
        let Check::Near(finding) = check(&scene(Chapter::Normals), &png::encode(&picture), 0)
        else {
            panic!("{world:?} is no mistake");
        };
        let near = finding.diagnosis.near.expect("what it is");
        assert!(near.is_exact());
        assert_eq!(near.scene.chosen.balls, [Some(world[0]), None]);
    }
}

#[test]
fn several_rays_a_pixel_are_the_next_chapter_and_no_mistake() {
    for chapter in [Chapter::RedSphere, Chapter::Normals, Chapter::HittableList] {
        // Sixteen pixels of a picture four times as wide are one with sixteen rays.
        let fine = chapter.picture(4 * 160);
        let level = |n: usize| {
            let (i, j, channel) = (n / 3 % 160, n / 3 / 160, n % 3);
            let at = |k: usize| ((4 * j + k / 4) * 4 * 160 + 4 * i + k % 4) * 3 + channel;
            let sum: u32 = (0..16).map(|k| u32::from(fine.rgb()[at(k)])).sum();
            (sum / 16) as u8
        };
        let rgb = (0..160 * 90 * 3).map(level).collect();
        let picture = Picture::from_rgb(160, 90, rgb).expect("its size");
        let but = but(chapter, &picture);
        assert!(
            matches!(but[..], [But::Antialiased { .. }]),
            "{chapter:?}: {but:?}"
        );
    }
}

#[test]
fn levels_on_a_curve_are_told_with_its_power() {
    for chapter in [Chapter::BuildTest, Chapter::Gradient, Chapter::Normals] {
        let right = chapter.picture(200);
        let raised = |level: &u8| (255.999 * (f64::from(*level) / 255.0).powf(1.0 / 2.2)) as u8;
        let rgb = right.rgb().iter().map(raised).collect();
        let picture = Picture::from_rgb(200, right.height(), rgb).expect("its size");
        let but = but(chapter, &picture);
        let [But::Curve(curve)] = &but[..] else {
            panic!("{chapter:?}: {but:?}");
        };
        let power = curve.power.expect("it is one");
        assert!((power - 1.0 / 2.2).abs() < 0.03, "{power}");
    }
}

/// What a picture has that the book's does not have, if it is no mistake.
fn but(chapter: Chapter, picture: &Picture) -> Vec<But> {
    let check = check(&scene(chapter), &png::encode(picture), 0);
    let Check::Near(finding) = check else {
        panic!("{chapter:?}: {check:?}");
    };
    finding.diagnosis.near.expect("what it is").but
}

#[test]
fn what_no_slip_draws_is_described() {
    const TWO: &[Ball] = &[
        Ball::new(0.0, 0.0, -1.0, 0.5),
        Ball::new(0.6, 0.0, -1.0, 0.2),
    ];
    let right = Program::right(Chapter::Normals);
    let two = Program {
        world: TWO,
        ..right
    }
    .run(160)
    .picture();
    let two = seen(Chapter::Normals, &two);
    assert!(two.contains("an ellipse"), "{two}");
    let banded = Program {
        lerp: |_, a| Color::new(0.2, 0.4, 0.6) * (7.0 * a).fract(),
        ..Program::right(Chapter::HittableList)
    };
    let banded = seen(Chapter::HittableList, &banded.run(160).picture());
    assert!(banded.contains("Only the sky is wrong"), "{banded}");
    let gray = Picture::from_rgb(16, 9, vec![77; 16 * 9 * 3]).expect("its size");
    assert!(seen(Chapter::Gradient, &gray).contains("Every pixel has the same color"));
}

#[test]
fn the_picture_of_another_chapter_is_known_as_such() {
    let normals = png::encode(&normals::picture(160));
    let Check::Another { cause, scenes } = check(&scene(Chapter::RedSphere), &normals, 0) else {
        panic!("it is no disc in one color");
    };
    assert_eq!(cause.name, "another-chapter");
    assert!(
        cause.problem.contains("a picture of the chapter normals"),
        "{cause}"
    );
    assert_eq!(scenes[0].chapter, Chapter::Normals);
}

#[test]
fn no_shape_and_no_numbers_are_too_odd_for_a_diagnosis() {
    for chapter in Chapter::OF_THE_BOOK {
        for (width, height) in [
            (1, 1),
            (1, 2),
            (2, 1),
            (1, 700),
            (700, 1),
            (3, 2),
            (16, 9),
            (9, 16),
        ] {
            for numbers in [
                [0, 0, 0],
                [255, 255, 255],
                [-1, 256, 0],
                [i16::MIN, i16::MAX, 7],
            ] {
                let pixel = numbers.map(|number| number.to_string()).join(" ") + "\n";
                let pixels = pixel.repeat(width * height);
                let text = format!("P3\n{width} {height}\n255\n{pixels}");
                let code = check(&scene(chapter), text.as_bytes(), 0).exit_code();
                let is_picture = numbers.iter().all(|number| (0..256).contains(number));
                // Twice as wide as high is the shape of versions 1 to 3.0.
                let has_shape =
                    scene(chapter).height(width as u32) == height as u32 || width == 2 * height;
                assert_eq!(
                    code == 2,
                    has_shape && !is_picture,
                    "{chapter:?}, {width} × {height}, {numbers:?}"
                );
            }
        }
    }
}

#[test]
fn a_mirrored_or_moved_picture_is_described() {
    let right = Program::right(Chapter::HittableList).run(160);
    let pixels: Vec<[i32; 3]> = right.pixels().collect();
    let moved = |place: fn(usize) -> usize, order: [usize; 3]| {
        let rgb = (0..160 * 90).flat_map(|n| order.map(|channel| pixels[place(n)][channel] as u8));
        seen(
            Chapter::HittableList,
            &Picture::from_rgb(160, 90, rgb.collect()).expect("the same size"),
        )
    };
    let turned = moved(|n| 160 * 90 - 1 - n, [0, 1, 2]);
    assert!(turned.contains("viewport-mirrored"), "{turned}");
    assert!(moved(|n| n, [1, 2, 0]).contains("Its red is what green should be"));
    let shifted = moved(|n| (n + 1).min(160 * 90 - 1), [0, 1, 2]);
    assert!(
        shifted.contains("moved by 1 pixel to the left"),
        "{shifted}"
    );
}

#[test]
fn of_100_mistakes_95_are_named_first_or_in_a_set_with_the_probe_that_decides() {
    let (mut named, mut missed) = (0, Vec::new());
    for chapter in Chapter::OF_THE_BOOK {
        let scene = scene(chapter);
        let right = chapter.picture(60);
        for slip in scene.slips() {
            let picture = slip.program(chapter).run(60).picture();
            if picture == right {
                continue;
            }
            let check = check(&scene, &png::encode(&picture), 0);
            let finding = check.finding();
            let is_decided = |finding| is_decided(&scene, finding, slip);
            match gives_the_shape(slip, &check) || finding.is_some_and(is_decided) {
                true => named += 1,
                false => missed.push(format!("{} in {chapter:?}", slip.name)),
            }
        }
    }
    println!("{named} are named, these are not: {missed:#?}");
    assert!(95 * missed.len() <= 5 * named, "{missed:#?}");
}

/// Whether it is the first mistake that the reader is told of, or one of several with
/// the probe that decides. Nothing does if all of them draw the same in every probe, as
/// rows from below and a viewport that is upside down.
fn is_decided(scene: &Scene, finding: &Finding, slip: &Slip) -> bool {
    let Some(set) = finding.diagnosis.sets.first() else {
        return false;
    };
    let is_it = |mistake: &Vec<&Slip>| mistake.len() == 1 && mistake[0].name == slip.name;
    let draw_the_same = |probe: Probe| {
        let drawn = |scene: &Scene, mistake| scene.program(mistake).run(probe.width).picture();
        Scene::new(scene.chapter, Some(probe)).is_none_or(|scene| {
            let first = drawn(&scene, &set.mistakes[0]);
            let mut others = set.mistakes.iter();
            others.all(|mistake| drawn(&scene, mistake) == first)
        })
    };
    let nothing_decides = || PROBES.into_iter().all(draw_the_same);
    is_it(&set.mistakes[0])
        || (set.mistakes.iter().any(is_it) && (set.telling.is_some() || nothing_decides()))
}

/// Saved as PNG, as the text of C++ at another size, and with some levels off by
/// one: the slip is always named in the first set.
fn is_named(slip: &Slip) {
    for &chapter in slip.chapters {
        let scene = scene(chapter);
        let drawn = |width| {
            let output = slip.program(chapter).run(width);
            let seen = output.picture() != scene.program(&[]).run(width).picture();
            // Other tests tell why nothing shows some slips, and which probe does.
            seen.then_some(output)
        };
        if let Some(output) = drawn(101) {
            let wrong = check(&scene, &png::encode(&output.picture()), 0);
            assert_first(slip, chapter, &wrong, Explains::All);
        }
        if let Some(output) = drawn(60) {
            let wrong = check(&scene, output.to_string().as_bytes(), 0);
            assert_first(slip, chapter, &wrong, Explains::All);
            let wrong = check(&scene, &png::encode(&with_noise(&output.picture())), 0);
            // Single levels can hide nothing but single levels.
            if wrong.finding().is_some_and(|finding| finding.levels > 2) {
                assert_first(slip, chapter, &wrong, Explains::AllButOneLevel);
            }
        }
    }
}

/// Whether the picture is right but for its shape, which the slip is said to give.
fn gives_the_shape(slip: &Slip, check: &Check) -> bool {
    match check {
        Check::Right(right) => {
            let mut slips = right.shape_given_by.iter();
            slips.any(|given_by| given_by.name == slip.name)
        }
        _ => false,
    }
}

fn assert_first(slip: &Slip, chapter: Chapter, check: &Check, explains: Explains) {
    if gives_the_shape(slip, check) {
        return;
    }
    let finding = check.finding().expect("the picture is wrong");
    let first = finding.diagnosis.sets.first().unwrap_or_else(|| {
        panic!(
            "nothing explains {} in {chapter:?}: {:?}",
            slip.name, finding.diagnosis.sights
        )
    });
    assert!(
        names(finding)[0].iter().any(|names| names == slip.name),
        "{} in {chapter:?} is not among {:?}",
        slip.name,
        names(finding)
    );
    assert!(
        first.explains <= explains,
        "{} in {chapter:?}: {:?}",
        slip.name,
        first.fit
    );
}

/// The names of all mistakes, set by set.
fn names(finding: &Finding) -> Vec<Vec<String>> {
    let sets = finding.diagnosis.sets.iter();
    sets.map(|set| {
        set.mistakes
            .iter()
            .map(|slips| {
                slips
                    .iter()
                    .map(|slip| slip.name)
                    .collect::<Vec<_>>()
                    .join(" + ")
            })
            .collect()
    })
    .collect()
}

/// Every seventh component a level up or down.
fn with_noise(picture: &Picture) -> Picture {
    let mut rgb = picture.rgb().to_vec();
    for (n, level) in rgb.iter_mut().enumerate().step_by(7) {
        *level = if n % 2 == 0 {
            level.saturating_add(1)
        } else {
            level.saturating_sub(1)
        };
    }
    Picture::from_rgb(picture.width(), picture.height(), rgb).expect("the same size")
}

fn scene(chapter: Chapter) -> Scene {
    Scene::new(chapter, None).expect("every chapter has the book's scene")
}

/// What can be seen in the picture, in one text.
fn seen(chapter: Chapter, picture: &Picture) -> String {
    sights(&check(&scene(chapter), &png::encode(picture), 0))
}

fn sights(check: &Check) -> String {
    let finding = check.finding().expect("it is wrong");
    format!(
        "{} {:?}",
        finding.diagnosis.sights.join(" "),
        names(finding)
    )
}
