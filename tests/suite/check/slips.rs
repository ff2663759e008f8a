//! Each slip is a program that differs from the right one as it says.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use suite::slip;

use check::comparison::{Comparison, differing_pixels};
use check::diagnosis::Scene;
use common::rtweekend::*;
use hittable_list::{HittableList, Sphere};
use slips::Chapter;
use slips::{self, Ball, Edition, Look, PROBES, Program, Slip};

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
                "{} at {width} wide: the steps in tests/slips/src/program.rs are not those of the \
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
        for ball in program.world {
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
fn the_names_are_distinct_and_lasting() {
    let names: BTreeSet<&str> = slips::all().map(|slip| slip.name).collect();
    assert_eq!(names.len(), slips::all().count(), "two slips share a name");
    for name in names {
        assert!(
            name.bytes()
                .all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'-'),
            "{name} is awkward to type"
        );
    }
}

#[test]
fn the_readme_counts_the_slips() {
    let readme = include_str!("../../../README.md");
    let told = readme.split(" known mistakes").filter_map(|before| {
        let word = before.rsplit(' ').next()?;
        word.parse::<usize>().ok()
    });
    let told: Vec<usize> = told.collect();
    assert_eq!(told, [slips::all().count(); 2], "in README.md");
}

#[test]
fn every_slip_leads_to_a_file_that_has_it_right() {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for Slip { name, source, .. } in slips::all() {
        assert!(workspace.join(source).is_file(), "{name}: {source}");
    }
}

#[test]
fn every_slip_leads_to_a_heading_of_the_book() {
    let notes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/notes");
    for Slip { name, page, .. } in slips::all() {
        let (file, heading) = page.split_once('#').expect("a page and a heading");
        let path = notes.join(file).with_extension("md");
        let text = fs::read_to_string(&path).unwrap_or_else(|cause| {
            panic!("{name} leads to {}: {cause}", path.display());
        });
        let headings: Vec<String> = text.lines().filter_map(heading_address).collect();
        assert!(
            headings.iter().any(|other| other == heading),
            "{name} leads to {page}, but the headings are {headings:?}"
        );
    }
}

/// How mdBook addresses a heading: small letters, digits and hyphens.
fn heading_address(line: &str) -> Option<String> {
    let words = line.strip_prefix("## ").or(line.strip_prefix("### "))?;
    let letter = |letter: char| match letter {
        ' ' => Some('-'),
        '-' | '_' => Some(letter),
        _ => letter
            .is_alphanumeric()
            .then(|| letter.to_ascii_lowercase()),
    };
    Some(words.trim().chars().filter_map(letter).collect())
}

#[test]
fn one_wrong_sign_loses_the_sphere_and_leaves_the_gradient() {
    use Chapter::{HalfBSphere, Normals};
    for (name, chapter) in [
        ("minus-h", HalfBSphere),
        ("plus-b", Normals),
        ("b-sign", Normals),
        ("oc-reversed", Normals),
        ("oc-reversed", HalfBSphere),
        ("focal-length-added", Normals),
        ("focal-length-added", HalfBSphere),
        ("radius-added", HalfBSphere),
        ("b-not-doubled", Normals),
        ("discriminant-with-four", HalfBSphere),
    ] {
        assert_eq!(draw(name, chapter), gradient::picture(400), "{name}");
    }
}

#[test]
fn a_sphere_behind_the_camera_tells_wrong_signs_from_a_wrong_discriminant() {
    const BEHIND: &[Ball] = &[Ball::new(0.0, 0.0, 1.0, 0.5)];
    let found = |name: &str| {
        let program = Program {
            world: BEHIND,
            ..slip(name).program(Chapter::HalfBSphere)
        };
        differing(&program.run(400).picture(), &gradient::picture(400))
    };
    assert_eq!(found("minus-h"), DISC);
    assert_eq!(found("oc-reversed"), DISC);
    assert_eq!(found("focal-length-added"), DISC);
    assert_eq!(found("discriminant-with-four"), 0);
    assert_eq!(found("radius-added"), 0);
}

#[test]
fn a_division_in_place_puts_a_corner_of_the_picture_on_the_axis() {
    let axis = Vec3::new(0.0, 0.0, -1.0);
    let division = [slip("division-in-place")];
    let of_edition = |edition, slips: &[&Slip]| {
        let scene = Scene::new(Chapter::HittableList, None).expect("the book's own scene");
        scene.only_by(edition).program(slips)
    };
    let through = |program: Program, [i, j]: [u32; 2]| {
        let ray = (program.ray)(&program, &program.camera(400), i, j);
        ray.direction
    };
    let [upper_left, upper_right, lower_left] = [[0, 0], [399, 0], [0, 224]];

    assert_eq!(
        through(of_edition(Edition::V4, &division), upper_left),
        axis
    );
    // In version 3 it is the opposite corner, and the picture the lower left quarter.
    let wrong = of_edition(Edition::V3, &division);
    assert_eq!(through(wrong, upper_right), axis);
    let right = of_edition(Edition::V3, &[]);
    assert_eq!(through(wrong, lower_left), through(right, lower_left));
    // The first ones write out the corner and divide nothing.
    let first = [&division[..], &[]].map(|slips| of_edition(Edition::V1InDouble, slips).run(40));
    assert_eq!(first[0].picture(), first[1].picture());
}

