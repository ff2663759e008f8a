//! Mutation testing, turned round: a table of pictures that no known mistake draws, and the line
//! that is named for each.

use check::answer::{Row, RowKind};
use check::context::Context;
use check::judge;
use check::reading::Reading;
use check::sources::Sources;
use check::task::Task;
use slips::{Chapter, ChapterProgram, Edit, Languages};

const GRADIENT: Chapter = Chapter::Gradient;
const RED_SPHERE: Chapter = Chapter::RedSphere;
const NORMALS: Chapter = Chapter::Normals;
const HALF_B: Chapter = Chapter::HalfBSphere;
const LIST: Chapter = Chapter::HittableList;

/// A chapter, a piece of its text, and the wrong text that takes its place.
const MISTAKES: [(Chapter, &str, &str); 12] = [
    (
        GRADIENT,
        "Color::new(0.5, 0.7, 1.0)",
        "Color::new(0.5, 1.0, 0.7)",
    ),
    (GRADIENT, "(1.0 - a) * white", "(1.0 + a) * white"),
    (
        RED_SPHERE,
        "Color::new(1.0, 0.0, 0.0)",
        "Color::new(0.0, 1.0, 0.0)",
    ),
    (
        RED_SPHERE,
        "oc.dot(oc) - radius * radius",
        "oc.dot(oc) - radius",
    ),
    (NORMALS, "-b - discriminant.sqrt()", "-b - discriminant"),
    (
        NORMALS,
        "0.5 * (normal + Vec3::ONE)",
        "0.5 * (normal - Vec3::ONE)",
    ),
    (HALF_B, "h * h - a * c", "h * h - c"),
    (
        HALF_B,
        "ray.direction.length_squared()",
        "ray.direction.length()",
    ),
    (LIST, "oc.length_squared()", "oc.length()"),
    (
        LIST,
        "(record.normal + Vec3::ONE)",
        "(record.point + Vec3::ONE)",
    ),
    (LIST, "0.0, -100.5, -1.0", "0.0, -100.0, -1.0"),
    (
        LIST,
        "[(h - sqrtd) / a, (h + sqrtd) / a]",
        "[(h + sqrtd) / a, (h + sqrtd) / a]",
    ),
];

#[test]
fn the_edit_that_draws_a_picture_is_among_at_most_three_that_are_named() {
    for (chapter, right, wrong) in MISTAKES {
        let rows = rows(chapter, &picture(chapter, right, wrong), Sources::default());
        let named =
            |it: &&Row| [RowKind::Probably, RowKind::Perhaps, RowKind::Or].contains(&it.kind);
        let named: Vec<&Row> = rows.iter().filter(named).collect();
        let is_it = |it: &&Row| it.text.contains(wrong);
        assert!(
            named.len() <= 3 && named.iter().any(is_it),
            "{wrong}: {rows:#?}"
        );
    }
}

/// Many mistakes draw only sky: the one whose line stands in the file is named.
#[test]
fn of_all_edits_that_draw_only_sky_the_one_that_was_typed_is_named() {
    for (right, wrong) in [
        ("oc.dot(oc) - radius", "oc.dot(oc) + radius"),
        ("b * b - 4.0 * a", "b / b - 4.0 * a"),
    ] {
        let mut files = slips::typed_files(RED_SPHERE);
        files[0].text = files[0].text.replace(right, wrong);
        let sources = Sources::of_chapter(files, RED_SPHERE);
        let rows = rows(RED_SPHERE, &picture(RED_SPHERE, right, wrong), sources);
        assert!(rows[0].text.contains(wrong), "{rows:#?}");
    }
}

fn picture(chapter: Chapter, right: &'static str, wrong: &'static str) -> Reading {
    let program = ChapterProgram::right(chapter).with_edits(&[Edit::new(right, wrong)]);
    Reading::of(&program.expect("it is one edit").run(100).picture())
}

fn rows(chapter: Chapter, reading: &Reading, sources: Sources) -> Vec<Row> {
    let context = Context {
        languages: Languages::Rust,
        sources,
        ..Context::default()
    };
    let task = Task::of(chapter);
    let verdict = judge(&task, reading, 0, &context);
    verdict.finding().map_or(Vec::new(), |it| it.rows(&context))
}
