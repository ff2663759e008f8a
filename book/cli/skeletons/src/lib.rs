//! Templates: the files of a crate of the reader's own, which `start` and a page begin with.
//!
//! Those of a chapter are made from the chapter itself, those of a prelude are written by hand.

pub mod source;

use slips::{Chapter, lawful};

/// Lists the files of the chapter, as the page lists them, with `todo!()` in the functions that are
/// to be typed: each with its name, in the order in which they are typed.
pub fn files(chapter: Chapter, own: bool) -> Vec<(&'static str, String)> {
    let (of_lib, of_others) = if own {
        let modules = include_str!("../files/own/head.rs");
        (modules, "use crate::rtweekend::*;\n")
    } else {
        (PRELUDE, PRELUDE)
    };
    let skeleton = |&(name, text): &(&'static str, &str)| {
        let text = source::to_type(text, given(chapter)).replace(GROUND, "");
        if name != "src/lib.rs" {
            return (name, text.replace(PRELUDE, of_others));
        }
        let is_head = |line: &&str| line.starts_with("//!") || line.is_empty();
        let lines = text.lines().skip_while(is_head);
        let text: String = lines.map(|line| format!("{line}\n")).collect();
        (name, text.replace(PRELUDE, of_lib))
    };
    let mut files: Vec<_> = chapter.files().iter().map(skeleton).collect();
    files.sort_by_key(|(name, _)| ORDER.iter().position(|it| it == name));
    files
}

/// The line by which a chapter uses the prelude.
const PRELUDE: &str = "use common::rtweekend::*;\n";

/// A step of chapter 5.
const GROUND: &str = "    world.add(Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0));\n";

/// In which order the files of a chapter are typed.
const ORDER: [&str; 4] = [
    "src/hittable.rs",
    "src/sphere.rs",
    "src/hittable_list.rs",
    "src/lib.rs",
];

/// The functions of a chapter that the reader need not type.
fn given(chapter: Chapter) -> &'static [&'static str] {
    match chapter {
        Chapter::BuildTest => &[],
        Chapter::RedSphere => &["picture", "ray_color"],
        _ => &["picture", "world", "new", "add"],
    }
}

/// Lists the [`files`] for a reader whose prelude is ours.
pub fn plain(chapter: Chapter) -> Vec<(&'static str, String)> {
    files(chapter, false)
}

/// How a function that the reader wrote in the chapter before goes on, near an item of the
/// skeleton.
pub enum How {
    /// It takes the place of the item.
    InPlace,
    /// It stands before the item, by this name.
    As(&'static str),
    /// It stands before the item as a comment, to be looked at.
    Shown,
}

/// Lists the functions of the chapter before that go on in this one, each with a text that stands
/// in the item beside which it goes on.
pub fn carried(chapter: Chapter) -> &'static [(&'static str, &'static str, How)] {
    match chapter {
        Chapter::RedSphere => &[("ray_color", "fn ray_color", How::As("sky"))],
        Chapter::Normals => &[
            ("ray_color", "fn ray_color", How::Shown),
            ("hit_sphere", "fn hit_sphere", How::Shown),
        ],
        // Both draw normals, so only what hits the sphere is typed again.
        Chapter::HalfBSphere => &[
            ("ray_color", "fn ray_color", How::InPlace),
            ("hit_sphere", "fn hit_sphere", How::Shown),
        ],
        Chapter::HittableList => &[
            ("ray_color", "fn ray_color", How::Shown),
            ("hit_sphere", "impl Hittable for Sphere", How::Shown),
        ],
        _ => &[],
    }
}

/// The sky, for a reader who types the prelude and has not typed it in chapter 1.
pub const OWN_SKY: &str = include_str!("../files/own/sky.rs");

/// The files of a prelude that the reader types.
pub const OWN_PRELUDE: [(&str, &str); 4] = [
    (
        "src/rtweekend.rs",
        include_str!("../files/own/rtweekend.rs"),
    ),
    ("src/vec3.rs", include_str!("../files/own/vec3.rs")),
    ("src/ray.rs", include_str!("../files/own/ray.rs")),
    ("src/render.rs", include_str!("../files/own/render.rs")),
];

/// Has rust-analyzer in Visual Studio Code build in a folder of its own: while it checks a file
/// that was saved, it locks that in which it builds, and `watch` would have to wait.
pub const EDITOR: &str = r#"{
  // In a folder of its own, so that `watch` need not wait for the editor.
  "rust-analyzer.cargo.targetDir": true
}
"#;

/// Writes `src/main.rs`, which prints the picture.
pub fn main(chapter: Chapter, own: bool) -> String {
    let name = chapter.name();
    let body = if own {
        format!("fn main() {{\n    print!(\"{{}}\", my_{name}::picture(400));\n}}\n")
    } else {
        format!(
            "fn main() -> std::process::ExitCode {{\n    common::engine::main(400, my_{name}::picture)\n}}\n"
        )
    };
    format!("//! Prints the picture: `cargo run > {name}.ppm`\n\n{body}")
}

/// Writes `Cargo.toml`, with the path of the workspace as seen from the crate, and a number that no
/// other crate has.
pub fn manifest(chapter: Chapter, own: bool, workspace: &str, number: u64) -> String {
    let name = chapter.name();
    let path = |package: &str| format!("{:?}", format!("{workspace}/{package}"));
    let common = format!("common = {{ path = {} }}\n", path("common"));
    let laws = format!("laws = {{ path = {} }}\n", path("tests/laws"));
    // An own prelude meets ours in the tests alone.
    let (common, common_for_tests) = if own {
        ("", common.as_str())
    } else {
        (common.as_str(), "")
    };
    format!(
        "[package]\nname = \"my_{name}\"\n\
         # By this number cargo tells your crates of that name apart: all are built in one place.\n\
         version = \"0.1.0+{number:016x}\"\nedition = \"2024\"\npublish = false\n\n\
         [dependencies]\n{common}\n[dev-dependencies]\n{common_for_tests}{laws}\n\
         # A workspace of its own: what breaks here breaks nothing else.\n[workspace]\n\n\
         # What a debugger needs takes its time in every build: the setup page says how to ask for it.\n\
         [profile.dev]\nopt-level = 1\ndebug = false\n"
    )
}

/// Writes `tests/laws.rs`, the test that puts the reader's functions under the laws; empty where no
/// law can be broken.
pub fn test(chapter: Chapter, own: bool) -> String {
    let test = match (chapter, own) {
        (Chapter::HittableList, false) => include_str!("../files/laws/hittable_list.rs"),
        (Chapter::HittableList, true) => include_str!("../files/own/laws/hittable_list.rs"),
        (Chapter::Gradient, true) => include_str!("../files/own/laws/gradient.rs"),
        (Chapter::BuildTest | Chapter::Gradient | Chapter::SpeedVsAccuracy, _) => {
            return String::new();
        }
        (_, false) => include_str!("../files/laws/nearer_root.rs"),
        (_, true) => include_str!("../files/own/laws/nearer_root.rs"),
    };
    let list = match chapter {
        Chapter::HittableList => include_str!("../files/laws/list.rs"),
        _ => "",
    };
    let prelude = if own {
        include_str!("../files/own/laws/prelude.rs")
    } else {
        ""
    };
    let test = format!("{test}{list}{prelude}")
        .replace("my_chapter", &format!("my_{}", chapter.name()))
        .replace("MyScene", &format!("{:?}", lawful::scene(chapter)));
    match chapter {
        // It only decides whether there is a root.
        Chapter::RedSphere => test
            .replace(".nearer_root(", ".decision(")
            .replace("Option<f64>", "bool"),
        _ => test,
    }
}
