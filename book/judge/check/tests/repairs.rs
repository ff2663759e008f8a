//! Verified repair: a table of wrong programs, each an edit of a right one, and the line that is
//! named.

use std::collections::HashSet;
use std::thread;

use check::answer::{Row, RowKind};
use check::context::Context;
use check::judge;
use check::reading::Reading;
use check::sources::{SourceFile, Sources};
use check::task::Task;
use check::verdict::Verdict;
use slips::{Chapter, ChapterCode, ChapterProgram, Languages, steps};

/// Right programs, each with a piece of its text and the wrong text that replaces it.
const MISTAKES: [(Text, &str, &str); 52] = [
    (GRADIENT, "unit_direction.y + 1.0", "unit_direction.y - 1.0"),
    (GRADIENT, "unit_direction.y + 1.0", "unit_direction.z + 1.0"),
    (GRADIENT, "+ a * blue", "+ blue"),
    (GRADIENT, "ray.direction.normalize()", "ray.direction"),
    (
        GRADIENT,
        "(1.0 - a) * white + a * blue",
        "a * white + (1.0 - a) * blue",
    ),
    (OTHER_GRADIENT, "(dir.y + 1.0) * 0.5", "dir.y + 1.0 * 0.5"),
    (
        OTHER_GRADIENT,
        "(1.0 - t) * from + t * to",
        "(1.0 - t) * to + t * from",
    ),
    (RED_SPHERE, "center - ray.origin", "center + ray.origin"),
    (RED_SPHERE, "4.0 * a * c", "4.0 * a"),
    (RED_SPHERE, "discriminant >= 0.0", "discriminant <= 0.0"),
    (RED_SPHERE, "oc.dot(oc) - radius", "oc.dot(oc) + radius"),
    (NORMALS, "-2.0 * ray", "2.0 * ray"),
    (NORMALS, "/ (2.0 * a)", "/ 2.0 * a"),
    (NORMALS, "- radius * radius", "- radius"),
    (NORMALS, "ray.at(t) - center", "center - ray.at(t)"),
    (
        NORMALS,
        ".normalize();\n        return",
        ";\n        return",
    ),
    (NORMALS, "normal + Vec3::ONE", "normal"),
    (RED_NORMALS, "-2.0 * ray", "2.0 * ray"),
    (RED_NORMALS, "-b - disc", "-b + disc"),
    (RED_NORMALS, "/ (2.0 * a)", "/ 2.0 * a"),
    (GRAY_NORMALS, "-2.0 * ray", "2.0 * ray"),
    (GRAY_NORMALS, "-b - disc", "-b + disc"),
    (GRAY_NORMALS, "/ (2.0 * a)", "/ 2.0 * a"),
    (OTHER_NORMALS, "t > 0.0", "t < 0.0"),
    (OTHER_NORMALS, "n.y + 1.0", "n.z + 1.0"),
    (OTHER_NORMALS, "* -2.0", "* 2.0"),
    (OTHER_NORMALS, "(-b - root)", "(-b + root)"),
    (OTHER_NORMALS, "center - r.origin", "r.origin - center"),
    (OTHER_NORMALS, "b * b - 4.0 * a * c", "b * b - 4.0 * c"),
    (OTHER_NORMALS, "discriminant(a, b", "discriminant(b, a"),
    (HALF_B_SPHERE, "h * h - a * c", "h * h - 4.0 * a * c"),
    (
        HALF_B_SPHERE,
        "discriminant.sqrt()) / a",
        "discriminant) / a",
    ),
    (
        HALF_B_SPHERE,
        "ray.direction.dot(oc)",
        "2.0 * ray.direction.dot(oc)",
    ),
    (HALF_B_SPHERE, "discriminant < 0.0", "discriminant > 0.0"),
    (
        HITTABLE_LIST,
        "ray.direction.dot(outward_normal) < 0.0",
        "ray.direction.dot(outward_normal) > 0.0",
    ),
    (HITTABLE_LIST, "closest_so_far = record.t;\n", "\n"),
    (
        HITTABLE_LIST,
        "record.set_face_normal(ray, outward_normal);\n",
        "\n",
    ),
    (HITTABLE_LIST, "t_min, closest_so_far)", "t_min, t_max)"),
    (
        HITTABLE_LIST,
        "(record.point - self.center)",
        "record.point - self.center",
    ),
    (HITTABLE_LIST, "self.radius * self.radius", "self.radius"),
    (HITTABLE_LIST, "t_min < t && t < t_max", "t < t_max"),
    (HITTABLE_LIST, "-100.5", "100.5"),
    (HITTABLE_LIST, "100.0));\n    world\n", GROUND),
    (
        HITTABLE_LIST,
        "[(h - sqrtd) / a, (h + sqrtd) / a]",
        "[(h + sqrtd) / a, (h - sqrtd) / a]",
    ),
    (OTHER_LIST, "closest = rec.t;\n", "\n"),
    (OTHER_LIST, "low < t && t < high", "low < t"),
    (
        OTHER_LIST,
        "t = (half_b + root) / a",
        "t = (half_b - root) / a",
    ),
    (
        OTHER_LIST,
        "self.normal = -outward",
        "self.normal = outward",
    ),
    (OTHER_LIST, "/ self.radius", "/ self.radius * self.radius"),
    (
        OTHER_LIST,
        "object.hit(r, t_min, closest)",
        "object.hit(r, closest, t_max)",
    ),
    (OTHER_LIST, "if disc < 0.0", "if disc < 1.0"),
    (
        OTHER_LIST,
        "rec.normal + Color::ONE",
        "rec.normal - Color::ONE",
    ),
];