#[test]
fn chapter_2_shows_no_sign_but_a_missing_four_paints_everything_red() {
    let red = red_sphere::picture(400);
    for name in ["oc-reversed", "b-sign", "focal-length-added"] {
        assert_eq!(draw(name, Chapter::RedSphere), red, "{name}");
    }
    let flooded = draw("discriminant-without-four", Chapter::RedSphere);
    let rgb = flooded.rgb();
    let (pixels, _) = rgb.as_chunks::<3>();
    assert!(pixels.iter().all(|pixel| *pixel == [255, 0, 0]));
}

#[test]
fn a_radius_that_is_not_squared_makes_the_disc_three_times_as_large() {
    let sky = gradient::picture(400);
    assert_eq!(differing(&red_sphere::picture(400), &sky), DISC);
    let swollen = draw("radius-not-squared", Chapter::RedSphere);
    assert_eq!(differing(&swollen, &sky), 39_768);
}

#[test]
fn a_swapped_letter_in_dot_hides_until_the_last_chapter() {
    let name = "dot-with-swapped-letter";
    for chapter in [Chapter::RedSphere, Chapter::Normals, Chapter::HalfBSphere] {
        let right = chapter.picture(400);
        assert_eq!(draw(name, chapter), right, "{chapter:?}");
    }
    assert_eq!(
        draw(name, Chapter::HittableList),
        draw("faces-swapped", Chapter::HittableList)
    );
}

#[test]
fn an_upside_down_picture_tells_a_flipped_viewport_from_a_flipped_sky() {
    for chapter in Chapter::OF_THE_BOOK.into_iter().skip(1) {
        let flipped = draw("rows-from-below", chapter);
        assert_eq!(
            draw("viewport-upside-down", chapter),
            flipped,
            "{chapter:?}"
        );
        // The red disc is its own mirror image. Colored normals are not.
        assert_eq!(
            draw("white-and-blue-swapped", chapter) == flipped,
            chapter <= Chapter::RedSphere,
            "{chapter:?}"
        );
    }
}

#[test]
fn slips_that_draw_the_same_picture_are_known_as_a_set() {
    use Chapter::{BuildTest, HittableList, Normals};
    for (chapter, one, other) in [
        (BuildTest, "columns-first", "red-and-green-swapped"),
        (BuildTest, "rows-from-below", "green-upwards"),
        (Normals, "focal-length-two", "viewport-height-one"),
        (HittableList, "closest-ignored", "farthest-wins"),
        (HittableList, "minus-h", "oc-reversed"),
    ] {
        assert_eq!(
            draw(one, chapter),
            draw(other, chapter),
            "{one} and {other}"
        );
    }
}

#[test]
fn two_slips_make_a_program_that_has_both() {
    let minus_h = slip("minus-h").program(Chapter::HalfBSphere);
    let both = slip("range-loosened").put_to(minus_h);
    let picture = both.run(400).picture();
    let gradient = gradient::picture(400);
    // The rim is back, the middle is not: there t is less than -1.
    let ring = differing(&picture, &gradient);
    assert!(0 < ring && ring < DISC, "{ring} pixels");
    assert_eq!(both.run(400).pixel(CENTER), [191, 217, 255]);
}

