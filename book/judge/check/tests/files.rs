//! A reader's own program beside the picture: its lines are named, and no innocent ones.

use check::answer::{Row, RowKind};
use check::context::Context;
use check::judge_file;
use check::png;
use check::sources::{SourceFile, Sources};
use check::task::Task;
use check::verdict::Verdict;
use common::rtweekend::*;
use slips::{Chapter, ChapterProgram, Edit, Edition, ReaderLanguage};

const PROGRAM: &str = "\
upper_left = camera_center - Vec3(0, 0, focal_length) - viewport_u / 2 - viewport_v / 2
pixel00 = upper_left + 0.5 * (du + dv)

def hit_sphere(center, radius, r):
    oc = center - r.origin
    a = dot(r.direction, r.direction)
    h = dot(r.direction, oc)
    c = dot(oc, oc) - radius * radius
    discriminant = h * h - a * c
    if discriminant < 0:
        return None
    return (h - math.sqrt(discriminant)) / a
";

/// Pairs of edits: of the text in Python, and of the chapter.
#[test]
fn a_readers_line_is_named_if_the_chapter_with_it_draws_the_readers_picture() {
    for ([old, new], [right, wrong]) in [
        (
            [
                "a = dot(r.direction, r.direction)",
                "a = dot(r.direction, oc)",
            ],
            ["ray.direction.length_squared()", "ray.direction.dot(oc)"],
        ),
        (
            ["dot(oc, oc) - radius * radius", "dot(oc, oc) - radius * 3"],
            ["- radius * radius", "- radius * 3.0"],
        ),
        (
            ["h * h - a * c", "h ** 2 - c * c"],
            ["h * h - a * c", "h * h - c * c"],
        ),
        (
            ["if discriminant < 0:", "if discriminant < 0.3:"],
            ["discriminant < 0.0", "discriminant < 0.3"],
        ),
        (
            [
                "(h - math.sqrt(discriminant))",
                "(h - 2 * math.sqrt(discriminant))",
            ],
            [
                "(h - discriminant.sqrt())",
                "(h - 2.0 * discriminant.sqrt())",
            ],
        ),
    ] {
        let text = Chapter::HalfBSphere.files()[0].text;
        let typed = text.replace(right, wrong);
        let program =
            interpreter::read(&[SourceFile::new("src/lib.rs", typed)]).expect("it is a program");
        let picture = png::encode(&program.draw(100).expect("it draws"));
        is_named_alone(&picture, old, new);
    }
}

#[test]
fn a_readers_line_of_the_camera_is_named() {
    let right = ChapterProgram::right(Chapter::HalfBSphere);
    let mut camera = Camera::new(100);
    camera.pixel00 -= 0.1 * (camera.pixel_delta_u + camera.pixel_delta_v);
    let picture = Picture::paint(camera.image_width, camera.image_height, move |i, j| {
        right.ray_color(&camera.ray(i, j))
    });
    is_named_alone(
        &png::encode(&picture),
        "upper_left + 0.5 * (du + dv)",
        "upper_left + 0.4 * (du + dv)",
    );
}

/// Asserts that the changed line of the program is named, and no line of the right program.
fn is_named_alone(picture: &[u8], right: &str, wrong: &str) {
    let task = Task::of(Chapter::HalfBSphere);
    assert!(PROGRAM.contains(right), "{right}");
    let rows = rows(&task, picture, &in_python(&PROGRAM.replace(right, wrong)));
    let yours: Vec<&Row> = rows.iter().filter(|it| it.kind == RowKind::Yours).collect();
    let is_it = matches!(yours[..], [it] if it.text.contains(wrong));
    assert!(is_it, "{wrong}: {rows:?}");
    let rows = self::rows(&task, picture, &in_python(PROGRAM));
    assert!(rows.iter().all(|it| it.kind != RowKind::Yours), "{rows:?}");
}

/// Dozens of mistakes draw only sky: none is named whose right line stands in the file.
#[test]
fn what_a_readers_line_refutes_is_not_named() {
    let task = Task::of(Chapter::HalfBSphere);
    let miss = [Edit::new("discriminant < 0.0", "true")];
    let sky = task.program(&[]).with_edits(&miss);
    let sky = sky.expect("it stands there");
    let picture = png::encode(&sky.run(100).picture());
    for Row { kind, text } in rows(&task, &picture, &in_python(PROGRAM)) {
        let innocent = ["discriminant", "oc =", "a =", "h =", "c =", "viewport"];
        let is_innocent = innocent.iter().any(|it| text.starts_with(it));
        assert!(kind == RowKind::Seen || !is_innocent, "{kind:?} {text}");
    }
}

