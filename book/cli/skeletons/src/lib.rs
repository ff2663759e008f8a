//! Templates: the files of a crate of the reader's own, which `start` and a page begin with.
//!
//! All are written by hand, so that they hang on no chapter: a reader may have changed those.

pub mod source;

use course::chapter::Chapter;
use interpreter::SourceFile;

/// Lists the files that a reader types in a chapter, in the order in which they are typed. Each has
/// `todo!()` in place of the body of each function to be typed; those of chapter 5 are as
/// [`on_the_first_stair`](course::typed::on_the_first_stair). They use the reader's own prelude
/// (vectors, rays and the rendering: see [`own_prelude()`]) if `own_prelude` is true, or else that
/// of the package `common`. Empty for [`Chapter::SpeedVsAccuracy`].
pub fn files(chapter: Chapter, own_prelude: bool) -> Vec<SourceFile> {
    let import = |name| match (own_prelude, name) {
        (false, _) => PRELUDE,
        (true, "src/lib.rs") => include_str!("../files/own/head.rs"),
        (true, _) => "use crate::rtweekend::*;\n",
    };
    let files = typed(chapter).iter();
    let files = files.map(|&(name, text)| (name, text.replace(PRELUDE, import(name))));
    files
        .map(|(name, text)| SourceFile::new(name, text))
        .collect()
}

/// The line by which a file uses the prelude.
const PRELUDE: &str = "use common::rtweekend::*;\n";

/// Lists names and texts of the files that a reader types in a chapter.
fn typed(chapter: Chapter) -> &'static [(&'static str, &'static str)] {
    macro_rules! files {
        ($folder:literal: $($name:literal),*) => {
            &[$((
                concat!("src/", $name),
                include_str!(concat!("../files/", $folder, "/", $name)),
            )),*]
        };
    }
    match chapter {
        Chapter::BuildTest => files!("build_test": "lib.rs"),
        Chapter::Gradient => files!("gradient": "lib.rs"),
        Chapter::RedSphere => files!("red_sphere": "lib.rs"),
        Chapter::Normals => files!("normals": "lib.rs"),
        Chapter::HalfBSphere => files!("half_b_sphere": "lib.rs"),
        Chapter::HittableList => {
            files!("hittable_list": "hittable.rs", "sphere.rs", "hittable_list.rs", "lib.rs")
        }
        Chapter::SpeedVsAccuracy => &[],
    }
}

/// A function that the reader typed in an earlier chapter, and that is put into the files with
/// which a crate for a later chapter begins: its skeleton.
pub struct CarriedFunction {
    /// The name of the function in the earlier chapter.
    pub name: &'static str,
    /// A piece of text that only one item of the skeleton has, such as `fn ray_color`: the function
    /// is put beside that item.
    pub item: &'static str,
    /// The place of the function beside the item.
    pub place: CarriedPlace,
}

/// The place at which a [`CarriedFunction`] is put into a skeleton, the files with which a crate
/// begins: in place of one of its items, or above that.
#[derive(Clone, Copy)]
pub enum CarriedPlace {
    /// In place of the item, which is removed from the skeleton.
    Instead,
    /// Above the item, which stays; the function is renamed to this name, such as `sky`.
    AboveAs(&'static str),
    /// Above the item, which stays, as a comment: the reader sees the earlier code, and types anew.
    AboveAsComment,
}

/// Lists the functions of earlier chapters with which the reader's crate for `chapter` begins.
/// Empty if it begins with none.
pub fn carried_functions(chapter: Chapter) -> &'static [CarriedFunction] {
    use CarriedPlace::{AboveAs, AboveAsComment, Instead};
    const fn put(name: &'static str, item: &'static str, place: CarriedPlace) -> CarriedFunction {
        CarriedFunction { name, item, place }
    }
    const COLOR: CarriedFunction = put("ray_color", "fn ray_color", AboveAsComment);
    const ROOT: CarriedFunction = put("hit_sphere", "fn hit_sphere", AboveAsComment);
    match chapter {
        Chapter::RedSphere => const { &[put("ray_color", "fn ray_color", AboveAs("sky"))] },
        Chapter::Normals => &[COLOR, ROOT],
        // Both draw normals, so only what hits the sphere is typed again.
        Chapter::HalfBSphere => const { &[put("ray_color", "fn ray_color", Instead), ROOT] },
        Chapter::HittableList => {
            const { &[COLOR, put("hit_sphere", "pub fn hit(", AboveAsComment)] }
        }
        _ => &[],
    }
}

