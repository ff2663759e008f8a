//! A wrong picture is explained: by the slip that draws it, whatever else happened to the
//! file; a right one is right, but for what happened to it.

use std::collections::HashSet;
use std::fs;
use std::path::Path;

use check::evidence::Known;
use check::explanations::{But, Degradation, Quality, Seen};
use check::frame;
use check::guess;
use check::png;
use check::reading::{self, Reading};
use check::scene::{Chosen, Scene};
use check::verdict::{Check, Finding, check, judge, judge_guessed};
use common::rtweekend::*;
use image::imageops::{self, FilterType};
use image::{Pixel, Rgb, RgbImage};
use slips::{self, Ball, Chapter, Edition, Program, Slip, World};

use crate::reading::p6;
use suite::drawn::p3;
use suite::parallel;
use suite::random::Random;
use suite::slip;

/// A metamorphic relation: what is not the reader's mistake does not change the answer.
/// Each in one of its chapters and in one of five ways; the next test has all of them.
#[test]
fn the_picture_of_each_slip_is_named_whatever_happened_to_its_file() {
    let of_all = slips::all().zip(0..);
    let some = of_all.map(|(slip, n)| (slip, slip.chapters[n / 5 % slip.chapters.len()], n % 5));
    parallel::map(&some.collect::<Vec<_>>(), |&(slip, chapter, way)| {
        assert_named(slip, chapter, way);
    });
}

#[test]
#[ignore = "it judges two thousand pictures, which takes a minute"]
fn the_picture_of_each_slip_is_named_in_all_of_these_ways() {
    let in_all = slips::all().flat_map(|slip| slip.chapters.iter().map(move |it| (slip, *it)));
    parallel::map(&in_all.collect::<Vec<_>>(), |&(slip, chapter)| {
        (0..5).for_each(|way| assert_named(slip, chapter, way));
    });
}

#[test]
fn a_right_picture_with_odd_pixels_is_right_but_for_them() {
    for (chapter, width) in Chapter::OF_THE_BOOK.into_iter().zip([90, 90, 90, 90, 227]) {
        let right = chapter.picture(width);
        for odd in [1, 5, 30] {
            let spoiled = with_odd_pixels(&right, odd);
            assert_right_but(chapter, &right, &spoiled);
        }
        let black_row = changed(&right, |_, j| (j == 7).then_some([0; 3]));
        let in_box = |n: u32, from: u32| (from..from + 8).contains(&n);
        let green_box = changed(&right, |i, j| {
            (in_box(i, 30) && in_box(j, 20)).then_some([0, 255, 0])
        });
        assert_right_but(chapter, &right, &black_row);
        assert_right_but(chapter, &right, &green_box);
    }
}

fn assert_right_but(chapter: Chapter, right: &Picture, spoiled: &Picture) {
    let pixels = |picture: &Picture| Reading::of(picture).pixels;
    let [expected, found] = [right, spoiled].map(pixels);
    let differ = expected
        .iter()
        .zip(&found)
        .filter(|(one, other)| one != other);
    let Check::Near(finding) = check(&scene(chapter), &png::encode(spoiled), 0) else {
        panic!("{chapter:?}, {} pixels", differ.count());
    };
    let near = finding.near.as_ref().expect("what it is");
    assert_eq!(
        near.left.off,
        differ.count(),
        "{chapter:?}: {}",
        finding.but()
    );
    assert!(near.but.is_empty() && finding.sets.is_empty() && finding.lead > 10.0);
}

