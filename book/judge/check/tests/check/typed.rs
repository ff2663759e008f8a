//! Wrong texts, each an edit of a chapter's own: the line that is shown, and what should be there.

use std::thread;

use check::answer::{Row, RowKind};
use check::context::Context;
use check::reading::Reading;
use check::sources::Sources;
use check::task::Task;
use check::{TypedText, judge};
use interpreter::SourceFile;
use slips::Chapter::{self, *};
use slips::{ChapterProgram, Languages};

/// A chapter, a piece of its text, and the wrong text that replaces it.
const MISTAKES: [(Chapter, &str, &str); 22] = [
    (Gradient, "unit_direction.y + 1.0", "unit_direction.y - 1.0"),
    (Gradient, "unit_direction.y + 1.0", "unit_direction.z + 1.0"),
    (Gradient, "+ a * blue", "+ blue"),
    (RedSphere, "center - ray.origin", "center + ray.origin"),
    (RedSphere, "discriminant >= 0.0", "discriminant <= 0.0"),
    (RedSphere, "oc.dot(oc) - radius", "oc.dot(oc) + radius"),
    (Normals, "-2.0 * ray", "2.0 * ray"),
    (Normals, "/ (2.0 * a)", "/ 2.0 * a"),
    (Normals, "- radius * radius", "- radius"),
    (Normals, "ray.at(t) - center", "center - ray.at(t)"),
    (Normals, "(normal + Vec3::ONE)", "normal"),
    (HalfBSphere, "h * h - a * c", "h * h - 4.0 * a * c"),
    (HalfBSphere, "discriminant.sqrt()) / a", "discriminant) / a"),
    (HalfBSphere, "discriminant < 0.0", "discriminant > 0.0"),
    (
        HittableList,
        "(outward_normal) < 0.0",
        "(outward_normal) > 0.0",
    ),
    (HittableList, "t_min, closest_so_far)", "t_min, t_max)"),
    (
        HittableList,
        "(record.point - self.center)",
        "record.point - self.center",
    ),
    (HittableList, "self.radius * self.radius", "self.radius"),
    (HittableList, "-100.5", "100.5"),
    (HittableList, "-100.5", "-99.5"),
    (
        HittableList,
        "[(h - sqrtd) / a, (h + sqrtd) / a]",
        "[(h + sqrtd) / a, (h - sqrtd) / a]",
    ),
    // The picture is right, and the laws' questions are not answered as by the chapter.
    (HittableList, "self.normal = if", "self.normal = -if"),
];

#[test]
fn of_a_text_that_is_typed_the_wrong_line_is_shown_and_the_right_one() {
    let wrong: String = thread::scope(|scope| {
        let threads = MISTAKES.map(|mistake| scope.spawn(move || misjudged(mistake)));
        let said = threads.map(|it| it.join().expect("no answer panics"));
        said.concat()
    });
    assert!(wrong.is_empty(), "\n{wrong}");
}

/// Says what is wrong if the answer does not show the line; empty if it does.
fn misjudged((chapter, right, wrong): (Chapter, &str, &str)) -> String {
    let mut files = slips::typed_files(chapter);
    let file = files.iter_mut().find(|it| it.text.contains(right));
    let file = file.unwrap_or_else(|| panic!("{right} stands in no file"));
    let place = file.text.find(right).expect("it stands there");
    let line = file.text[..place].matches('\n').count() + 1;
    file.text = file.text.replacen(right, wrong, 1);
    let place = format!("{}:{line}  ", file.name);
    let rows = rows(chapter, &files);
    let text = |kind| {
        let row = rows.iter().find(|row| row.kind == kind);
        row.map_or("", |row| &*row.text)
    };
    let (yours, should_be) = (text(RowKind::Yours), text(RowKind::ShouldBe));
    let is_shown = yours.starts_with(&place) && squeezed(yours).contains(&squeezed(wrong));
    match is_shown && squeezed(should_be).contains(&squeezed(right)) {
        true => String::new(),
        false => format!("{chapter:?} {place}{wrong}: {rows:#?}\n"),
    }
}

/// Where the right line of a mistake stands, another mistake that draws the same is named.
#[test]
fn a_right_line_is_not_blamed() {
    let mut files = slips::typed_files(Normals);
    files[0].text = files[0]
        .text
        .replace("center - ray.origin", "ray.origin - center");
    for row in rows(Normals, &files) {
        let is_code = [RowKind::Yours, RowKind::Perhaps, RowKind::Or].contains(&row.kind);
        assert!(
            !is_code || row.text.contains("ray.origin - center"),
            "{row:?}"
        );
    }
}

#[test]
fn a_right_text_gets_no_remark() {
    for chapter in &Chapter::OF_THE_BOOK[1..] {
        assert!(rows(*chapter, &slips::typed_files(*chapter)).is_empty());
    }
}

/// Judges the files of a chapter as the page does, and returns the rows that explain its picture.
fn rows(chapter: Chapter, files: &[SourceFile]) -> Vec<Row> {
    let program = interpreter::read(files).expect("it is a program");
    let asked = ChapterProgram::from_reader(chapter, program.clone());
    let answers = check::lawful::answers_of(&asked, check::lawful::questions(chapter));
    let compare =
        |program: &ChapterProgram| check::lawful::mismatch_with(&answers, chapter, program, 60);
    let picture = program.draw(100).expect("it draws");
    let context = Context {
        languages: Languages::Rust,
        sources: Sources::of_chapter(files.to_vec(), chapter),
        typed: Some(TypedText {
            files,
            program: &program,
        }),
        answers: Some(&compare),
        ..Context::default()
    };
    let verdict = judge(&Task::of(chapter), &Reading::of(&picture), 0, &context);
    verdict.finding().map_or(Vec::new(), |it| it.rows(&context))
}

fn squeezed(text: &str) -> String {
    text.split_whitespace().collect()
}
