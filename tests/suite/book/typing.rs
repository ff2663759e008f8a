//! Help for a reader who types in a page. That the page judges as `watch` does is tested with the
//! companion, and the page itself in `tests/browser`.

use check::answer::Grade;
use course::typed::on_the_first_stair;
use page::next::{Lack, NextLine, next};
use page::typed::{Draft, Feedback};
use page::typing::Caret;
use slips::Chapter;

/// Types the line that the page proposes next, again and again, until nothing is missing. Of chapter
/// 5 that is the first stair, which draws the picture.
#[test]
fn the_next_lines_lead_from_empty_functions_to_the_chapter() {
    for chapter in Chapter::OF_THE_BOOK {
        let mut draft = Draft::skeleton(chapter);
        while let Lack::Line(next) = next(&draft, (0, 1)) {
            let file = &mut draft.files[next.file];
            let mut lines: Vec<&str> = file.text.lines().collect();
            if next.replaces {
                lines[next.above] = &next.text;
            } else {
                lines.insert(next.above, &next.text);
            }
            assert!(lines.len() < 200, "{file:?} never ends");
            file.text = lines.join("\n");
        }
        assert_eq!(next(&draft, (0, 1)), Lack::Nothing);
        for (typed, full) in draft.files.iter().zip(Draft::complete(chapter).files) {
            let (name, chapter) = (&typed.name, chapter.name());
            let full = on_the_first_stair(&full.text);
            assert_eq!(code(&typed.text), code(&full), "{name} of {chapter}");
        }
    }
}

