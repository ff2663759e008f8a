//! Templates: the files of a crate of the reader's own, which `start` and a page begin with.
//!
//! Those of a chapter are made from the chapter itself, those of a prelude are written by hand.

pub mod source;

use slips::Chapter;

/// The files of the chapter with nothing in the functions that are to be typed, `src/lib.rs`
/// first: the same as those that the page lists.
pub fn files(chapter: Chapter, own: bool) -> Vec<(&'static str, String)> {
    let of_lib = if own {
        include_str!("../files/own/head.rs")
    } else {
        PRELUDE
    };
    let skeleton = |&(name, text): &(&'static str, &str)| {
        let text = source::to_type(text, given(chapter));
        if name == "src/lib.rs" {
            let text = text
                .replacen(&format!("{PRELUDE}\n"), "", 1)
                .replace(GROUND, "");
            let is_head = |line: &&str| line.starts_with("//!") || line.is_empty();
            let lines = text.lines().skip_while(is_head);
            let lines: String = lines.map(|line| format!("{line}\n")).collect();
            (name, format!("{of_lib}\n{lines}"))
        } else if own {
            (name, text.replace("common::rtweekend", "crate::rtweekend"))
        } else {
            (name, text)
        }
    };
    let mut files: Vec<_> = chapter.files().iter().map(skeleton).collect();
    files.sort_by_key(|(name, _)| ORDER.iter().position(|it| it == name));
    files
}

/// What a chapter takes from the prelude.
const PRELUDE: &str = "use common::rtweekend::*;\n";

/// A step of chapter 5.
const GROUND: &str = "    world.add(Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0));\n";

/// The files of a chapter. All but the first are in the order in which they are typed.
const ORDER: [&str; 4] = [
    "src/lib.rs",
    "src/hittable.rs",
    "src/sphere.rs",
    "src/hittable_list.rs",
];

/// The functions of a chapter that the reader need not type.
fn given(chapter: Chapter) -> &'static [&'static str] {
    match chapter {
        Chapter::BuildTest => &[],
        Chapter::RedSphere => &["picture", "ray_color"],
        _ => &["picture", "world", "new", "add"],
    }
}

/// The same for a reader who takes nothing over from the chapter before, in the order in which
/// they are typed.
pub fn plain(chapter: Chapter) -> Vec<(&'static str, String)> {
    let mut files = files(chapter, false);
    files.rotate_left(1);
    files
}

/// What becomes of a function that the reader wrote in the chapter before.
pub struct Carry {
    /// The name of the function.
    pub name: &'static str,
    /// The item of the skeleton that it has to do with, by some of its text.
    pub at: &'static str,
    /// What becomes of it.
    pub how: How,
}

/// How a function is carried over.
pub enum How {
    /// It takes the place of the item.
    InPlace,
    /// It stands before the item, by this name.
    As(&'static str),
    /// It stands before the item as a comment, to be looked at.
    Shown,
}

/// What becomes of the functions of the chapter before.
pub fn carried(chapter: Chapter) -> Vec<Carry> {
    use How::{As, InPlace, Shown};
    let carry = |(name, at, how)| Carry { name, at, how };
    let hit_sphere = ("hit_sphere", "fn hit_sphere", Shown);
    let all = match chapter {
        Chapter::RedSphere => vec![("ray_color", "fn ray_color", As("sky"))],
        Chapter::Normals => vec![("ray_color", "fn ray_color", Shown), hit_sphere],
        // Both draw normals, so only what hits the sphere is typed again.
        Chapter::HalfBSphere => vec![("ray_color", "fn ray_color", InPlace), hit_sphere],
        Chapter::HittableList => vec![
            ("ray_color", "fn ray_color", Shown),
            ("hit_sphere", "impl Hittable for Sphere", Shown),
        ],
        _ => Vec::new(),
    };
    all.into_iter().map(carry).collect()
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

/// What prints the picture.
pub fn main(chapter: Chapter, own: bool) -> String {
    let name = chapter.name();
    let body = match own {
        true => format!("fn main() {{\n    print!(\"{{}}\", my_{name}::picture(400));\n}}\n"),
        false => format!(
            "fn main() -> std::process::ExitCode {{\n    common::engine::main(400, my_{name}::picture)\n}}\n"
        ),
    };
    format!("//! Prints the picture: `cargo run > {name}.ppm`\n\n{body}")
}

/// What cargo is told: where the workspace is, as seen from the crate, and a number that no
/// other crate has.
pub fn manifest(chapter: Chapter, own: bool, workspace: &str, number: u64) -> String {
    let name = chapter.name();
    let path = |package: &str| format!("{:?}", format!("{workspace}/{package}"));
    let common = format!("common = {{ path = {} }}\n", path("common"));
    let laws = format!("laws = {{ path = {} }}\n", path("tests/laws"));
    // An own prelude meets ours in the tests alone.
    let (common, common_for_tests) = match own {
        true => ("", common.as_str()),
        false => (common.as_str(), ""),
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

/// The test that puts what the reader types under the laws; empty where nobody would look
/// for a mistake.
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
    let prelude = match own {
        true => include_str!("../files/own/laws/prelude.rs"),
        false => "",
    };
    let test = format!("{test}{prelude}")
        .replace("my_chapter", &format!("my_{}", chapter.name()))
        .replace("MyChapter", &format!("{chapter:?}"));
    match chapter {
        // It only decides whether there is a root.
        Chapter::RedSphere => test
            .replace("trial.nearer_root", "trial.decision")
            .replace("Option<f64>", "bool"),
        _ => test,
    }
}
