//! One rule holds for each picture, and the page prints them all.

use check::context::Context;
use check::reading::Reading;
use check::rules::RULES;
use check::rules_that_hold;
use check::task::Task;
use common::rtweekend::Picture;
use slips::Chapter::{self, *};
use slips::{ChapterProgram, Edit};

/// Rule, chapter and edit of its text, or an empty one, and the pixels that are changed then.
const PICTURES: [(u8, Chapter, &str, &str, u32); 8] = [
    (1, Normals, "", "", 0),
    (
        2,
        Normals,
        "0.5 * (normal + Vec3::ONE)",
        "Color::new(1.0, 0.0, 0.0)",
        0,
    ),
    (
        3,
        Normals,
        "-b - discriminant.sqrt()",
        "-b + discriminant.sqrt()",
        0,
    ),
    (3, HittableList, "-100.5", "100.5", 5),
    (5, Normals, "", "", 5),
    (
        7,
        RedSphere,
        "Color::new(1.0, 0.0, 0.0)",
        "Color::new(0.0, 1.0, 0.0)",
        0,
    ),
    (
        8,
        RedSphere,
        "Color::new(0.5, 0.7, 1.0)",
        "Color::new(0.2, 0.3, 0.55)",
        0,
    ),
    (
        8,
        Normals,
        "normal + Vec3::ONE",
        "normal * 0.3 + Vec3::new(0.9, 0.8, 1.0)",
        0,
    ),
];

#[test]
fn one_rule_holds_for_each_picture() {
    for (number, chapter, right, wrong, odd) in PICTURES {
        let program = ChapterProgram::right(chapter);
        let edits: Vec<Edit> = (!right.is_empty())
            .then(|| Edit::new(right, wrong))
            .into_iter()
            .collect();
        let program = program.with_edits(&edits).expect("it stands there");
        let picture = with_odd_pixels(&program.run(100).picture(), odd);
        let (task, context) = (Task::of(chapter), Context::default());
        let rules = rules_that_hold(&task, &Reading::of(&picture), &context);
        assert_eq!(rules, [number], "{chapter:?}: {wrong}");
    }
}

#[test]
fn two_slips_that_are_likely_together_are_named_by_rule_6() {
    let slips = ["rows-from-below", "far-root"].map(|name| slips::find(name).expect("a slip"));
    let picture = Task::of(Normals).program(&slips).run(100).picture();
    let rules = rules_that_hold(
        &Task::of(Normals),
        &Reading::of(&picture),
        &Context::default(),
    );
    assert_eq!(rules, [6]);
}

#[test]
fn the_page_prints_the_rules_by_their_numbers() {
    let page = include_str!("../../../../notes/check.md");
    for rule in &RULES {
        let line = format!("\n{}. {}\n", rule.number, rule.condition);
        assert!(page.contains(&line), "{line}");
    }
}

/// Changes so many pixels, spread over the picture.
fn with_odd_pixels(picture: &Picture, count: u32) -> Picture {
    let mut rgb = picture.rgb().to_vec();
    for n in 0..count as usize {
        let at = 3 * ((n * 2_654_435 + 77) % (rgb.len() / 3));
        rgb[at] ^= 0x5a;
    }
    Picture::from_rgb(picture.width(), picture.height(), rgb).expect("its size")
}
