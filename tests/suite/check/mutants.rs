//! The chapters run from their own texts, unchanged and changed.

use check::evidence::Known;
use check::mutants::unchanged;
use check::png;
use check::scene::Scene;
use check::sources::Sources;
use check::told::suspected;
use check::verdict::{check, check_knowing};
use common::rtweekend::Vec3;
use slips::{Chapter, Edition, Program, World};

#[test]
fn a_chapter_that_is_run_from_its_text_draws_its_picture() {
    for chapter in [
        Chapter::Gradient,
        Chapter::RedSphere,
        Chapter::Normals,
        Chapter::HalfBSphere,
        Chapter::HittableList,
    ] {
        let picture = unchanged(chapter).run(64).picture();
        assert_eq!(picture, chapter.picture(64), "{chapter:?}");
    }
}

#[test]
fn a_mistake_that_is_in_no_catalogue_is_named_by_its_line() {
    let gradient = Program::right(Chapter::Gradient);
    let normals = Program::right(Chapter::Normals);
    let list = Program::right(Chapter::HittableList);
    let mistakes = [
        (
            Program {
                lerp: |[below, above], a| (1.0 - a) * below - a * above,
                ..gradient
            },
            "(1.0 - a) * white - a * blue",
        ),
        (
            Program {
                discriminant: |a, b, c| b * b - 0.5 * a * c,
                ..normals
            },
            "discriminant = b * b - 0.5 * a * c",
        ),
        (
            Program {
                shade: |_, n| 0.5 * (Vec3::new(n.x, n.z, n.y) + Vec3::ONE),
                ..normals
            },
            "return 0.5 * (Vec3::new(normal.x, normal.z, normal.y) + Vec3::ONE)",
        ),
        (
            Program {
                linear: |d_oc| 0.5 * d_oc,
                ..list
            },
            "h = 0.5 * ray.direction.dot(oc)",
        ),
    ];
    for (program, line) in mistakes {
        let scene = Scene::new(program.chapter, None).expect("a chapter");
        let picture = png::encode(&program.run(100).picture());
        let answer = check(&scene, &picture, 0);
        let finding = answer.finding().expect("it is wrong");
        let rows = finding.rows(&Known::default());
        let is_named = rows.iter().any(|(_, said)| said == line);
        assert!(is_named, "{line}: {}, {rows:?}", finding.but());
    }
}

const HIT_SPHERE: &str = "\
image_height = 1 if image_height < 1 else image_height

def hit_sphere(center, radius, r):
    oc = center - r.origin
    a = dot(r.direction, r.direction)
    h = dot(r.direction, oc)
    c = dot(oc, oc) - radius * radius
    discriminant = h * h - a * c
    if discriminant < 0:
        return None
    return (h - sqrt(discriminant)) / a
";

/// The eye is at zero, so no picture shows what is added to it. Without the question a root
/// is no number, which no picture shows either; and the height is another question.
#[test]
fn a_readers_line_is_run_in_the_chapters_place_and_no_other_is_blamed() {
    let square = "a = dot(r.direction, r.direction)";
    let added = "a = dot(r.direction, r.direction + r.origin)";
    let question = "    if discriminant < 0:\n        return None\n";
    for (old, new, told) in [
        ("", "", None),
        (square, added, Some(added)),
        (question, "", None),
    ] {
        let text = HIT_SPHERE.replacen(old, new, 1);
        let known = with_files(text);
        let scene = Scene::new(Chapter::HalfBSphere, None).expect("a chapter");
        let blamed = known.suspected(&scene).into_iter();
        let blamed: Vec<String> = blamed
            .filter(|slip| slip.name.is_empty())
            .map(|slip| known.words(slip, &scene).wrong.into_owned())
            .collect();
        assert_eq!(blamed, Vec::from_iter(told), "instead of {old:?}: {new:?}");
    }
}