#[test]
fn a_few_pixels_at_the_books_width_tell_slips_apart() {
    use Chapter::{Gradient, HalfBSphere, HittableList, Normals};
    for (name, chapter, place, color) in [
        (
            "direction-not-normalized",
            Gradient,
            UPPER_LEFT,
            [128, 179, 255],
        ),
        (
            "direction-not-normalized",
            Gradient,
            LOWER_RIGHT,
            [255, 255, 255],
        ),
        (
            "divided-by-length-squared",
            Gradient,
            UPPER_LEFT,
            [179, 210, 255],
        ),
        ("viewport-not-centered", Gradient, CENTER, [220, 234, 255]),
        ("times-255", Gradient, CENTER, [191, 216, 255]),
        ("stale-boolean", Normals, CENTER, [255, 127, 127]),
        ("minus-one-is-true", Normals, CENTER, [255, 127, 127]),
        ("minus-one-is-true", Normals, UPPER_LEFT, [16, 190, 127]),
        ("far-root", Normals, CENTER, [129, 127, 0]),
        ("divided-by-a", Normals, CENTER, [255, 127, 127]),
        ("divided-by-two-a", HalfBSphere, CENTER, [128, 127, 255]),
        ("normal-from-point", Normals, CENTER, [128, 127, 0]),
        ("center-added", Normals, CENTER, [128, 127, 0]),
        ("normal-not-unit", Normals, CENTER, [128, 127, 191]),
        ("normal-not-mapped", Normals, CENTER, [1, 0, 255]),
        ("normal-only-halved", Normals, CENTER, [0, 0, 127]),
        ("normal-only-shifted", Normals, CENTER, [257, 255, 511]),
        ("normal-channels-reversed", Normals, CENTER, [255, 127, 128]),
        ("faces-swapped", HittableList, CENTER, [127, 127, 0]),
        ("minus-h", HittableList, UPPER_LEFT, [129, -1, 127]),
        (
            "range-not-tested",
            HittableList,
            UPPER_LEFT,
            [214, 208, 177],
        ),
    ] {
        let output = slip(name).program(chapter).run(400);
        assert_eq!(output.pixel(place), color, "{name} in {chapter:?}");
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
fn the_text_of_a_slip_has_the_numbers_that_a_picture_cannot_hold() {
    let text = |name, chapter| slip(name).program(chapter).run(16).to_string();
    assert!(text("times-256", Chapter::BuildTest).ends_with("\n256 256 0\n"));
    assert!(text("normal-not-mapped", Chapter::Normals).contains('-'));
    assert!(text("header-swapped", Chapter::Gradient).starts_with("P3\n9 16\n255\n"));
}

#[test]
fn what_a_slip_looks_like_has_a_name() {
    use Chapter::{BuildTest, Gradient, HalfBSphere, HittableList, Normals, RedSphere};
    let sights = slips::sights();
    for (name, chapter, look) in [
        ("minus-h", HalfBSphere, Look::Gone),
        ("minus-h", HittableList, Look::Misplaced),
        ("discriminant-without-four", RedSphere, Look::Flooded),
        ("radius-not-squared", RedSphere, Look::Misplaced),
        ("ground-not-added", HittableList, Look::Incomplete),
        ("red-and-green-swapped", BuildTest, Look::Turned),
        ("viewport-upside-down", Gradient, Look::Turned),
        ("viewport-mirrored", Normals, Look::Turned),
        ("far-root", Normals, Look::OtherHits),
        ("white-and-blue-swapped", Normals, Look::OtherSky),
        ("gamma-too-early", Normals, Look::OtherColors),
        ("header-swapped", Gradient, Look::OtherSize),
        ("grid-not-inset", Gradient, Look::Faint),
    ] {
        let sight = sights.iter().find(|sight| {
            let names = || sight.slips.iter().map(|slip| slip.name);
            sight.chapter == chapter && names().any(|other| other == name)
        });
        let found = sight.map(|sight| sight.look);
        assert_eq!(found, Some(look), "{name} in {chapter:?}");
    }
}

#[test]
fn slips_that_share_a_sight_draw_the_same_picture() {
    for sight in slips::sights() {
        for slip in &sight.slips {
            let drawn = slip.program(sight.chapter).run(slips::SIGHT_WIDTH);
            let name = slip.name;
            assert_eq!(
                drawn.picture(),
                sight.picture,
                "{name} in {:?}",
                sight.chapter
            );
        }
    }
}

#[test]
fn a_probe_says_what_to_change() {
    let lines = |name, chapter| {
        let probe = slips::find_probe(name).expect("it is the name of a probe");
        probe.lines(chapter)
    };
    assert_eq!(
        lines("far", Chapter::Normals),
        "image_width = 128\nfocal_length = 1000\ncenter = (0.4, 0.2, -800), radius = 0.5"
    );
    assert_eq!(
        lines("behind", Chapter::HittableList),
        "image_width = 128\nworld.add(sphere((0.3, 0.2, 1), 0.5))"
    );
    assert_eq!(lines("odd-width", Chapter::Gradient), "image_width = 227");
}

/// Pixels of the disc in the book's pictures of one sphere.
const DISC: usize = 13_254;

/// Where these pixels of a picture 400 × 225 are printed.
const UPPER_LEFT: u32 = 0;
const CENTER: u32 = 112 * 400 + 200;
const LOWER_RIGHT: u32 = 225 * 400 - 1;

/// What someone who made that slip gets at the book's width.
fn draw(name: &str, chapter: Chapter) -> Picture {
    slip(name)
        .program(chapter)
        .run(chapter.book_width())
        .picture()
}

fn differing(one: &Picture, other: &Picture) -> usize {
    differing_pixels(one, other).count()
}

fn rays(camera: &Camera) -> Vec<Ray> {
    (0..camera.image_height)
        .flat_map(|j| (0..camera.image_width).map(move |i| camera.ray(i, j)))
        .collect()
}
