//! Help for a reader who types in a page. That the page judges as `watch` does is tested with the
//! companion, and the page itself in `tests/browser`.

use page::next::next;
use page::typed::{Draft, Feedback};
use page::typing::Caret;
use slips::Chapter;

/// Types the line that the page proposes next, again and again, until nothing is missing.
#[test]
fn the_next_lines_lead_from_empty_functions_to_the_chapter() {
    for chapter in Chapter::OF_THE_BOOK {
        let mut draft = Draft::skeleton(chapter);
        while let Some(next) = next(&draft, 0) {
            let file = &mut draft.files[next.file];
            let mut lines: Vec<&str> = file.text.lines().collect();
            if next.is_instead {
                lines[next.above] = &next.text;
            } else {
                lines.insert(next.above, &next.text);
            }
            assert!(lines.len() < 200, "{file:?} never ends");
            file.text = lines.join("\n");
        }
        for (typed, full) in draft.files.iter().zip(Draft::complete(chapter).files) {
            let (name, chapter) = (&typed.name, chapter.name());
            assert_eq!(code(&typed.text), code(&full.text), "{name} of {chapter}");
        }
    }
}

/// Types the chapter letter by letter in place of each `todo!()`. Of chapter 5 that is the first
/// stair: between the lines of the second, which takes the first apart, it does not compile.
#[test]
fn a_right_text_is_called_unfinished_and_never_wrong_while_it_is_typed() {
    let is_written = |draft: &Draft| draft.files.iter().all(|it| !it.text.contains("todo!()"));
    for chapter in Chapter::OF_THE_BOOK {
        let mut draft = Draft::skeleton(chapter);
        while let Some(next) = next(&draft, 0).filter(|_| !is_written(&draft)) {
            let file = &draft.files[next.file].text;
            let mut lines: Vec<String> = file.lines().map(str::to_owned).collect();
            let is_instead = lines
                .get(next.above)
                .is_some_and(|it| it.trim() == "todo!()");
            if !is_instead {
                lines.insert(next.above, String::new());
            }
            draft.caret = Some(Caret {
                file: next.file,
                line: next.above + 1,
            });
            let blanks = next.text.len() - next.text.trim_start().len();
            for end in (blanks + 1..next.text.len())
                .step_by(LETTERS)
                .chain([next.text.len()])
            {
                lines[next.above] = next.text[..end].to_owned();
                draft.files[next.file].text = lines.join("\n") + "\n";
                let Err(said) = drawn(&draft) else { continue };
                let is_calm = said.headline.contains("is-calm") && said.places.is_empty();
                assert!(is_calm, "{:?}\n{}", said, draft.files[next.file].text);
            }
        }
    }
}

/// The number of letters that are typed at once: reading a text takes some ten milliseconds here.
const LETTERS: usize = 3;

#[test]
fn a_line_of_the_chapter_that_is_typed_in_part_is_unfinished_though_it_draws() {
    let mut draft = Draft::complete(Chapter::Gradient);
    let line = |draft: &Draft| {
        draft.files[0]
            .text
            .lines()
            .position(|it| it.contains("* white"))
    };
    draft.files[0].text = draft.files[0].text.replace(" + a * blue", "");
    let at_end = Caret {
        file: 0,
        line: line(&draft).expect("it is there") + 1,
    };
    for (caret, expected) in [(Some(at_end), "you are typing"), (None, "Wrong<")] {
        draft.caret = caret;
        let program = draft.read().expect("it is Rust");
        let picture = draft.draw(&program, 400).expect("it draws");
        let said = draft.judged(program, &picture).headline;
        assert!(said.contains(expected), "{said}");
    }
}

/// Each row has a piece of a chapter, the habit that is typed instead, and the piece of the answer.
#[test]
fn a_habit_from_another_language_is_answered_by_what_rust_writes() {
    let rows = [
        ("let b =", "auto b =", "`let b = …`"),
        ("let b =", "double b =", "`let b = …`"),
        ("let b =", "const auto b =", "`let b = …`"),
        ("let b =", "let double b =", "`let b = …`"),
        ("let b =", "let b :=", "`let b = …`"),
        ("let b =", "let b ==", "`let b = …`"),
        ("let b =", "lett b =", "`let b = …`"),
        (
            "ray.direction.dot(oc)",
            "ray->direction.dot(oc)",
            "`ray.direction`",
        ),
        (
            "ray.direction.dot(oc)",
            "dot(ray.direction, oc)",
            "`u.dot(v)`",
        ),
        ("discriminant.sqrt()", "sqrt(discriminant)", "`x.sqrt()`"),
        (
            "discriminant.sqrt()",
            "std::sqrt(discriminant)",
            "`a.sqrt()`",
        ),
        ("discriminant.sqrt()", "discriminant.sqrt", "`.sqrt(…)`"),
        ("radius * radius", "pow(radius, 2)", "`x * x`"),
        (
            "(ray.at(t) - center).normalize()",
            "unit_vector(ray.at(t) - center)",
            "`v.normalize()`",
        ),
        ("return None;", "return null;", "`None`"),
        ("return None;", "return nullptr;", "`None`"),
        (
            "return None;",
            "return false;",
            "`None` where nothing is hit",
        ),
        (
            "return None;",
            "return discriminant > 0.0 ? a : b;",
            "`if … { … } else { … }`",
        ),
        ("discriminant < 0.0 {", "discriminant => 0.0 {", "`&gt;=`"),
        ("&& t > 0.0", "and t > 0.0", "`&amp;&amp;`"),
        ("radius: f64", "double radius", "`radius: f64`"),
        ("-> Option<f64>", ": Option<f64>", "`-&gt; Option`"),
        ("Vec3::ONE", "vec3(1, 1, 1)", "`Vec3::new(…)`"),
        ("Vec3::ONE", "new Vec3(1.0, 1.0, 1.0)", "`Vec3::new(…)`"),
        ("sky(ray)", "Sky(ray)", "there is `sky`"),
    ];
    for (right, typed, expected) in rows {
        let mut draft = Draft::complete(Chapter::Normals);
        let file = &mut draft.files[0].text;
        *file = file.replacen(right, typed, 1);
        let said = drawn(&draft).expect_err(typed);
        assert!(said.rest.contains(expected), "{typed}: {}", said.rest);
    }
}

fn drawn(draft: &Draft) -> Result<(), Feedback> {
    draft.read().and_then(|it| draft.draw(&it, 16)).map(drop)
}

fn code(text: &str) -> Vec<&str> {
    let is_code = |line: &&str| {
        !line.is_empty()
            && !["//", "#", "use "]
                .iter()
                .any(|it| line.trim_start().starts_with(it))
    };
    text.lines().filter(is_code).collect()
}
