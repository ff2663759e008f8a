//! Templates: the files of a crate of the reader's own, which `start` and a page begin with.
//!
//! A skeleton says by marks what becomes of what the reader wrote in the chapter before.

use slips::Chapter;

/// The files of the chapter with nothing in its functions, `src/lib.rs` first: the same as
/// those that the page lists.
pub fn files(chapter: Chapter, own: bool) -> Vec<(&'static str, String)> {
    let lib = match chapter {
        Chapter::BuildTest => include_str!("../files/build_test.rs"),
        Chapter::Gradient => include_str!("../files/gradient.rs"),
        Chapter::RedSphere => include_str!("../files/red_sphere.rs"),
        Chapter::Normals | Chapter::HalfBSphere => include_str!("../files/normals.rs"),
        Chapter::HittableList => include_str!("../files/hittable_list/lib.rs"),
        Chapter::SpeedVsAccuracy => unreachable!("it is not typed"),
    };
    // Both draw normals, so only what hits the sphere is typed again.
    let lib = match chapter {
        Chapter::HalfBSphere => lib.replace("// show ray_color", "// carry ray_color"),
        _ => lib.to_owned(),
    };
    let modules = match chapter {
        Chapter::HittableList => HITTABLE_LIST,
        _ => &[],
    };
    let (head, prelude) = match own {
        true => (
            include_str!("../files/own/head.rs"),
            "use crate::rtweekend::*;\n",
        ),
        false => {
            let prelude = include_str!("../files/head.rs");
            (prelude, prelude)
        }
    };
    let mut files = vec![("src/lib.rs", format!("{head}\n{lib}"))];
    files.extend(modules.iter().map(|&(name, module)| {
        let above = match module.starts_with("use ") {
            true => prelude.to_owned(),
            false => format!("{prelude}\n"),
        };
        (name, above + module)
    }));
    files
}

/// The same for who takes nothing over from the chapter before, in the order in which they are
/// typed.
pub fn plain(chapter: Chapter) -> Vec<(&'static str, String)> {
    let mut files = files(chapter, false);
    files.rotate_left(1);
    for (_, text) in &mut files {
        *text = without_marks(text);
    }
    files
}

fn without_marks(skeleton: &str) -> String {
    let mut text = String::new();
    let mut lines = skeleton.lines();
    while let Some(line) = lines.next() {
        let words: Vec<&str> = line.split(' ').collect();
        match words[..] {
            // The mark goes, and the empty line below it.
            ["//", "carry", _, "as", _] => drop(lines.next()),
            ["//", "carry" | "show", _] => {}
            _ => text += &format!("{line}\n"),
        }
    }
    text
}

/// The modules of chapter 5.
const HITTABLE_LIST: &[(&str, &str)] = &[
    (
        "src/hittable.rs",
        include_str!("../files/hittable_list/hittable.rs"),
    ),
    (
        "src/sphere.rs",
        include_str!("../files/hittable_list/sphere.rs"),
    ),
    (
        "src/hittable_list.rs",
        include_str!("../files/hittable_list/hittable_list.rs"),
    ),
];

/// The sky, for who types the prelude and has not typed it in chapter 1.
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