/// Wrong texts whose repair is shown in other words than those that were there: the chapter's.
const IN_OTHER_WORDS: [(&str, &str); 2] = [
    (GROUND, "100.0"),
    (
        "/ self.radius * self.radius",
        "rec.set_face_normal(r, (rec.point - self.center) * (1.0 / self.radius));",
    ),
];

/// A helper whose ground no ray of the picture meets, so that the picture is step 1 to the last
/// bit.
const GROUND: &str = "ground()));
    world
}

fn ground() -> f64 {
    10.0
";

/// A right program: a chapter's, or one in another form.
#[derive(Clone, Copy)]
struct Text {
    chapter: Chapter,
    /// The chapter's text in another form; `None` for its own.
    other: Option<&'static str>,
    /// The color of the sphere after a step; `None` for the whole chapter.
    color: Option<&'static str>,
}

const fn own(chapter: Chapter) -> Text {
    Text {
        chapter,
        other: None,
        color: None,
    }
}

const fn other(chapter: Chapter, text: &'static str) -> Text {
    Text {
        chapter,
        other: Some(text),
        color: None,
    }
}

const GRADIENT: Text = own(Chapter::Gradient);
const OTHER_GRADIENT: Text = other(Chapter::Gradient, include_str!("forms/gradient.rs"));
const RED_SPHERE: Text = own(Chapter::RedSphere);
const NORMALS: Text = own(Chapter::Normals);
const RED_NORMALS: Text = Text {
    color: Some("Color::new(1.0, 0.0, 0.0)"),
    ..NORMALS
};
const GRAY_NORMALS: Text = Text {
    color: Some("t * Color::ONE"),
    ..NORMALS
};
const OTHER_NORMALS: Text = other(Chapter::Normals, include_str!("forms/normals.rs"));
const HALF_B_SPHERE: Text = own(Chapter::HalfBSphere);
const HITTABLE_LIST: Text = own(Chapter::HittableList);
const OTHER_LIST: Text = other(
    Chapter::HittableList,
    include_str!("forms/hittable_list.rs"),
);

#[test]
fn each_mistake_is_named_by_its_line_and_by_what_was_tried() {
    let missed: String = thread::scope(|scope| {
        let halves = MISTAKES.chunks(MISTAKES.len() / 2);
        let all =
            halves.map(|half| scope.spawn(|| half.iter().filter_map(missed).collect::<String>()));
        let all: Vec<_> = all.collect();
        all.into_iter()
            .map(|it| it.join().expect("no row panics"))
            .collect()
    });
    assert!(missed.is_empty(), "\n{missed}");
}

/// Returns the rows of the answer if they don't name the right line.
fn missed(&(text, right, wrong): &(Text, &str, &str)) -> Option<String> {
    let files = text.files();
    let at = files.iter().position(|it| it.text.contains(right));
    let at = at.unwrap_or_else(|| panic!("{right}"));
    let mut changed = files.clone();
    changed[at].text = files[at].text.replacen(right, wrong, 1);
    let lines = |text: &str| -> HashSet<String> { text.lines().map(squeezed).collect() };
    let (before, after) = (lines(&files[at].text), lines(&changed[at].text));
    let mut expected: Vec<String> = before.difference(&after).cloned().collect();
    if let Some((_, line)) = IN_OTHER_WORDS.iter().find(|(it, _)| *it == wrong) {
        expected = vec![(*line).to_owned()];
    }
    let said = said(text.chapter, &changed, true);
    let named = said.iter();
    let named = named.filter(|it| [RowKind::ShouldBe, RowKind::Missing].contains(&it.kind));
    let is_named = |line: &String| {
        said.iter().any(|it| match it.kind {
            RowKind::ShouldBe => it.text == *line,
            RowKind::Missing => it.text.ends_with(line),
            _ => false,
        })
    };
    let is_right = expected.iter().all(is_named) && named.count() == expected.len();
    (!is_right).then(|| format!("{right}  ←  {wrong}\n    {said:?}\n"))
}

#[test]
fn a_right_program_in_another_form_gets_no_remark() {
    for text in [OTHER_GRADIENT, OTHER_NORMALS, OTHER_LIST] {
        assert_eq!(
            said(text.chapter, &text.files(), false),
            [Row::new(RowKind::Laws, "right")]
        );
    }
}

impl Text {
    fn files(self) -> Vec<SourceFile> {
        let mut files = match self.other {
            Some(text) => vec![SourceFile::new("src/lib.rs", text)],
            None => slips::typed_files(self.chapter),
        };
        if let Some(color) = self.color {
            let text = files[0].text.replace("0.5 * (normal + Vec3::ONE)", color);
            files[0].text = text.replace("let normal = (ray.at(t) - center).normalize();", "");
        }
        files
    }
}

/// Judges a program by the picture that it draws in the interpreter, and returns the rows of the
/// answer. A wrong program with a right picture breaks a law.
fn said(chapter: Chapter, files: &[SourceFile], is_wrong: bool) -> Vec<Row> {
    let mut read = files.to_vec();
    read.sort_by_key(|it| it.name != "src/lib.rs");
    let program = interpreter::read(&read).unwrap_or_else(|fault| panic!("{fault}"));
    let picture = program.draw(WIDTH).expect("it draws");
    // Step 1 of the normals shows the red sphere.
    let mut shown = [chapter, Chapter::RedSphere].into_iter();
    let is_hidden = is_wrong && shown.any(|it| picture == it.picture(WIDTH));
    let compare = |_: &ChapterProgram| check::lawful::Mismatch {
        asked: 1,
        differing: 1,
    };
    let context = Context {
        answers: is_hidden.then_some(&compare),
        languages: Languages::Rust,
        sources: Sources::of_chapter(files.to_vec(), chapter),
        // As in a crate of `start`, in which each step on the way is judged.
        steps: vec![false; steps::of_chapter(chapter).len()],
        ..Context::default()
    };
    let task = Task::of(chapter);
    let verdict = judge(&task, &Reading::of(&picture), 0, &context);
    match &verdict {
        Verdict::Right(_) => vec![Row::new(RowKind::Laws, "right")],
        _ => verdict.finding().map_or(Vec::new(), |it| {
            // Also where chapters 3 and 4 draw the same.
            assert_eq!(
                it.task.chapter, chapter,
                "the chapter that the answer names"
            );
            it.rows(&context)
        }),
    }
}

const WIDTH: u32 = 100;

fn squeezed(line: &str) -> String {
    line.split_whitespace().collect::<Vec<_>>().join(" ")
}