#[test]
fn right_pictures_are_right_in_every_format_and_size() {
    for chapter in Chapter::OF_THE_BOOK {
        for width in [1, 2, 57, 400] {
            let picture = chapter.picture(width);
            for bytes in [png::encode(&picture), p3(&picture)] {
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
fn two_slips_at_once_are_both_named() {
    use Chapter::{Gradient, HalfBSphere, HittableList, Normals};
    for (chapter, one, other) in [
        (HittableList, "minus-h", "times-255"),
        (HittableList, "focal-length-two", "white-and-blue-swapped"),
        (HittableList, "rows-from-below", "far-root"),
        (HittableList, "minus-h", "range-not-tested"),
        (HalfBSphere, "minus-h", "behind-drawn"),
        (Normals, "plus-b", "behind-drawn"),
        (
            Gradient,
            "direction-not-normalized",
            "blend-without-brackets",
        ),
    ] {
        let output = scene(chapter).program(&[slip(one), slip(other)]).run(120);
        let finding = finding(chapter, &output.picture());
        let sets = names(&finding);
        let both = |names: &String| names.contains(one) && names.contains(other);
        assert!(
            sets.iter().flatten().any(both),
            "{one} and {other}: {sets:?}"
        );
        assert!(finding.sets[0].is_exact());
    }
}

#[test]
fn a_slip_is_named_beside_what_it_does_not_explain() {
    let far_root = slip("far-root").program(Chapter::Normals).run(200);
    let striped = changed(&far_root.picture(), |_, j| {
        (5..7).contains(&j).then_some([9; 3])
    });
    let found = finding(Chapter::Normals, &striped);
    assert_eq!(found.sets[0].mistakes[0][0].name, "far-root");
    assert_eq!(found.sets[0].left.off, 400);

    let noisy = with_noise(&far_root.picture());
    let found = finding(Chapter::Normals, &noisy);
    assert_eq!(found.sets[0].mistakes[0][0].name, "far-root");
    assert_eq!(found.sets[0].left.far, 0);

    let several_rays = with_rays(&slip("far-root").program(Chapter::Normals), 10, 0.0);
    let found = finding(Chapter::Normals, &several_rays);
    assert_eq!(found.sets[0].mistakes[0][0].name, "far-root");
    assert!(matches!(found.sets[0].but[..], [But::Antialiased { .. }]));
}

/// What happened to a file is no mistake: a right picture stays right, a slip keeps its
/// name.
#[test]
fn a_picture_is_judged_beyond_what_happened_to_its_file() {
    let right = scene(Chapter::Normals).program(&[]);
    let far_root = slip("far-root").program(Chapter::Normals);
    type Way = fn(&RgbImage) -> RgbImage;
    let ways: [(&str, Way); 4] = [
        ("missing rows", |it| {
            imageops::crop_imm(it, 0, 0, 160, 88).to_image()
        }),
        ("nearest", |it| {
            imageops::resize(it, 320, 180, FilterType::Nearest)
        }),
        ("smooth", |it| {
            imageops::resize(it, 200, 112, FilterType::CatmullRom)
        }),
        ("gray", |it| {
            RgbImage::from_fn(160, 90, |i, j| it.get_pixel(i, j).to_luma().to_rgb())
        }),
    ];
    for (name, way) in ways {
        for (program, slip) in [(right, None), (far_root, Some("far-root"))] {
            let picture = program.run(160).picture();
            let image = RgbImage::from_raw(160, 90, picture.rgb().to_vec()).expect("its size");
            let image = way(&image);
            let (width, height) = image.dimensions();
            let picture = Picture::from_rgb(width, height, image.into_raw()).expect("its size");
            let finding = finding(Chapter::Normals, &picture);
            assert!(finding.degradation.is_some(), "{name}, {slip:?}");
            let first = finding.sets.first().map(|set| set.mistakes[0][0].name);
            assert_eq!(
                (first, finding.near.is_some()),
                (slip, slip.is_none()),
                "{name}"
            );
        }
    }
}

/// An older edition's, a row and a column smaller, with a slip in it.
#[test]
fn a_crop_is_known_by_every_edition() {
    let slip = slip("times-255");
    let program = slip.put_to(Edition::V1InDouble.program(Chapter::Normals));
    let whole = program.run(512).picture();
    let image = RgbImage::from_raw(512, 256, whole.rgb().to_vec()).expect("its size");
    let part = imageops::crop_imm(&image, 0, 1, 511, 255).to_image();
    let part = Picture::from_rgb(511, 255, part.into_raw()).expect("its size");
    let finding = finding(Chapter::Normals, &part);
    let found = (finding.degradation, names(&finding));
    let Some(Degradation::Cropped { corner, .. }) = found.0 else {
        panic!("it is a part of a larger picture, and it is told as {found:?}");
    };
    assert_eq!(
        (corner, &found.1),
        ((0, 1), &vec![vec![slip.name.to_owned()]])
    );
}

/// What is not in its scene is not passed over, be it that several rays a pixel explain the
/// rest, or a sphere elsewhere that a part of an ellipse is like.
#[test]
fn nothing_is_right_that_shows_what_is_not_in_its_scene() {
    const THREE: World = World::of(&[
        Ball::new(0.0, 0.0, -1.0, 0.5),
        Ball::new(0.0, -100.5, -1.0, 100.0),
        Ball::new(0.1, 0.5, -1.0, 0.12),
    ]);
    let three = Program {
        world: THREE,
        ..Program::right(Chapter::HittableList)
    };
    for picture in [three.run(160).picture(), with_rays(&three, 10, 0.0)] {
        let found = finding(Chapter::HittableList, &picture);
        assert!(found.near.is_none(), "{}", found.but());
        assert!(
            matches!(found.sight, Some(Seen::More(_))),
            "{:?}",
            found.sights
        );
    }

    let sky = gradient::picture(160);
    let ellipse = changed(&sky, |i, j| {
        let (x, y) = (f64::from(i) - 79.5, f64::from(j) - 44.5);
        ((x / 25.0).hypot(y / 12.0) < 1.0).then_some([255, 0, 0])
    });
    let found = finding(Chapter::RedSphere, &ellipse);
    assert!(found.near.is_none(), "{}", found.but());
}

/// Where no sphere is drawn, many a slip may be why, be the sky scaled or not.
#[test]
fn slips_that_draw_the_same_are_told_together_whatever_happened_to_the_file() {
    let picture = slip("minus-h")
        .program(Chapter::HalfBSphere)
        .run(160)
        .picture();
    let image = RgbImage::from_raw(160, 90, picture.rgb().to_vec()).expect("its size");
    let image = imageops::resize(&image, 200, 112, FilterType::CatmullRom);
    let scaled = Picture::from_rgb(200, 112, image.into_raw()).expect("its size");
    let scaled = finding(Chapter::HalfBSphere, &scaled);
    assert!(scaled.degradation.is_some());
    let told = names(&finding(Chapter::HalfBSphere, &picture));
    assert!(told[0].len() > 10, "{told:?}");
    assert_eq!(names(&scaled)[0], told[0]);
}

/// What is a level off by another factor was not scaled on its way.
#[test]
fn roundings_are_no_loss() {
    let another_factor = Program {
        level: |component| (256.3 * component).min(255.0) as i32,
        ..Program::right(Chapter::Gradient)
    };
    let found = finding(Chapter::Gradient, &another_factor.run(160).picture());
    assert_eq!(found.degradation, None);
}

/// In a smooth picture another size is as near by a rounding, and by a slip.
#[test]
fn a_smooth_picture_that_was_halved_keeps_its_size_and_edition() {
    let picture = gradient::picture(384);
    let (pixels, _) = picture.rgb().as_chunks::<3>();
    let up = |one: u8, other: u8| one.max(other) - one.abs_diff(other) / 2;
    let mean = |one: [u8; 3], other: [u8; 3]| [0, 1, 2].map(|c| up(one[c], other[c]));
    let two = |n: usize| mean(pixels[n], pixels[n + 1]);
    let corner = |n: usize| n / 192 * 2 * 384 + n % 192 * 2;
    let halved = (0..192 * 108).flat_map(|n| mean(two(corner(n)), two(corner(n) + 384)));
    let halved = Picture::from_rgb(192, 108, halved.collect()).expect("its size");
    let finding = finding(Chapter::Gradient, &halved);
    let from = match finding.degradation {
        Some(Degradation::Scaled { from, .. }) => from,
        other => panic!("{other:?}"),
    };
    assert_eq!((from, finding.editions), ((384, 216), vec![Edition::V4]));
    assert!(finding.near.is_some());
}

/// The pictures are such that other programs made a JPEG of, one with a window around it, and one by
/// stb_image_write.
#[test]
fn a_slip_is_named_through_jpeg() {
    use Chapter::{HittableList, Normals};
    for (chapter, slip, name, percent, is_framed) in [
        (Normals, "far-root", "far_root_jpeg_75.png", 75, false),
        // Its blocks begin where the window does.
        (Normals, "far-root", "far_root_framed_jpeg_85.png", 85, true),
        (Normals, "far-root", "far_root_stb_jpeg_92.png", 92, false),
        // What is left of the right picture may not choose the quality.
        (
            HittableList,
            "background-missing",
            "background_missing_jpeg_75.png",
            75,
            false,
        ),
    ] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("check")
            .join(name);
        let bytes = fs::read(path).expect("it is committed");
        let reading = reading::read(&bytes).expect("it is a picture");
        let (check, reading) = judged_inside(reading, Some(chapter));
        let Check::Wrong(finding) = check else {
            panic!("{name}: it is wrong, and judged as {check:?}");
        };
        assert_eq!(reading.before == (6, 21), is_framed, "{name}");
        let named = finding.sets.first().map(|set| set.mistakes[0][0].name);
        assert_eq!(named, Some(slip), "{name}");
        let Some(Degradation::Jpeg(quality)) = finding.degradation else {
            panic!("{name}: {:?}", finding.degradation);
        };
        let is_by_stb = name.contains("stb");
        let expected = Quality {
            percent,
            has_half_colors: !is_by_stb,
            has_integers: !is_by_stb,
        };
        assert_eq!(quality, expected, "{name}");
    }
}

/// What is lost on the way makes many pictures the same: a disc of one gray may not be told
/// as normals in a palette of grays, nor sparks in the dark as what a black picture leaves.
#[test]
fn a_loss_is_no_evidence_for_a_slip() {
    let red = Program::right(Chapter::RedSphere).run(160).picture();
    let (pixels, _) = red.rgb().as_chunks::<3>();
    let gray = changed(&red, |i, j| {
        (pixels[(j * 160 + i) as usize] == [255, 0, 0]).then_some([120; 3])
    });
    let mut random = Random(5);
    let sparks = changed(&changed_all(&red, |_| 0), |_, _| {
        let is_lit = random.below(30) == 0;
        is_lit.then(|| [(); 3].map(|()| 85 * random.below(4) as u8))
    });
    for (chapter, picture) in [(Chapter::Normals, gray), (Chapter::Gradient, sparks)] {
        let finding = finding(chapter, &picture);
        assert_eq!(names(&finding), [[""; 0]; 0], "{:?}", finding.degradation);
    }
}

/// In the colors of the web, as many of each around a pixel as make up its own.
#[test]
fn a_palette_is_told_though_its_colors_are_mixed() {
    let right = Program::right(Chapter::Normals).run(300).picture();
    let (pixels, _) = right.rgb().as_chunks::<3>();
    let mixed = changed(&right, |i, j| {
        let more = [0.1, 0.6, 0.9, 0.4][(2 * (j % 2) + i % 2) as usize];
        let pixel = pixels[(j * 300 + i) as usize];
        Some(pixel.map(|level| 51 * (f64::from(level) / 51.0 + more) as u8))
    });
    let near = near(Chapter::Normals, &mixed);
    let palette = |but: &But| matches!(but, But::Degraded(Degradation::Palette { .. }));
    assert!(near.but.iter().any(palette), "{:?}", near.but);
}

/// White, with boxes and writing: nothing of a chapter, though white is the color of many.
#[test]
fn a_drawing_on_white_is_no_picture_of_a_chapter() {
    let mut random = Random(7);
    let white = Picture::from_rgb(240, 116, vec![255; 240 * 116 * 3]).expect("its size");
    let drawing = changed(&white, |i, j| {
        let is_box = (20..90).contains(&i) && (10..50).contains(&j);
        let is_line = is_box && (i == 20 || i == 89 || j == 10 || j == 49 || j == 20);
        let is_letter = is_box && i < 60 && j % 9 > 3 && random.below(3) == 0;
        (is_line || is_letter).then_some([0; 3])
    });
    let found = check(&scene(Chapter::Gradient), &png::encode(&drawing), 0);
    let found = found.finding().expect("it has pixels");
    assert!(
        found.is_strange,
        "{:?}, {:?}",
        names(found),
        found.degradation
    );
}

/// As who types another height, and keeps the viewport of the book.
#[test]
fn a_viewport_of_the_books_shape_is_named_in_a_picture_of_another() {
    let slip = slip("ideal-viewport-ratio");
    for edition in [Edition::V4, Edition::V3] {
        let scene = scene(Chapter::Normals);
        let chosen = Program {
            image_height: |width, _| (0.75 * width) as u32,
            ..scene.only_by(edition).program(&[])
        };
        let finding = finding(Chapter::Normals, &slip.put_to(chosen).run(120).picture());
        let names = names(&finding);
        assert!(
            names[0].iter().any(|name| name == slip.name),
            "{edition}: {names:?}"
        );
    }
}

#[test]
fn a_probe_tells_a_set_apart() {
    let output = slip("minus-h").program(Chapter::HalfBSphere).run(100);
    let finding = finding(Chapter::HalfBSphere, &output.picture());
    let set = &finding.sets[0];
    let telling = set.telling.as_ref().expect("a probe");
    assert_eq!(telling.probe.name, "behind");
    let group = |name| {
        let is_it = |place: &usize| set.mistakes[*place][0].name == name;
        let group = telling
            .groups
            .iter()
            .position(|group| group.iter().any(is_it));
        group.expect("it is in the set")
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
    let names = names(wrong.finding().expect("wrong"));
    assert!(names[0].iter().any(|name| name == "face-normal-missing"));
    assert!(Scene::new(Chapter::Gradient, Some(probe)).is_none());
}

#[test]
fn a_wrong_shape_is_named_with_the_slips_that_give_it() {
    for (name, chapter) in [
        ("integer-aspect-ratio", Chapter::HittableList),
        ("inverted-aspect-ratio", Chapter::Gradient),
        ("height-rounded", Chapter::Normals),
    ] {
        let picture = slip(name).program(chapter).run(97).picture();
        let doubted = check(&scene(chapter), &p3(&picture), 0);
        assert_eq!(doubted.exit_code(), 1);
        let Check::Right(right) = doubted else {
            panic!("{name} draws what is right in its shape");
        };
        assert!(right.shape_given_by.iter().any(|slip| slip.name == name));
    }
    let torn = slip("header-swapped").program(Chapter::RedSphere).run(97);
    let wrong = check(&scene(Chapter::RedSphere), &p3(&torn.picture()), 0);
    assert_eq!(wrong.exit_code(), 1, "it is a picture");
    let Check::WrongShape { cause, finding, .. } = wrong else {
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
        ("minus-h", Chapter::HittableList, "below 0"),
    ] {
        let text = slip(name).program(chapter).run(80).to_string();
        let Check::NotAPicture { cause, finding } = check(&scene(chapter), text.as_bytes(), 0)
        else {
            panic!("{name} prints no valid picture");
        };
        assert_eq!(cause.name, "levels-outside");
        assert!(cause.problem.contains(words), "{cause}");
        let names = names(&finding.expect("it has pixels"));
        assert!(names[0].iter().any(|found| found == name));
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
    let names = names(wrong.finding().expect("it has pixels"));
    assert_eq!(names[0][0], "focal-length-forgotten");
}

#[test]
fn levels_that_wrap_around_do_not_hide_the_mistake() {
    let output = slip("normal-only-shifted")
        .program(Chapter::Normals)
        .run(80);
    let rgb = output.pixels().flatten().map(|level| level as u8).collect();
    let (width, height) = output.size();
    let picture = Picture::from_rgb(width, height, rgb).expect("the same size");
    assert_eq!(
        names(&finding(Chapter::Normals, &picture))[0],
        ["normal-only-shifted"]
    );
}

#[test]
fn a_sphere_elsewhere_is_the_readers_own() {
    const SMALL: World = World::of(&[Ball::new(0.0, 0.0, -1.0, 0.4)]);
    const ASIDE: World = World::of(&[Ball::new(0.3, 0.0, -1.0, 0.5)]);
    // In a large picture few programs are measured.
    for (world, width) in [(SMALL, 160), (ASIDE, 160), (ASIDE, 800)] {
        let right = Program::right(Chapter::Normals);
        let picture = Program { world, ..right }.run(width).picture();
        let near = near(Chapter::Normals, &picture);
        assert!(near.left.is_nothing());
        assert_eq!(near.scene.chosen.balls, [Some(world[0]), None]);
    }
}

/// Before version 3.1.0 the viewport is printed in numbers, whatever the picture's shape is.
#[test]
fn an_older_edition_judges_what_it_does_not_know_in_another_shape() {
    let other = Program {
        viewport_width: Some(4.0),
        shade: |_, normal| Color::new(0.3, normal.x.abs(), 0.6),
        ..Program::right(Chapter::HittableList)
    };
    let picture = png::encode(&other.run(160).picture());
    for edition in [Edition::V1, Edition::V3_0] {
        let check = check(&scene(Chapter::Normals).only_by(edition), &picture, 0);
        assert!(matches!(check, Check::WrongShape { .. }), "{check:?}");
    }
}

/// Who keeps the first edition's rays and factor draws in 16:9 all the same.
#[test]
fn the_first_edition_is_known_in_the_shape_of_later_ones() {
    for chapter in [Chapter::Gradient, Chapter::Normals, Chapter::HittableList] {
        for edition in [Edition::V1, Edition::V1InDouble] {
            let first = scene(chapter).only_by(edition);
            let drawn = first.fitting(200, 112).program(&[]).run(200);
            match check(&scene(chapter), &png::encode(&drawn.picture()), 0) {
                Check::Right(right) => assert!(right.scene.edition.is_first(), "{right:?}"),
                other => panic!("{chapter:?}: {other:?}"),
            }
        }
    }
    // Who insists on it gets its pairs of mistakes.
    let first = scene(Chapter::HittableList).only_by(Edition::V1InDouble);
    let slips = ["times-255", "far-root"].map(slip);
    let drawn = first.fitting(200, 112).program(&slips).run(200);
    let picture = png::encode(&drawn.picture());
    let check = check(
        &scene(Chapter::HittableList).only_by(Edition::V1),
        &picture,
        0,
    );
    let named = check.finding().map(names).unwrap_or_default().concat();
    assert!(named.iter().any(|it| it.contains("far-root")), "{named:?}");
}

/// A sky of one's own from white to blue has as much red as green.
#[test]
fn components_are_equal_where_something_is_hit_or_it_is_not_said() {
    let said = |shade| {
        let program = Program {
            sky: [Color::ONE, Color::new(0.0, 0.0, 1.0)],
            world: World::of(&[
                Ball::new(-0.3, 0.1, -1.0, 0.2),
                Ball::new(0.0, -100.5, -1.0, 100.0),
                Ball::new(0.3, -0.1, -1.0, 0.3),
            ]),
            shade,
            ..Program::right(Chapter::HittableList)
        };
        let picture = Reading::of(&program.run(200).picture());
        let (check, _) = judged_inside(picture, None);
        check.shown().join(" ")
    };
    let [own, twice] = [
        said(|_, normal| match (normal.y > 0.9, normal.x > 0.0) {
            (true, _) => Color::new(0.0, 1.0, 0.0),
            (_, true) => Color::new(1.0, 0.0, 1.0),
            _ => Color::new(1.0, 0.0, 0.0),
        }),
        said(|_, normal| Color::new(normal.x.abs(), normal.x.abs(), 0.7)),
    ];
    assert!(
        own.contains("[0, 255, 0]") && !own.contains("equal"),
        "{own}"
    );
    assert!(twice.contains("Red and green are equal"), "{twice}");
}

/// Many mistakes draw little more than a sky, and so does who has the sphere farther away.
#[test]
fn a_small_sphere_of_ones_own_is_found_though_it_says_little() {
    let older = scene(Chapter::RedSphere).only_by(Edition::V1InDouble);
    let program = Program {
        world: World::of(&[Ball::new(0.0, 0.0, -3.0, 1.0)]),
        ..older.program(&[])
    };
    let near = near(Chapter::RedSphere, &program.run(200).picture());
    let said = near.clause(1);
    assert!(
        near.scene.chosen.balls[0].is_some(),
        "a sphere farther away is told as: {said}"
    );
}

/// A sky may be violet by choice, or by red and green that change places.
#[test]
fn colors_of_ones_own_are_told_beside_slips_that_draw_the_same() {
    let said = |mut program: Program| {
        program.sky = [Color::ONE, Color::new(0.7, 0.5, 1.0)];
        let found = finding(Chapter::Gradient, &program.run(400).picture());
        found.sights.join(" ")
    };
    let right = said(Program::right(Chapter::Gradient));
    assert!(right.contains("A right program draws the same"), "{right}");
    let one = said(slip("rows-from-one").program(Chapter::Gradient));
    assert!(one.contains("A program with rows-from-one alone"), "{one}");
}

#[test]
fn colors_and_scale_of_ones_own_are_no_mistake() {
    let mut program = Program::right(Chapter::HittableList);
    program.sky = [Color::new(1.0, 0.9, 0.8), Color::new(0.2, 0.3, 0.8)];
    let picture = program.run(160).picture();
    let near_sky = near(Chapter::HittableList, &picture);
    assert_eq!(
        (near_sky.scene.chosen.sky, near_sky.left.off),
        (Some(program.sky), 0)
    );

    let mut program = Program::right(Chapter::RedSphere);
    program.viewport_height = 2.5;
    let wide = near(Chapter::RedSphere, &program.run(160).picture());
    assert_eq!(
        (wide.scene.chosen.viewport_height, wide.left.off),
        (Some(2.5), 0)
    );

    let mut program = Program::right(Chapter::HittableList);
    program.viewport_width = Some(4.0);
    let stretched = near(Chapter::HittableList, &program.run(160).picture());
    let chosen = stretched.scene.chosen;
    assert_eq!(
        (
            chosen.viewport_width,
            chosen.viewport_height,
            stretched.left.off
        ),
        (Some(4.0), Some(2.0), 0)
    );
}

#[test]
fn a_sky_and_a_disc_of_ones_own_are_known_together() {
    const DISC: Ball = Ball::new(-0.5, 0.2, -1.0, 0.3);
    let mut program = Program::right(Chapter::RedSphere);
    program.sky = [Color::new(1.0, 0.8, 0.6), Color::new(0.3, 0.2, 0.5)];
    program.paint = Color::new(1.0, 1.0, 0.0);
    program.world[0] = DISC;
    let near = near(Chapter::RedSphere, &program.run(200).picture());
    let chosen = near.scene.chosen;
    assert_eq!(
        (chosen.sky, chosen.paint, chosen.balls[0], near.left.off),
        (Some(program.sky), Some(program.paint), Some(DISC), 0)
    );
}

/// With colors of the sky free, another viewport brings the book's sphere nearer to a small one.
#[test]
fn a_scene_of_ones_own_is_known_by_its_sky_first() {
    const SMALL: Ball = Ball::new(0.0, 0.0, -1.0, 0.3);
    let mut program = Program::right(Chapter::HittableList);
    program.sky = [Color::ONE, Color::new(0.3, 0.6, 0.9)];
    program.viewport_height = 1.2;
    program.world[0] = SMALL;
    let near = near(Chapter::HittableList, &program.run(300).picture());
    let chosen = near.scene.chosen;
    assert_eq!(
        (chosen.sky, chosen.viewport_height, chosen.balls),
        (Some(program.sky), Some(1.2), [Some(SMALL), None])
    );
    assert!(near.left.is_nothing(), "{:?}", near.left);
}

/// Each component of a hit's color may be a line in any of the normal's, where no slip is.
#[test]
fn what_a_hit_is_colored_by_is_found_and_a_slip_that_does_it_is_named() {
    let mut program = Program::right(Chapter::HittableList);
    program.own_shade = Some([(0, [-0.25, 0.75]), (2, [0.0, 1.0]), (1, [1.0, 0.0])]);
    let near = near(Chapter::HittableList, &program.run(200).picture());
    assert_eq!(near.scene.chosen.shade, program.own_shade);
    assert!(near.left.is_nothing(), "{:?}", near.left);

    let mut program = Program::right(Chapter::HittableList);
    program.sky = [Color::splat(0.8); 2];
    let wrong = slip("viewport-mirrored").put_to(program);
    let finding = finding(Chapter::HittableList, &wrong.run(200).picture());
    assert_eq!(
        names(&finding)[0],
        ["viewport-mirrored", "columns-backwards"]
    );
}

/// In editions before version 4 a step of the grid is the whole edge.
#[test]
fn a_scene_that_is_a_whole_picture_away_is_not_told_as_moved_by_a_pixel() {
    let mut program = Edition::V3.program(Chapter::Gradient);
    program.corner = [0.5, -0.5];
    let finding = finding(Chapter::Gradient, &program.run(160).picture());
    assert!(
        !finding.sights.iter().any(|sight| sight.contains("moved")),
        "{:?}",
        finding.sights
    );
}

/// It draws what the middle of a larger picture shows, or one with another focal length.
#[test]
fn a_viewport_of_ones_own_is_no_part_of_a_larger_picture() {
    let mut program = Program::right(Chapter::Gradient);
    program.viewport_height = 0.9;
    let near = near(Chapter::Gradient, &program.run(480).picture());
    assert_eq!(near.scene.chosen.viewport_height, Some(0.9));
    assert!(near.left.is_nothing(), "{:?}", near.left);
}

/// A length of directions that is none draws a sky as through a narrower viewport.
#[test]
fn numbers_that_nobody_types_are_not_taken_for_the_readers_own() {
    let mut program = Program::right(Chapter::Gradient);
    program.viewport_height = 1.4253;
    let found = finding(Chapter::Gradient, &program.run(400).picture());
    assert!(found.near.is_none(), "it is right in {:?}", found.near);
    let shown = found.shown.join(" ");
    assert!(shown.contains("viewport about 2.5 wide"), "{shown}");
    program = Program::right(Chapter::RedSphere);
    program.sky = [
        Color::new(0.9963, 0.9971, 1.0),
        Color::new(0.0043, 0.4023, 1.0),
    ];
    let found = finding(Chapter::RedSphere, &program.run(400).picture());
    assert!(found.near.is_none(), "it is right in {:?}", found.near);
}

/// Three units away, in twentieths of one.
#[test]
fn numbers_of_ones_own_are_found_by_an_older_edition() {
    let mut program = Edition::V1InDouble.program(Chapter::RedSphere);
    program.viewport_height = 0.5;
    program.world[0] = Ball::new(0.0, 0.15, -3.0, 1.0);
    let near = near(Chapter::RedSphere, &program.run(512).picture());
    assert_eq!(near.scene.edition, Edition::V1InDouble);
}

/// As by other numbers; what a file lost is alike only in a block.
#[test]
fn what_is_off_in_waves_is_not_nearly_right() {
    let right = gradient::picture(200);
    let (pixels, _) = right.rgb().as_chunks::<3>();
    let waves = changed(&right, |i, j| {
        let higher = (5.0 * (f64::from(i) / 40.0).sin()) as i16;
        let pixel = pixels[(j * 200 + i) as usize];
        Some(pixel.map(|level| (i16::from(level) + higher).clamp(0, 255) as u8))
    });
    let found = finding(Chapter::Gradient, &waves);
    assert!(!found.is_blurred, "it is nearly right: {:?}", names(&found));
}

/// Of three small spheres none is the chapter's, and all are told.
#[test]
fn a_scene_of_ones_own_with_more_in_it_is_not_right() {
    const WORLD: World = World::of(&[
        Ball::new(-0.6, 0.0, -1.0, 0.1),
        Ball::new(0.0, -20.1, -1.0, 20.0),
        Ball::new(0.0, 0.1, -1.0, 0.1),
        Ball::new(0.6, 0.0, -1.0, 0.1),
    ]);
    let world = WORLD;
    let right = Program::right(Chapter::HittableList);
    let finding = finding(
        Chapter::HittableList,
        &Program { world, ..right }.run(200).picture(),
    );
    assert!(finding.near.is_none(), "{}", finding.but());
    assert!(
        finding
            .sights
            .iter()
            .any(|sight| sight.contains("other spheres")),
        "{:?}",
        finding.sights
    );
}

/// Who has named no chapter has not drawn the sky of one and a sphere besides.
#[test]
fn a_sphere_in_other_colors_is_no_addition_to_a_chapter_without_one() {
    let program = Program {
        world: World::of(&[Ball::new(0.2, 0.1, -1.0, 0.15)]),
        shade: |_, normal| Color::new(normal.x.abs(), 0.1, normal.y.abs()),
        ..Program::right(Chapter::Normals)
    };
    let picture = Reading::of(&program.run(200).picture());
    let (check, _) = judged_inside(picture, None);
    let sights = &check.finding().expect("it is not right").sights;
    let is_more = |sight: &String| sight.contains("something more");
    assert!(!sights.iter().any(is_more), "{sights:?}");
}

/// A white sky is drawn by slips, and by who wants one.
#[test]
fn colors_that_a_reader_may_have_chosen_are_told_beside_slips() {
    let mut program = Program::right(Chapter::RedSphere);
    program.sky = [Color::ONE; 2];
    let finding = finding(Chapter::RedSphere, &program.run(200).picture());
    assert!(
        names(&finding)
            .concat()
            .contains(&"white-in-full".to_owned())
    );
    let said = finding.sights.join(" ");
    assert!(
        said.contains("a sky of (1, 1, 1)"),
        "who wants a white sky is told of slips alone: {said}"
    );
}

/// A line of one edition may be right in the next one: red downwards, green to the right, blue 63.
#[test]
fn mistakes_that_are_told_together_are_of_one_edition() {
    let right = Program::right(Chapter::BuildTest);
    let both = slip("quarter-blue").put_to(slip("red-and-green-swapped").put_to(right));
    let finding = finding(Chapter::BuildTest, &both.run(100).picture());
    let set = &finding.sets[0];
    let drawn = both.run(100).picture();
    for mistake in &set.mistakes {
        let picture = set.scene.program(mistake).run(100).picture();
        assert!(picture == drawn, "{:?}", names(&finding));
    }
}

/// Who follows edition 1 in another shape has its viewport as it is printed, and no aspect ratio.
#[test]
fn a_printed_viewport_is_no_slip_in_another_shape() {
    let mut program = Edition::V1InDouble.program(Chapter::Gradient);
    program.aspect_ratio = 1.5;
    let near = near(Chapter::Gradient, &program.run(300).picture());
    let chosen = near.scene.chosen;
    assert_eq!(chosen.viewport_width, Some(4.0));
    assert!(near.left.is_nothing(), "{:?}", near.left);
}

/// Scaled in a border with a line in it, and in a window; with a slip, and with nothing of the
/// book's.
#[test]
fn what_lies_in_a_frame_is_judged_by_itself() {
    let drawn = |program: Program| {
        let picture = program.run(160).picture();
        RgbImage::from_raw(160, 90, picture.rgb().to_vec()).expect("its size")
    };
    let enlarged = |image: RgbImage| imageops::resize(&image, 320, 180, FilterType::Nearest);
    let judged = |image: RgbImage| {
        let (width, height) = image.dimensions();
        let picture = Picture::from_rgb(width, height, image.into_raw()).expect("its size");
        let (check, reading) = judged_inside(Reading::of(&picture), None);
        (check, (reading.width, reading.height))
    };
    let right = Program::right(Chapter::Normals);
    let far_root = slip("far-root").put_to(right);
    let (check, size) = judged(bordered(&enlarged(drawn(right))));
    assert!(matches!(check, Check::Near(_)), "{check:?}");
    assert_eq!(size, (320, 180));
    let (check, size) = judged(framed(&drawn(right)));
    assert!(matches!(check, Check::Right(_)), "{check:?}");
    assert_eq!(size, (160, 90));
    for wrong in [
        bordered(&enlarged(drawn(far_root))),
        framed(&drawn(far_root)),
    ] {
        let (check, _) = judged(wrong);
        let finding = check.finding().expect("it is wrong");
        assert_eq!(names(finding)[0], ["far-root"]);
    }
    let (check, size) = judged(bordered(&RgbImage::from_fn(96, 54, |i, j| {
        Rgb([(i * j) as u8, (i + j) as u8, 0])
    })));
    assert!(!matches!(check, Check::Right(_) | Check::Near(_)));
    assert_eq!(size, (126, 94), "what is not known is judged as a whole");
    // Whose sides are blurred.
    let unknown = RgbImage::from_fn(96, 54, |i, j| Rgb([i as u8, 90, (i + j) as u8]));
    let (_, (width, height)) = judged(imageops::blur(&bordered_plainly(&unknown), 1.0));
    assert!(width < 106 && height < 64, "its border is no part of it");
}

#[test]
fn a_build_test_of_ones_own_is_told_as_ramps() {
    let right = Program::right(Chapter::BuildTest).run(100).picture();
    let levels = |n: u32| (255.999 * f64::from(n) / 99.0) as u8;
    let own = changed(&right, |i, j| Some([255, levels(99 - j), levels(i)]));
    // As high as half its width, and rows are divided by that.
    let low = vec![0; 3 * 100 * 50];
    let low = Picture::from_rgb(100, 50, low).expect("its size");
    let low = changed(&low, |i, j| Some([levels(i), levels(49 - j), 51]));
    let cut = changed(&own, |_, j| (j == 99).then_some([0; 3]));
    for (picture, told) in [
        (
            cut,
            "from 0/99 to 99/99, but for 100 of 10000 pixels in columns 0 to 99, row 99.",
        ),
        (
            own,
            "red is 255 everywhere, green rises upwards from 0/99 to 99/99, and blue rises to the right from 0/99 to 99/99",
        ),
        (
            low,
            "green rises upwards from 0/99 to 49/99, and blue is 51 everywhere",
        ),
    ] {
        let sights = finding(Chapter::BuildTest, &picture).sights;
        assert!(
            sights[0].contains(told),
            "it should be told that {told}: {sights:?}"
        );
    }
}

/// Eleven rays a pixel, divided by ten.
#[test]
fn a_sum_that_is_divided_wrongly_is_one_factor_on_all_colors() {
    let mut program = Program::right(Chapter::HittableList);
    program.level = |component| (255.999 * (1.1 * component).min(1.0)) as i32;
    let near = near(Chapter::HittableList, &program.run(400).picture());
    let said = near.clause(1);
    assert!(
        said.contains("with all colors 1.1 times the book's"),
        "{said}"
    );
}

#[test]
fn a_sum_that_is_not_divided_is_told_with_its_number_of_rays() {
    let program = Program {
        level: |component| (255.999 * 100.0 * component) as i32,
        ..Program::right(Chapter::HittableList)
    };
    let text = program.run(100).to_string();
    let check = check(&scene(Chapter::HittableList), text.as_bytes(), 0);
    let fix = check.cause().map(|cause| cause.fix.as_str());
    assert!(
        fix.is_some_and(|fix| fix.contains("100 times white")),
        "of a sum of 100 rays it is told: {fix:?}"
    );
}

/// One pixel in a hundred, so that all else is right.
#[test]
fn a_part_that_is_not_explained_is_described() {
    let right = Program::right(Chapter::Gradient).run(400).picture();
    let is_inside = |i, j| (100..130).contains(&i) && (50..80).contains(&j);
    let changed = changed(&right, |i, j| is_inside(i, j).then_some([10, 200, 30]));
    let found = finding(Chapter::Gradient, &changed);
    assert!(found.near.is_some());
    let said = found.shown.join(" ");
    let color = "has one color, [10, 200, 30]";
    assert!(
        said.contains(color),
        "of the box it is not told that it {color}: {said}"
    );
}

/// Whoever counts rows from below and both loops from one draws what lies to the right and above.
#[test]
fn both_loops_from_one_are_a_slip_in_every_edition() {
    for (edition, up) in [
        (Edition::V4, -1),
        (Edition::V1InDouble, 1),
        (Edition::V1, 1),
    ] {
        let right = edition.program(Chapter::Gradient);
        let from_one = slip("loops-from-one").put_to(right);
        let [expected, drawn] = [right, from_one].map(|it| it.run(200).picture());
        let pixel = |picture: &Picture, i: usize, j: usize| {
            let (pixels, _) = picture.rgb().as_chunks::<3>();
            pixels[j * 200 + i]
        };
        let above = 50_usize.checked_add_signed(-up).expect("a row inside");
        assert_eq!(pixel(&drawn, 30, 50), pixel(&expected, 31, above));
        let wrong = slip("times-255").put_to(from_one);
        let finding = finding(Chapter::Gradient, &wrong.run(200).picture());
        let pair = ["loops-from-one and times-255"];
        assert_eq!(names(&finding)[0], pair, "{edition:?}");
    }
}

#[test]
fn a_slip_is_named_beside_colors_and_scale_of_ones_own() {
    let mut program = Program::right(Chapter::HittableList);
    program.sky = [Color::new(1.0, 0.9, 0.8), Color::new(0.2, 0.3, 0.8)];
    program.viewport_height = 3.0;
    let wrong = slip("times-255").put_to(program);
    let finding = finding(Chapter::HittableList, &wrong.run(200).picture());
    // No white shows whether 1.0 becomes 255.
    assert_eq!(names(&finding)[0], ["times-255", "times-255-clamped"]);
    assert_eq!(finding.sets[0].scene.chosen.sky, Some(program.sky));
    // What the reader chose is no mistake, and a level is all that the slip takes.
    assert_eq!(finding.levels, 1);
}

#[test]
fn several_rays_a_pixel_are_the_next_chapter_and_no_mistake() {
    for chapter in [Chapter::RedSphere, Chapter::Normals, Chapter::HittableList] {
        for count in [10, 50] {
            let near = near(chapter, &with_rays(&Program::right(chapter), count, 0.0));
            let [
                But::Antialiased {
                    samples: Some(told),
                    is_lower: false,
                },
            ] = near.but[..]
            else {
                panic!("{chapter:?}, {count} rays: {:?}", near.but);
            };
            assert!(
                (0.6..1.6).contains(&(told / count as f64)),
                "{told} of {count}"
            );
            assert_eq!(near.scene.edition, Edition::V4);
        }
    }
}

/// As version 3 has them in its rows from below, and as who counts rows from above has them.
#[test]
fn several_rays_are_right_by_an_edition_whichever_way_rows_are_counted() {
    let program = scene(Chapter::HittableList)
        .only_by(Edition::V3)
        .program(&[]);
    for lower in [-1.0, 0.0] {
        let near = near(Chapter::HittableList, &with_rays(&program, 10, lower));
        assert_eq!(near.scene.edition, Edition::V3);
        let said = near.clause(1);
        assert_eq!(said.contains("up to a row lower"), lower == 0.0, "{said}");
    }
}

#[test]
fn several_rays_beside_the_pixel_are_a_mistake() {
    for chapter in [Chapter::RedSphere, Chapter::Normals, Chapter::HittableList] {
        let corner = slip("grid-not-inset").program(chapter);
        let named = names(&finding(chapter, &with_rays(&corner, 10, 0.0)));
        assert!(named[0].contains(&"grid-not-inset".to_owned()), "{named:?}");
        let lower = finding(chapter, &with_rays(&Program::right(chapter), 10, -0.5));
        assert!(lower.near.is_none(), "{chapter:?}: {}", lower.but());
        let said = lower.sights.join(" ");
        assert!(
            said.contains("half a pixel too far up"),
            "{chapter:?}: {said}"
        );
    }
}

/// Rays of version 3 through the middles of pixels: nothing there changes by chance.
#[test]
fn rays_that_all_lie_elsewhere_are_not_anywhere() {
    let program = scene(Chapter::HittableList)
        .only_by(Edition::V3)
        .program(&[]);
    let moved = slip("deltas-from-last-pixel").put_to(program);
    let found = finding(Chapter::HittableList, &moved.run(200).picture());
    assert_eq!(names(&found)[0], ["deltas-from-last-pixel"]);
    let mut other = Program::right(Chapter::HittableList);
    other.inset = [0.8, 0.1];
    let found = finding(Chapter::HittableList, &other.run(200).picture());
    assert!(found.near.is_none(), "right, but {}", found.but());
}

const WITH_ANOTHER: World = World::of(&[
    Ball::new(0.0, 0.0, -1.0, 0.5),
    Ball::new(2.0, 1.4, -2.0, 0.3),
]);

/// A sphere more that is seen in a corner, beside a slip and several rays.
#[test]
fn what_is_more_is_told_beside_a_slip_and_several_rays() {
    let mut program = slip("times-255").program(Chapter::Normals);
    program.world = WITH_ANOTHER;
    let found = finding(Chapter::Normals, &with_rays(&program, 50, 0.0));
    assert_eq!(names(&found)[0], ["times-255"]);
    let said = found.sights.join(" ");
    let more = "something more is drawn";
    assert!(
        said.contains(more),
        "of the second sphere it is not told that {more}: {said}"
    );
}

/// Rays a part of a pixel higher or lower move edges by less than anybody would move a sphere.
#[test]
fn nobody_chose_what_is_nearly_the_books() {
    let right = Program::right(Chapter::HittableList);
    for lower in [-0.1, 0.2] {
        let near = near(
            Chapter::HittableList,
            &wide_with_rays(400, &right, 100, lower),
        );
        assert_eq!(near.scene.chosen, Chosen::default(), "{}", near.clause(1));
    }
}

/// A narrow view, in which the sky's colors alone tell of the slip.
#[test]
fn the_scale_of_levels_is_known_whatever_the_viewport_is() {
    let mut program = slip("times-255").program(Chapter::Normals);
    program.viewport_height = 2.0 * f64::to_radians(10.0).tan();
    program.world[0] = Ball::new(0.0, 0.05, -3.0, 0.4);
    let found = finding(Chapter::Normals, &program.run(200).picture());
    let named = names(&found).concat();
    assert!(named.contains(&"times-255".to_owned()), "{named:?}");
    let clause = found.sets[0].scene.clause().unwrap_or_default();
    assert!(clause.contains("a field of view of 20 degrees"), "{clause}");
}

/// A clamp at 0.99 takes two levels from the blue of all the sky.
#[test]
fn several_rays_excuse_no_surface_that_is_off() {
    let right = with_rays(&Program::right(Chapter::HittableList), 30, 0.0);
    let clamped = changed_all(&right, |level| level.min(253));
    let found = finding(Chapter::HittableList, &clamped);
    assert!(found.near.is_none(), "right, but {}", found.but());
}

/// A sky that a doubled weight makes the book's again.
#[test]
fn a_slip_that_numbers_of_ones_own_undo_is_none() {
    let program = scene(Chapter::Normals).only_by(Edition::V3_0).program(&[]);
    let program = Program {
        level: |component| (255.0 * component).ceil() as i32,
        ..program
    };
    let found = finding(Chapter::Normals, &program.run(200).picture());
    let own = |it: &&check::verdict::Set| it.scene.chosen.sky.is_some();
    assert_eq!(
        found.sets.iter().filter(own).count(),
        0,
        "{:?}",
        names(&found)
    );
}

#[test]
fn one_ray_anywhere_in_a_pixel_is_no_mistake() {
    for chapter in [Chapter::Normals, Chapter::HittableList] {
        let near = near(chapter, &with_rays(&Program::right(chapter), 1, 0.0));
        assert!(
            matches!(near.but[..], [But::Antialiased { samples: Some(told), .. }] if told < 1.5),
            "{chapter:?}: {:?}",
            near.but
        );
    }
}

#[test]
fn levels_on_a_curve_are_told_with_its_power() {
    for chapter in [Chapter::BuildTest, Chapter::Gradient, Chapter::Normals] {
        let raised = |level: &u8| (255.999 * (f64::from(*level) / 255.0).powf(1.0 / 2.2)) as u8;
        let right = chapter.picture(200);
        let rgb = right.rgb().iter().map(raised).collect();
        let picture = Picture::from_rgb(200, right.height(), rgb).expect("its size");
        let but = near(chapter, &picture).but;
        let [But::Curve(curve)] = &but[..] else {
            panic!("{chapter:?}: {but:?}");
        };
        let power = curve.power.expect("it is one");
        assert!((power - 1.0 / 2.2).abs() < 0.03, "{power}");
    }
    // The mean of several rays had fractions of levels before.
    let rooted = Program {
        level: |mean| (255.0 * mean.sqrt()) as i32,
        ..Program::right(Chapter::HittableList)
    };
    let but = near(Chapter::HittableList, &with_rays(&rooted, 20, 0.0)).but;
    assert!(
        matches!(but[..], [But::Antialiased { .. }, But::Curve(_)]),
        "{but:?}"
    );
}

/// As through the corner of a viewport, by divisions of integers; and as of nothing but normals.
#[test]
fn one_color_is_told_as_the_book_has_it() {
    for (color, words) in [
        ([155, 195, 255], "a corner of a viewport 2 wide"),
        ([191, 217, 255], "straight ahead"),
        ([255, 0, 0], "does every ray count as a hit"),
        ([127, 255, 127], "a normal of (0, 1, 0)"),
        ([201, 201, 201], "is each division"),
    ] {
        let picture = Picture::from_rgb(20, 20, color.repeat(400)).expect("its size");
        let shown = finding(Chapter::Gradient, &picture).shown.join(" ");
        assert!(shown.contains(words), "{color:?}: {shown}");
    }
}

/// Rows that rise to the right, and a picture that is moved by a part of its width.
#[test]
fn a_sky_is_known_through_whatever_camera() {
    let right = Program::right(Chapter::Gradient);
    let rising = Program {
        viewport_u: |width, _| Vec3::new(width, 0.5 * width, 0.0),
        ..right
    };
    let moved = Program {
        corner: [0.55, 0.5],
        ..right
    };
    for (program, words) in [
        (rising, "a row led along (3.5, 1.8)"),
        (moved, "moved by 20 pixels to the"),
    ] {
        let shown = finding(Chapter::Gradient, &program.run(400).picture())
            .shown
            .join(" ");
        assert!(shown.contains("is the book's sky"), "{shown}");
        assert!(shown.contains(words), "{shown}");
    }
}

#[test]
fn the_picture_of_another_chapter_is_known_as_such() {
    let normals = png::encode(&with_odd_pixels(&normals::picture(160), 3));
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
fn what_nothing_known_draws_is_described() {
    let banded = Program {
        lerp: |_, a| Color::new(0.2, 0.4, 0.6) * (7.0 * a).fract(),
        ..Program::right(Chapter::HittableList)
    };
    let black = Picture::paint(128, 96, |_, _| Color::ZERO);
    for (chapter, picture, words) in [
        (
            Chapter::HittableList,
            banded.run(160).picture(),
            "Where spheres should be all is right",
        ),
        (
            Chapter::Gradient,
            changed_all(&gradient::picture(16), |_| 77),
            "the same color",
        ),
        (Chapter::Gradient, black, "Every pixel is black"),
    ] {
        let found = finding(chapter, &picture);
        assert!(!found.is_strange, "{chapter:?}");
        let said = found.sights.join(" ");
        let (names, near) = (names(&found), found.but());
        assert!(
            said.contains(words),
            "{chapter:?}: {said}; {names:?}; {near}"
        );
    }
}

/// Whatever the program is, what can be measured in its picture is told.
#[test]
fn a_picture_of_ones_own_is_described_surface_by_surface() {
    const TWO: World = World::of(&[
        Ball::new(-0.6, 0.2, -1.0, 0.4),
        Ball::new(0.5, -0.1, -1.0, 0.3),
    ]);
    let own = Program {
        world: TWO,
        ..Program::right(Chapter::HittableList)
    };
    let shown = |picture: &Picture| finding(Chapter::Gradient, picture).shown.join(" ");
    let sky = gradient::picture(400);
    let under = |picture: &Picture, sky_of: fn(u32, u32) -> u32| {
        changed(picture, |i, j| {
            let at = 3 * (j * 400 + i) as usize;
            let is_sky = picture.rgb()[at..at + 3] == sky.rgb()[at..at + 3];
            let level = sky_of(i, j) as u8;
            is_sky.then_some([255 - level, 10, level])
        })
    };
    let two = shown(&under(&own.run(400).picture(), |_, j| j));
    for words in [
        "changes in equal steps from row to row",
        "as if around (-0.6, 0.2, -1) with the radius 0.4, is colored by its normal",
        "as if around (0.5, -0.1, -1) with the radius 0.3, is colored by its normal",
    ] {
        assert!(two.contains(words), "{two}");
    }
    let books = shown(&under(&hittable_list::picture(400), |i, j| (i + j) / 3));
    assert!(
        books.contains("in equal steps along rows and columns"),
        "{books}"
    );
    assert!(books.contains("is what hittable_list has there"), "{books}");
    assert!(
        books.contains("The book's sphere, in the columns 135 to 264"),
        "{books}"
    );
    let right = hittable_list::picture(400);
    // As by a sum of vectors with a wrong letter.
    let own = under(&right, |i, j| (i + j) / 3);
    let (pixels, _) = own.rgb().as_chunks::<3>();
    let twice = pixels
        .iter()
        .flat_map(|[_, green, blue]| [*blue, *green, *blue]);
    let twice = Picture::from_rgb(400, 225, twice.collect()).expect("its size");
    let twice = shown(&twice);
    assert!(twice.contains("Red and blue are equal"), "{twice}");
    // What a viewer makes of a header whose width and height are exchanged.
    let exchanged = Picture::from_rgb(225, 400, right.rgb().to_vec()).expect("its size");
    let rows = shown(&exchanged);
    assert!(rows.contains("Rows of 400 pixels would fit"), "{rows}");
}

/// Rays that are off a sphere's middle are the darker, down to what lies behind; and by several rays
/// a pixel, all edges are mixed.
#[test]
fn what_has_no_edge_everywhere_is_described_by_itself() {
    let shown = |picture: &Picture| finding(Chapter::Gradient, picture).shown.join(" ");
    let black = Picture::from_rgb(400, 225, vec![0; 3 * 400 * 225]).expect("its size");
    let glow = shown(&changed(&black, |i, j| {
        let off = f64::from(i.abs_diff(200)).hypot(f64::from(j.abs_diff(112)));
        Some([(255.0 - 4.0 * off).max(0.0) as u8, 0, 0])
    }));
    for words in ["has one color, [0, 0, 0]", "[255, 0, 0] in its middle"] {
        assert!(
            glow.contains(words),
            "a red glow on black is told as: {glow}"
        );
    }
    assert!(
        !glow.contains("gray"),
        "red on black is told as gray: {glow}"
    );
    // A sky that is another farther down is one all the same, whatever has edges before it.
    let drifting = shown(&changed(&black, |i, j| {
        let off = f64::from(i.abs_diff(200)).hypot(f64::from(j.abs_diff(60)));
        let (level, more) = (60 + j / 2, j.saturating_sub(112).pow(2) / 200);
        (off > 40.0).then_some([level as u8, (level + more) as u8, 90])
    }));
    assert!(
        !drifting.contains("columns 0 to 399"),
        "one sky is told as two: {drifting}"
    );
    let gray = Program {
        level: |component| (255.0 * component) as i32,
        lerp: |sky, a| Color::splat((1.0 - a) * sky[0].x + a * sky[1].x),
        shade: |_, normal| Color::splat(0.5 * (normal.x + 1.0)),
        ..Program::right(Chapter::HittableList)
    };
    let gray = shown(&wide_with_rays(400, &gray, 12, 0.0));
    assert!(gray.contains("to (0.5, 0.5, 0.5) where it is 1"), "{gray}");
    assert!(gray.contains("is one component printed"), "{gray}");
}

/// As a list that keeps no hit farther than its first sphere's.
#[test]
fn where_a_hit_is_missing_nothing_more_is_drawn() {
    let program = Program {
        in_range: |t_min, t, t_max| t_min < t && t < t_max.min(1.0),
        ..Program::right(Chapter::HittableList)
    };
    let said = finding(Chapter::HittableList, &program.run(400).picture());
    let said = said.sights.join(" ");
    assert!(said.contains("the sky is seen there"), "{said}");
}

/// As a graphics card or another order of operations rounds.
#[test]
fn single_roundings_are_no_mistake_whatever_else_may_draw_them() {
    let right = hittable_list::picture(400);
    let rounded = changed(&right, |i, j| {
        let at = 3 * (j * 400 + i) as usize;
        let [red, green, blue] = [0, 1, 2].map(|c| right.rgb()[at + c]);
        let one_in_many = (j * 400 + i) % 1951 == 7;
        one_in_many.then_some([red ^ 1, green, blue])
    });
    let near = near(Chapter::HittableList, &rounded);
    assert!(near.but.is_empty() && near.left.off > 40, "{near:?}");
    let said = near.clause(90_000);
    assert!(said.contains("another order of operations"), "{said}");
}

/// Who holds a ratio in single precision may lose a row: 400 / 1.7777778 is below 225.
#[test]
fn a_row_that_a_ratio_in_single_precision_loses_is_no_crop() {
    let program = Program {
        image_height: |_, _| 224,
        divisors: |width, height| [width, height],
        level: |component| (255.0 * component) as i32,
        ..Edition::V3.program(Chapter::Normals)
    };
    let found = finding(Chapter::Normals, &program.run(400).picture());
    assert!(found.degradation.is_none(), "{:?}", found.degradation);
    assert_eq!(names(&found)[0], ["times-255"]);
}

/// The next chapter scales by 256, after a clamp.
#[test]
fn the_scale_of_several_rays_is_no_mistake_in_a_scene_of_ones_own() {
    const ELSEWHERE: World = World::of(&[
        Ball::new(0.3, 0.1, -1.0, 0.6),
        Ball::new(0.0, -100.5, -1.0, 100.0),
    ]);
    let program = Program {
        world: ELSEWHERE,
        level: |mean| (256.0 * mean.clamp(0.0, 0.999)) as i32,
        ..Program::right(Chapter::HittableList)
    };
    let found = finding(Chapter::HittableList, &with_rays(&program, 50, 0.0));
    assert!(found.near.is_some(), "{:?}", names(&found));
}

/// Before version 4 the rays of a pixel begin where its single one goes, so one through their
/// middle is a slip.
#[test]
fn several_rays_of_an_older_edition_are_found_through_a_viewport_of_ones_own() {
    let older = scene(Chapter::HittableList).only_by(Edition::V3);
    let program = Program {
        viewport_height: 2.25,
        ..older.program(&[])
    };
    let near = near(Chapter::HittableList, &with_rays(&program, 30, -1.0));
    assert_eq!(near.scene.edition, Edition::V3);
    let said = near.clause(1);
    assert!(said.contains("a viewport 2.25 high"), "{said}");
    assert!(said.contains("antialiased"), "{said}");
}

/// As by several rays that lie beside the pixel, which change nothing else.
#[test]
fn where_only_edges_are_off_it_is_said() {
    let right = Program::right(Chapter::HittableList);
    let shown = |width, lower| {
        let beside = wide_with_rays(width, &right, 8, lower);
        finding(Chapter::HittableList, &beside).shown.join(" ")
    };
    let edges = shown(600, -0.5);
    assert!(edges.contains("So only edges are off"), "{edges}");
    // Of so small a sphere the normals are others, too.
    let more = shown(100, -0.5);
    assert!(
        !more.is_empty() && !more.contains("So only edges"),
        "{more}"
    );
}

#[test]
fn a_picture_of_many_surfaces_is_told_as_that() {
    let grid = changed(&gradient::picture(200), |i, j| {
        (i % 40 < 20 && j % 40 < 20).then_some([(i % 256) as u8, 90, 20])
    });
    let shown = finding(Chapter::Gradient, &grid).shown.join(" ");
    assert!(shown.contains("into 16 pieces"), "{shown}");
}

/// As a material of a later chapter draws what is hit, before and after gamma correction.
#[test]
fn a_sky_with_its_outlines_is_known_whatever_colors_are_hit() {
    let world = Program::right(Chapter::HittableList);
    const SMALLER: World = World::of(&[
        Ball::new(0.0, 0.0, -1.0, 0.3),
        Ball::new(0.0, -100.5, -1.0, 100.0),
    ]);
    let smaller = Program {
        world: SMALLER,
        ..world
    };
    let corrected = Program {
        level: |component| (256.0 * component.sqrt().min(0.999)) as i32,
        ..world
    };
    for (program, is_shaded) in [(world, true), (corrected, true), (smaller, false)] {
        let mut random = Random(5);
        let sky = Program {
            world: World::of(&[]),
            ..program
        };
        let (sky, right) = (sky.run(200), program.run(200));
        let picture = changed(&sky.picture(), |i, j| {
            let n = j * 200 + i;
            let grain = [(); 3].map(|()| 60 + random.below(40) as u8);
            (sky.pixel(n) != right.pixel(n)).then_some(grain)
        });
        let reading = check::reading::read(&png::encode(&picture)).expect("it is a picture");
        let finding = finding(Chapter::HittableList, &picture);
        let shown = matches!(finding.sight, Some(Seen::Shaded { .. }));
        assert_eq!(shown, is_shaded, "{:?}", finding.sights);
        let guessed = guess::scene(&reading).chapter;
        assert!(
            guessed == Chapter::HittableList || !is_shaded,
            "{guessed:?}"
        );
    }
}

/// A slip of a later chapter may draw an earlier one's picture, and behind a loss one more pixel
/// for it is chance.
#[test]
fn who_names_no_chapter_is_told_the_one_that_is_right() {
    for chapter in [Chapter::Gradient, Chapter::Normals] {
        let right = Program::right(chapter).run(200).picture();
        let (width, height) = (right.width(), right.height());
        let rgb = RgbImage::from_raw(width, height, right.rgb().to_vec()).expect("its size");
        let twice = imageops::resize(&rgb, 2 * width, 2 * height, FilterType::Nearest);
        let twice = Picture::from_rgb(2 * width, 2 * height, twice.into_raw()).expect("its size");
        for picture in [with_noise(&right), twice] {
            let reading = check::reading::read(&png::encode(&picture)).expect("it is a picture");
            let guessed = guess::scene(&reading);
            let (scene, answer) = judge_guessed(&guessed, &reading, 0, &Known::default());
            assert_eq!(scene.chapter, chapter);
            assert!(matches!(answer, Check::Near(_)), "{answer:?}");
        }
    }
}

#[test]
fn a_turned_or_moved_picture_is_described() {
    let right = Program::right(Chapter::HittableList).run(160);
    let pixels: Vec<[i32; 3]> = right.pixels().collect();
    let moved = |place: fn(usize) -> usize, order: [usize; 3]| {
        let rgb = (0..160 * 90).flat_map(|n| order.map(|channel| pixels[place(n)][channel] as u8));
        let picture = Picture::from_rgb(160, 90, rgb.collect()).expect("the same size");
        let finding = finding(Chapter::HittableList, &picture);
        format!("{} {:?}", finding.sights.join(" "), names(&finding))
    };
    let turned = moved(|n| 160 * 90 - 1 - n, [0, 1, 2]);
    assert!(
        turned.contains("viewport") || turned.contains("half a turn"),
        "{turned}"
    );
    assert!(moved(|n| n, [1, 2, 0]).contains("Its red is what green should be"));
    let shifted = moved(|n| (n + 1).min(160 * 90 - 1), [0, 1, 2]);
    assert!(
        shifted.contains("moved by 1 pixel to the left"),
        "{shifted}"
    );
}

/// Sharp lines a pixel or a few from each other.
#[test]
fn no_picture_is_too_small_to_be_in_a_frame() {
    for (width, height) in (1..7).flat_map(|width| (1..7).map(move |height| (width, height))) {
        let quarters = RgbImage::from_fn(width, height, |i, j| {
            Rgb([255 * (2 * i / width) as u8, 255 * (2 * j / height) as u8, 0])
        });
        let picture = Picture::from_rgb(width, height, quarters.into_raw()).expect("its size");
        let (_, judged) = judged_inside(Reading::of(&picture), None);
        assert!(judged.width <= width && judged.height <= height);
    }
}

#[test]
fn no_shape_and_no_numbers_are_too_odd_for_an_answer() {
    let shapes = [
        (1, 1),
        (1, 2),
        (2, 1),
        (1, 700),
        (700, 1),
        (3, 2),
        (16, 9),
        (9, 16),
    ];
    let numbers = [[0; 3], [255; 3], [-1, 256, 0], [i16::MIN, i16::MAX, 7]];
    for (chapter, (width, height), pixel) in Chapter::OF_THE_BOOK.into_iter().flat_map(|chapter| {
        shapes
            .into_iter()
            .flat_map(move |shape| numbers.map(|pixel| (chapter, shape, pixel)))
    }) {
        let reading = Reading {
            width,
            height,
            pixels: vec![pixel; (width * height) as usize],
            before: (0, 0),
            encoding: None,
        };
        let code = judge(&scene(chapter), &reading, 0, &Known::default()).exit_code();
        let is_picture = pixel.iter().all(|number| (0..256).contains(number));
        assert_eq!(
            code == 2,
            !is_picture,
            "{chapter:?}, {width} × {height}, {pixel:?}"
        );
    }
}

/// The picture, unless it is right by some edition: other tests tell which law or probe
/// shows such a slip.
fn visible(slip: &Slip, chapter: Chapter, width: u32) -> Option<Picture> {
    let drawn = slip.program(chapter).run(width);
    let (columns, rows) = drawn.size();
    if columns == 0 || rows == 0 {
        return None;
    }
    let picture = drawn.picture();
    let is_right = |edition: Edition| edition.program(chapter).run(width).picture() == picture;
    (!Edition::ALL.into_iter().any(is_right)).then_some(picture)
}

/// As C++ prints it, with numbers that are no levels; as P6; as a wider PNG; with an odd
/// pixel; with five.
fn assert_named(slip: &Slip, chapter: Chapter, way: usize) {
    let width = if way == 2 { 101 } else { 60 };
    let Some(picture) = visible(slip, chapter, width) else {
        return;
    };
    let bytes = match way {
        0 => slip.program(chapter).run(width).to_string().into_bytes(),
        1 => p6(&picture),
        2 => png::encode(&picture),
        3 => png::encode(&with_odd_pixels(&picture, 1)),
        _ => png::encode(&with_odd_pixels(&picture, 5)),
    };
    let check = check(&scene(chapter), &bytes, 0);
    let gives_the_shape = match &check {
        Check::Right(right) => right.shape_given_by.iter().any(|it| it.name == slip.name),
        Check::WrongShape { cause, .. } => cause.fix.contains(slip.name),
        _ => false,
    };
    let named = check.finding().map(names).unwrap_or_default();
    let is_first = named
        .first()
        .is_some_and(|names| names.iter().any(|name| name == slip.name));
    assert!(
        gives_the_shape || is_first,
        "{} in {chapter:?}, way {way}: {named:?} {:?}",
        slip.name,
        check
            .finding()
            .map(|finding| (&finding.near, &finding.sights))
    );
}

/// The names of all mistakes, set by set.
fn names(finding: &Finding) -> Vec<Vec<String>> {
    let sets = finding.sets.iter();
    let names = |slips: &Vec<&'static Slip>| check::names_of(slips);
    sets.map(|set| set.mistakes.iter().map(names).collect())
        .collect()
}

fn finding(chapter: Chapter, picture: &Picture) -> Finding {
    match check(&scene(chapter), &png::encode(picture), 0) {
        Check::Near(finding) | Check::Wrong(finding) => finding,
        Check::WrongShape { finding, .. } => *finding.expect("it has pixels"),
        other => panic!("{chapter:?}: {other:?}"),
    }
}

fn near(chapter: Chapter, picture: &Picture) -> check::verdict::Near {
    let finding = finding(chapter, picture);
    let (sets, sights) = (names(&finding), finding.sights);
    finding
        .near
        .unwrap_or_else(|| panic!("{chapter:?}: {sets:?} {sights:?}"))
}

fn scene(chapter: Chapter) -> Scene {
    Scene::new(chapter, None).expect("every chapter has the book's scene")
}

/// Judged as the command does it, and what was judged.
fn judged_inside(reading: Reading, named: Option<Chapter>) -> (Check, Reading) {
    let known = Known::default();
    let judge = |reading: &Reading| {
        Ok::<_, ()>(match named {
            Some(chapter) => {
                let scene = scene(chapter);
                (scene, judge(&scene, reading, 0, &known))
            }
            None => judge_guessed(&guess::scene(reading), reading, 0, &known),
        })
    };
    let (_, check, reading) = frame::judge_inside(reading, judge).expect("no error");
    (check, reading)
}

/// In a border with a line in it.
fn bordered(picture: &RgbImage) -> RgbImage {
    let (width, height) = picture.dimensions();
    let mut border = RgbImage::from_pixel(width + 30, height + 40, Rgb([90; 3]));
    let line = RgbImage::from_pixel(width + 10, height + 10, Rgb([240; 3]));
    let gap = RgbImage::from_pixel(width + 6, height + 6, Rgb([90; 3]));
    imageops::replace(&mut border, &line, 10, 12);
    imageops::replace(&mut border, &gap, 12, 14);
    imageops::replace(&mut border, picture, 15, 17);
    border
}

fn bordered_plainly(picture: &RgbImage) -> RgbImage {
    let (width, height) = picture.dimensions();
    let mut border = RgbImage::from_pixel(width + 30, height + 40, Rgb([255; 3]));
    imageops::replace(&mut border, picture, 15, 17);
    border
}

/// In a window with a title and a thin border.
fn framed(picture: &RgbImage) -> RgbImage {
    let mut window = RgbImage::from_pixel(164, 112, Rgb([60, 63, 70]));
    for i in (20..60).step_by(3) {
        window.put_pixel(i, 9, Rgb([220; 3]));
    }
    imageops::replace(&mut window, picture, 2, 20);
    window
}

/// The picture with some pixels replaced.
fn changed(picture: &Picture, mut change: impl FnMut(u32, u32) -> Option<[u8; 3]>) -> Picture {
    let (width, height) = (picture.width(), picture.height());
    let (pixels, _) = picture.rgb().as_chunks::<3>();
    let pixels = (0..).zip(pixels);
    let rgb = pixels.flat_map(|(n, pixel)| change(n % width, n / width).unwrap_or(*pixel));
    Picture::from_rgb(width, height, rgb.collect()).expect("the same size")
}

fn changed_all(picture: &Picture, change: fn(u8) -> u8) -> Picture {
    let rgb = picture.rgb().iter().map(|&level| change(level)).collect();
    Picture::from_rgb(picture.width(), picture.height(), rgb).expect("the same size")
}

/// So many pixels, anywhere, in colors that no picture here has.
fn with_odd_pixels(picture: &Picture, count: usize) -> Picture {
    let (width, height) = (picture.width() as usize, picture.height() as usize);
    let mut random = Random(count as u64);
    let mut places = HashSet::new();
    while places.len() < count.min(width * height) {
        places.insert((random.below(width) as u32, random.below(height) as u32));
    }
    changed(picture, |i, j| {
        places.contains(&(i, j)).then_some([250, 3, 7])
    })
}

/// Every seventh component a level up or down.
fn with_noise(picture: &Picture) -> Picture {
    let mut rgb = picture.rgb().to_vec();
    for (n, level) in rgb.iter_mut().enumerate().step_by(7) {
        *level = match n % 2 {
            0 => level.saturating_add(1),
            _ => level.saturating_sub(1),
        };
    }
    Picture::from_rgb(picture.width(), picture.height(), rgb).expect("the same size")
}

/// A picture 200 pixels wide, each of which is the mean of so many rays anywhere in it, or
/// in a square that much lower.
fn with_rays(program: &Program, count: usize, lower: f64) -> Picture {
    wide_with_rays(200, program, count, lower)
}

fn wide_with_rays(width: u32, program: &Program, count: usize, lower: f64) -> Picture {
    let camera = program.camera(width);
    let mut random = Random(7);
    let mut anywhere = || random.below(1 << 20) as f64 / f64::from(1 << 20) - 0.5;
    let mut mean = |i: u32, j: u32| {
        let mut ray = || {
            let (x, y) = (f64::from(i) + anywhere(), f64::from(j) + lower + anywhere());
            let [across, up] = (program.divisors)(width.into(), camera.image_height.into());
            let [x, y] = match program.edition.counts_from_below() {
                true => [(x + 0.5) / across, 1.0 - (y + 0.5) / up],
                false => [x, y],
            };
            let point = camera.pixel00 + x * camera.pixel_delta_u + y * camera.pixel_delta_v;
            program.ray_color(&Ray::new(camera.center, point - camera.center))
        };
        let sum = (0..count).fold(Color::ZERO, |sum, _| sum + ray());
        sum.to_array()
            .map(|component| (program.level)(component / count as f64) as u8)
    };
    let (width, height) = (camera.image_width, camera.image_height);
    let pixels = (0..width * height).flat_map(|n| mean(n % width, n / width));
    Picture::from_rgb(width, height, pixels.collect()).expect("its size")
}