/// Only sky is drawn by dozens of mistakes, in any edition: of these only one that is typed.
#[test]
fn a_picture_that_says_little_names_no_line_that_is_not_typed() {
    let scene = Scene::new(Chapter::HalfBSphere, None).expect("a chapter");
    let doubled = "c = dot(oc, oc) - radius * 2";
    for edition in [Edition::V4, Edition::V3] {
        let sky = Program {
            world: World::of(&[]),
            ..scene.only_by(edition).program(&[])
        };
        let picture = png::encode(&sky.run(200).picture());
        let rows = |text: String| {
            let known = with_files(text);
            let answer = check_knowing(&scene, &picture, 0, &known);
            answer.finding().expect("it is wrong").rows(&known)
        };
        let is_seen = |(label, _): &(&str, String)| *label == "seen";
        let right = rows(HIT_SPHERE.to_owned());
        assert!(right.iter().all(is_seen), "{edition:?}: {right:?}");
        let wrong = rows(HIT_SPHERE.replace("c = dot(oc, oc) - radius * radius", doubled));
        let is_named = wrong.iter().any(|(_, said)| said.ends_with(doubled));
        assert!(is_named, "{edition:?}: {wrong:?}");
    }
}

/// What nobody has typed is said in no language, if the reader's is another than ours.
#[test]
fn a_change_of_the_chapter_is_not_said_in_rust_to_who_writes_python() {
    let scene = Scene::new(Chapter::Normals, None).expect("a chapter");
    let right = Program::right(Chapter::Normals);
    let swapped = Program {
        shade: |_, n| 0.5 * (Vec3::new(n.x, n.z, n.y) + Vec3::ONE),
        ..right
    };
    let picture = png::encode(&swapped.run(100).picture());
    let known = with_files("import math".to_owned());
    let answer = check_knowing(&scene, &picture, 0, &known);
    let rows = answer.finding().expect("it is wrong").rows(&known);
    let line = "return 0.5 * ((normal.x, normal.z, normal.y) + (1, 1, 1))";
    assert!(rows.iter().any(|(_, said)| said == line), "{rows:?}");
}

/// Python works out what stands on a line, and C++ too, and says nothing.
#[test]
fn a_line_that_is_wrong_in_any_program_is_told() {
    let scene = Scene::new(Chapter::HalfBSphere, None).expect("a chapter");
    for (old, new, is_wrong) in [
        ("", "", false),
        ("discriminant = h", "discriminant == h", true),
        ("return (h", "(h", true),
        ("a = dot", "Color(1, 0, 0)\n    a = dot", true),
        (
            "a = dot",
            "red = int(255 * x)\n    green = int(255 * x)\n    a = dot",
            true,
        ),
        (
            "a = dot",
            "red = int(255 * x)\n    green = int(255 * y)\n    a = dot",
            false,
        ),
        // A call does something, and a sum in brackets goes on on the next line.
        ("a = dot", "print", false),
        (
            "c = dot(oc, oc) - ",
            "c = dot(oc, oc) + (\n        -radius * radius\n    ) + ",
            false,
        ),
    ] {
        let known = with_files(HIT_SPHERE.replacen(old, new, 1));
        let rows = suspected(&scene, &known).into_iter();
        let told = rows.filter(|(_, said)| said.ends_with(')') && said.contains("  ("));
        assert_eq!(told.count() == 1, is_wrong, "{new}");
    }
    for (radius, is_wrong) in [("1 / 2", true), ("4 / 2", false), ("1 / 2.0", false)] {
        let file = ("main.cpp".to_owned(), format!("double radius = {radius};"));
        let sources = Sources::new(vec![file], Vec::new());
        let known = Known {
            sources,
            ..Known::default()
        };
        assert_eq!(suspected(&scene, &known).len() == 1, is_wrong, "{radius}");
    }
}

fn with_files(text: String) -> Known<'static> {
    Known {
        sources: Sources::new(vec![("main.py".to_owned(), text)], Vec::new()),
        ..Known::default()
    }
}