/// The Rust text of a function `sky` with `todo!()` in it, for a reader who types the prelude
/// (vectors, rays and the rendering) and has not typed the sky in chapter 1.
pub const OWN_SKY: &str = include_str!("../files/own/sky.rs");

/// Lists the files of a prelude that the reader types instead of using that of `common`: vectors,
/// rays and the rendering of a picture. They are in the order in which they are typed, and have
/// `todo!()` in the bodies of the functions to be typed.
pub fn own_prelude() -> [SourceFile; 4] {
    [
        ("rtweekend", include_str!("../files/own/rtweekend.rs")),
        ("vec3", include_str!("../files/own/vec3.rs")),
        ("ray", include_str!("../files/own/ray.rs")),
        ("render", include_str!("../files/own/render.rs")),
    ]
    .map(|(name, text)| SourceFile::new(format!("src/{name}.rs"), text))
}

/// The text of `.vscode/settings.json` for a reader's crate: rust-analyzer builds in a folder of
/// its own. It would lock the shared one while it checks a saved file, and `watch` would have to
/// wait.
pub const EDITOR: &str = r#"{
  // In a folder of its own, so that `watch` need not wait for the editor.
  "rust-analyzer.cargo.targetDir": true
}
"#;

/// Writes the text of `src/main.rs`, a program that prints the chapter's picture as P3, 400 pixels
/// wide. With `own_prelude`, it prints a picture that is a `String`, and else one of `common`,
/// whose width its command line can change.
pub fn main(chapter: Chapter, own_prelude: bool) -> String {
    let name = chapter.name();
    let body = if own_prelude {
        format!("fn main() {{\n    print!(\"{{}}\", my_{name}::picture(400));\n}}\n")
    } else {
        format!(
            "fn main() -> std::process::ExitCode {{\n    common::engine::main(400, my_{name}::picture)\n}}\n"
        )
    };
    format!("//! Prints the picture: `cargo run > {name}.ppm`\n\n{body}")
}

/// Writes the text of `Cargo.toml` for the reader's crate `my_CHAPTER`. With `own_prelude`, it
/// needs `common` only for its tests. `workspace` is the path of this project, absolute or as seen
/// from the crate. `number` becomes part of the version; it has to be another for each crate, since
/// cargo builds them all in one folder.
pub fn manifest(chapter: Chapter, own_prelude: bool, workspace: &str, number: u64) -> String {
    let name = chapter.name();
    let path = |package: &str| format!("{:?}", format!("{workspace}/{package}"));
    let common = format!("common = {{ path = {} }}\n", path("common"));
    let laws = format!("laws = {{ path = {} }}\n", path("tests/laws"));
    // An own prelude meets ours in the tests alone.
    let (common, common_for_tests) = if own_prelude {
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

/// Writes the text of `tests/laws.rs`, a test that checks the functions of a reader's crate against
/// the laws, properties that a right function has. `own_prelude` is true for a crate with a prelude
/// of its own. Returns an empty text if no law applies to the chapter.
pub fn test(chapter: Chapter, own_prelude: bool) -> String {
    let test = match (chapter, own_prelude) {
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
    let prelude = if own_prelude {
        include_str!("../files/own/laws/prelude.rs")
    } else {
        ""
    };
    let test = format!("{test}{list}{prelude}")
        .replace("my_chapter", &format!("my_{}", chapter.name()))
        .replace("MyScene", scene(chapter));
    match chapter {
        // It only decides whether there is a root.
        Chapter::RedSphere => test
            .replace(".nearer_root(", ".decision(")
            .replace("Option<f64>", "bool"),
        _ => test,
    }
}

/// Returns the name of the `ChapterScene` whose colors the chapter's `ray_color` returns.
fn scene(chapter: Chapter) -> &'static str {
    match chapter {
        Chapter::BuildTest | Chapter::Gradient => "Sky",
        Chapter::RedSphere => "Disc",
        Chapter::Normals | Chapter::HalfBSphere => "Ball",
        Chapter::HittableList | Chapter::SpeedVsAccuracy => "List",
    }
}