const LIST: &str = "\
color ray_color(const ray& r, const hittable& world) {
    hit_record rec;
    if (world.hit(r, 0, infinity, rec)) return 0.5 * (rec.normal + color(1,1,1));
    vec3 unit_direction = unit_vector(r.direction());
    auto a = 0.5*(unit_direction.y() + 1.0);
    return (1.0-a)*color(1.0, 1.0, 1.0) + a*color(0.5, 0.7, 1.0);
}
int main() {
    hittable_list world;
    world.add(make_shared<sphere>(point3(0,0,-1), 0.5));
    world.add(make_shared<sphere>(point3(0,-100.5,-1), 100));
    auto camera_center = point3(0, 0, 0);
    ray r(camera_center, pixel_center - camera_center);
}
";

/// The mistake draws exactly the picture, but the file has no line that could be its own.
#[test]
fn a_mistake_is_only_a_perhaps_beside_a_text_that_does_not_have_its_line() {
    let task = Task::of(Chapter::HittableList);
    for name in [
        "h-sign",
        "integer-viewport-ratio",
        "column-and-row-swapped",
        "closest-not-updated",
        "faces-swapped",
    ] {
        let slip = slips::find(name).expect("a slip");
        let picture = png::encode(&task.program(&[slip]).run(100).picture());
        let rows = rows(&task, &picture, &in_cpp(LIST));
        let is_named = |it: &Row| [RowKind::Probably, RowKind::Yours].contains(&it.kind);
        assert!(!rows.iter().any(is_named), "{name}: {rows:?}");
        assert_eq!(rows[0].kind, RowKind::Perhaps, "{name}: {rows:?}");
    }
}

/// In C++, `1 / 2` is 0, and a ball of radius 0 is not seen.
#[test]
fn whole_numbers_are_divided_as_cpp_does() {
    let task = Task::of(Chapter::HittableList);
    let no_ball = [Edit::new("-1.0), 0.5)", "-1.0), 0.0)")];
    let ground = task.program(&[]).with_edits(&no_ball);
    let ground = ground.expect("it stands there");
    let picture = png::encode(&ground.run(100).picture());
    let line = "world.add(make_shared<sphere>(point3{0,0,-1}, 1 / 2));";
    let text = LIST.replace("world.add(make_shared<sphere>(point3(0,0,-1), 0.5));", line);
    let rows = rows(&task, &picture, &in_cpp(&text));
    let yours = rows.iter().find(|it| it.kind == RowKind::Yours);
    let is_it = yours.is_some_and(|it| it.text == format!("main.cpp:10  {line}"));
    assert!(is_it, "{rows:?}");
}

/// Three spellings of a right program: the height is clamped later, at once, or by a choice.
#[test]
fn a_right_program_gets_no_remark() {
    let later =
        "image_height = int(image_width / aspect)\nif image_height < 1:\n    image_height = 1\n";
    let at_once = "image_height = max(1, int(image_width / aspect))\n";
    let chosen = "h = int(image_width / aspect)\nimage_height = 1 if h < 1 else h\n";
    for text in [later, at_once, chosen] {
        let context = in_python(&(text.to_owned() + PROGRAM));
        let picture = png::encode(&Chapter::HalfBSphere.picture(100));
        let verdict = judge_file(&Task::of(Chapter::HalfBSphere), &picture, 0, &context);
        assert!(matches!(verdict, Verdict::Right(_)), "{text}");
    }
}

fn rows(task: &Task, picture: &[u8], context: &Context) -> Vec<Row> {
    let verdict = judge_file(task, picture, 0, context);
    verdict
        .finding()
        .map_or(Vec::new(), |finding| finding.rows(context))
}

fn in_python(text: &str) -> Context<'static> {
    let files = vec![SourceFile::new("main.py", text)];
    Context {
        language: Some(ReaderLanguage::Python(Edition::V4)),
        sources: Sources::new(files, Vec::new()),
        ..Context::default()
    }
}

fn in_cpp(text: &str) -> Context<'static> {
    let files = vec![SourceFile::new("main.cpp", text)];
    Context {
        sources: Sources::new(files, Vec::new()),
        ..Context::default()
    }
}