/// Types the chapter letter by letter in place of each `todo!()`; of chapter 5 the first stair.
#[test]
fn a_right_text_is_called_unfinished_and_never_wrong_while_it_is_typed() {
    for chapter in Chapter::OF_THE_BOOK {
        let mut draft = Draft::skeleton(chapter);
        while let Lack::Line(next) = next(&draft, (0, 1)) {
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
                rests: false,
            });
            let blanks = next.text.len() - next.text.trim_start().len();
            for end in (blanks + 1..next.text.len())
                .step_by(LETTERS)
                .chain([next.text.len()])
            {
                lines[next.above] = next.text[..end].to_owned();
                draft.files[next.file].text = lines.join("\n") + "\n";
                let Err(said) = drawn(&draft) else { continue };
                let is_calm = said.grade == Grade::OnTheWay && said.places.is_empty();
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
    let at_end = |rests| {
        let line = line(&draft).expect("it is there") + 1;
        let file = 0;
        Some(Caret { file, line, rests })
    };
    let (typing, resting) = (at_end(false), at_end(true));
    for (caret, is_waiting) in [(typing, true), (resting, false), (None, false)] {
        draft.caret = caret;
        let program = draft.read().expect("it is Rust");
        let picture = draft.draw(&program, 64).expect("it draws");
        let said = draft.judged(program, &picture);
        assert_eq!(said.is_waiting, is_waiting, "{said:?}");
        assert_eq!(said.grade == Grade::OnTheWay, is_waiting, "{said:?}");
    }
}

/// The caret stands at the end of a line above the fault, and is there for nothing.
#[test]
fn a_fault_below_a_finished_line_is_told() {
    let mut draft = Draft::complete(Chapter::Normals);
    let text = &mut draft.files[0].text;
    *text = text.replace("/ (2.0 * a))", "/ (2.0 * a))x");
    let fault = text.lines().position(|it| it.ends_with('x'));
    let line = fault.expect("it is there");
    for rests in [false, true] {
        draft.caret = Some(Caret {
            file: 0,
            line,
            rests,
        });
        let said = drawn(&draft).expect_err("it is no Rust");
        assert_eq!(said.grade, Grade::Wrong, "{said:?}");
    }
}

/// A reader may stop to think, and has then typed neither a mistake nor a line.
#[test]
fn what_cannot_be_read_yet_is_unfinished_though_the_reader_rests() {
    let line = "let a = 0.5 * (unit_direction.y + 1.0);";
    for (typed, expected) in [
        ("let a = 0.5 * (unit_direction.y +", Grade::OnTheWay),
        ("let a =", Grade::OnTheWay),
        ("return (1, 1, 1);", Grade::Wrong),
        ("let a = 1.0\n    let b", Grade::Wrong),
        ("let a = 0.5 * (z + 1.0);", Grade::Wrong),
    ] {
        let mut draft = Draft::complete(Chapter::Gradient);
        let text = &mut draft.files[0].text;
        let start = text.find(line).expect("it is there");
        *text = text[..start].to_owned() + typed + "\n}\n";
        let line = text.lines().count() - 1;
        let (file, rests) = (0, true);
        draft.caret = Some(Caret { file, line, rests });
        let said = drawn(&draft).expect_err(typed);
        assert_eq!(said.grade, expected, "{typed}: {said:?}");
    }
}

/// Each row has a line of a chapter, what is typed instead, and what is said to be missing then.
#[test]
fn the_next_line_is_told_in_the_readers_own_names_and_only_where_it_fits() {
    let last = "    (1.0 - a) * white + a * sky";
    let sky = "    let sky = ";
    let rows = [
        ("    let blue = ", sky, "* blue", "* sky", Lack::Nothing),
        (
            "    let blue = ",
            sky,
            "    (1.0 - a) * white + a * blue",
            "",
            line(last, false),
        ),
        (
            "    let blue = ",
            sky,
            "    (1.0 - a) * white + a * blue",
            "    (1.0 - a) *",
            line(last, true),
        ),
        (
            "    (1.0 - a) * white + a * blue",
            "    return (1.0 - a) * white + a * blue;",
            "",
            "",
            Lack::Nothing,
        ),
        (
            "    (1.0 - a) * white + a * blue",
            "    return white + a * (blue - white);",
            "",
            "",
            Lack::Unknown,
        ),
    ];
    for (old, new, other, instead, expected) in rows {
        let mut draft = Draft::complete(Chapter::Gradient);
        let text = &mut draft.files[0].text;
        *text = text
            .replacen(old, new, 1)
            .replacen(other, instead, usize::from(!other.is_empty()));
        let mut lack = next(&draft, (0, 1));
        if let Lack::Line(next) = &mut lack {
            next.above = 0;
        }
        assert_eq!(lack, expected, "{}", draft.files[0].text);
    }
}

/// Two functions of chapter 3 lack a line: the hint is about the one with the caret.
#[test]
fn the_next_line_is_that_of_the_function_with_the_caret() {
    let (first, second) = ("    sky(ray)", "    let oc = center - ray.origin;");
    let mut draft = Draft::complete(Chapter::Normals);
    let text = &mut draft.files[0].text;
    *text = text
        .replace(first, "    todo!()")
        .replace(&format!("{second}\n"), "");
    let line = |part: &str| {
        1 + draft.files[0]
            .text
            .lines()
            .take_while(|it| !it.contains(part))
            .count()
    };
    for (part, expected) in [
        ("fn ray_color", first),
        ("let discriminant", second),
        ("use common", first),
    ] {
        let Lack::Line(next) = next(&draft, (0, line(part))) else {
            panic!("a line is missing");
        };
        assert_eq!(next.text, expected, "at {part}");
    }
}

/// All that is white is the first step of chapter 1, and only sky that of chapter 2.
#[test]
fn a_wrong_line_is_told_though_its_picture_is_a_steps() {
    let rows = [
        (Chapter::Gradient, ".y + 1.0", ".y - 1.0"),
        (Chapter::Gradient, "(1.0 - a)", "(1.0 + a)"),
        (Chapter::RedSphere, "- radius * radius", "+ radius * radius"),
    ];
    for (chapter, right, wrong) in rows {
        let mut draft = Draft::complete(chapter);
        let file = &mut draft.files[0].text;
        *file = file.replacen(right, wrong, 1);
        let program = draft.read().expect("it is Rust");
        let picture = draft.draw(&program, 400).expect("it draws");
        let said = draft.judged(program, &picture);
        let is_told = said.grade == Grade::Wrong && said.rest.contains("<dt>why</dt>");
        assert!(is_told, "{wrong}: {said:?}");
    }
    let mut draft = Draft::complete(Chapter::Gradient);
    let file = &mut draft.files[0].text;
    *file = file.replacen("(1.0 - a) * white + a * blue", "white", 1);
    let program = draft.read().expect("it is Rust");
    let picture = draft.draw(&program, 400).expect("it draws");
    let said = draft.judged(program, &picture);
    assert!(said.headline.contains("Step 1 of 4"), "{said:?}");
}

/// Each row has a mistake in chapter 3, and what is told of it before the reader's own line: what the
/// picture shows, or the ray with which the function breaks a law.
#[test]
fn the_picture_or_the_ray_comes_first_then_the_line_and_folded_the_answer() {
    let rows = [
        ("b = -2.0", "b = 2.0", "There is only sky"),
        (
            "(normal + Vec3::ONE)",
            "(normal - Vec3::ONE)",
            "each component is 0 everywhere",
        ),
        (
            "discriminant < 0.0",
            "discriminant <= 0.0",
            "let ray = Ray::new(",
        ),
    ];
    for (right, wrong, first) in rows {
        let mut draft = Draft::complete(Chapter::Normals);
        let file = &mut draft.files[0].text;
        *file = file.replacen(right, wrong, 1);
        let program = draft.read().expect("it is Rust");
        let picture = draft.draw(&program, 400).expect("it draws");
        let rest = draft.judged(program, &picture).rest;
        let place = |part: &str| {
            rest.find(part)
                .unwrap_or_else(|| panic!("no {part}: {rest}"))
        };
        let places = [first, "<dt>yours</dt>", "<details>", "<dt>should be</dt>"].map(place);
        assert!(places.is_sorted(), "{rest}");
    }
}

fn line(text: &str, replaces: bool) -> Lack {
    let text = text.to_owned();
    Lack::Line(NextLine {
        file: 0,
        above: 0,
        text,
        replaces,
    })
}

/// The habits of other languages: a piece of a chapter, what is typed instead, and a piece of the
/// answer.
const HABITS: [[&str; 3]; 43] = [
    ["let b =", "auto b =", "`let b = …`"],
    ["let b =", "double b =", "`let b = …`"],
    ["let b =", "const auto b =", "`let b = …`"],
    ["let b =", "let double b =", "`let b = …`"],
    ["let b =", "let b :=", "`let b = …`"],
    ["let b =", "let b ==", "`let b = …`"],
    ["let b =", "lett b =", "`let b = …`"],
    [
        "ray.direction.dot(oc)",
        "ray->direction.dot(oc)",
        "`ray.direction`",
    ],
    [
        "ray.direction.dot(oc)",
        "dot(ray.direction, oc)",
        "`u.dot(v)`",
    ],
    ["discriminant.sqrt()", "sqrt(discriminant)", "`x.sqrt()`"],
    [
        "discriminant.sqrt()",
        "std::sqrt(discriminant)",
        "`a.sqrt()`",
    ],
    ["discriminant.sqrt()", "discriminant.sqrt", "`.sqrt(…)`"],
    ["radius * radius", "pow(radius, 2)", "`x * x`"],
    [
        "(ray.at(t) - center).normalize()",
        "unit_vector(ray.at(t) - center)",
        "`v.normalize()`",
    ],
    ["return None;", "return null;", "`None`"],
    ["return None;", "return nullptr;", "`None`"],
    [
        "return None;",
        "return false;",
        "`None` where nothing is hit",
    ],
    [
        "return None;",
        "return discriminant > 0.0 ? a : b;",
        "`if … { … } else { … }`",
    ],
    ["discriminant < 0.0 {", "discriminant => 0.0 {", "`&gt;=`"],
    ["&& t > 0.0", "and t > 0.0", "`&amp;&amp;`"],
    ["let b =", "b =", "`let b = …`"],
    [
        "let discriminant =",
        "discriminant =",
        "`let discriminant = …`",
    ],
    ["radius * radius", "radius^2", "`radius * radius`"],
    ["if discriminant <", "if not discriminant >=", "`!(…)`"],
    [
        "discriminant < 0.0 {",
        "not (discriminant >= 0.0) {",
        "`!(…)`",
    ],
    [
        "discriminant.sqrt()",
        "math.sqrt(discriminant)",
        "`a.sqrt()`",
    ],
    ["discriminant.sqrt()", "np.sqrt(discriminant)", "`a.sqrt()`"],
    ["let b =", "# the slope\n    let b =", "`// …`"],
    [
        "if discriminant < 0.0 {\n        return None;\n    }",
        "if discriminant < 0.0:\n        return None",
        "`if … { … }`",
    ],
    [
        "return None;\n    }",
        "return None;\n    } elif a < 0.0:",
        "`else if … { … }`",
    ],
    [
        "return None;\n    }",
        "return None;\n    } else:",
        "`else { … }`",
    ],
    [
        "Point3::new(0.0, 0.0, -1.0)",
        "(0.0, 0.0, -1.0)",
        "`Point3::new(…)`",
    ],
    ["Vec3::ONE", "[1.0, 1.0, 1.0]", "`Color::new(…)`"],
    ["Point3::new", "Point3.new", "`Point3::new(…)`"],
    ["4.0 * a", "4 * a", "`4.0`"],
    ["t > 0.0", "t > 0", "`0.0`"],
    ["Vec3::ONE", "Color::new(1, 1, 1)", "`1.0`"],
    ["4.0 * a", "radius.powi(2) * 4 * a", "`4.0`"],
    ["radius: f64", "double radius", "`radius: f64`"],
    ["-> Option<f64>", ": Option<f64>", "`-&gt; Option`"],
    ["Vec3::ONE", "vec3(1, 1, 1)", "`Vec3::new(…)`"],
    ["Vec3::ONE", "new Vec3(1.0, 1.0, 1.0)", "`Vec3::new(…)`"],
    ["sky(ray)", "Sky(ray)", "did you mean `sky`?"],
];

#[test]
fn a_habit_from_another_language_is_answered_by_what_rust_writes() {
    for [right, typed, expected] in HABITS {
        let mut draft = Draft::complete(Chapter::Normals);
        let file = &mut draft.files[0].text;
        *file = file.replacen(right, typed, 1);
        let said = drawn(&draft).expect_err(typed);
        let rest = said.rest.replace("<code>", "`").replace("</code>", "`");
        assert!(rest.contains(expected), "{typed}: {rest}");
    }
}

#[test]
fn a_misspelled_variable_is_not_called_a_new_one() {
    let mut draft = Draft::complete(Chapter::HittableList);
    for file in &mut draft.files {
        file.text = file
            .text
            .replace("closest_so_far = record.t", "closest_sofar = record.t");
    }
    let said = drawn(&draft).expect_err("there is no such variable").rest;
    assert!(said.contains("did you mean `closest_so_far`"), "{said}");
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
