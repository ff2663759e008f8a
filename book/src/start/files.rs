//! Templates: the files of a new crate.

use std::hash::{BuildHasher, Hasher, RandomState};
use std::path::{Path, PathBuf};
use std::{fs, io};

use check::workspace::workspace;
use common::engine::output;
use slips::{Chapter, steps};

/// The files of the chapter with nothing in its functions, `src/lib.rs` first: the same as
/// those that the page lists.
pub(super) fn skeletons(chapter: Chapter, own: bool) -> Vec<(&'static str, String)> {
    let lib = match chapter {
        Chapter::Gradient => include_str!("skeletons/gradient.rs"),
        Chapter::RedSphere => include_str!("skeletons/red_sphere.rs"),
        Chapter::Normals | Chapter::HalfBSphere => include_str!("skeletons/normals.rs"),
        Chapter::HittableList => include_str!("skeletons/hittable_list/lib.rs"),
        Chapter::BuildTest | Chapter::SpeedVsAccuracy => unreachable!("it is not typed"),
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
            include_str!("skeletons/own/head.rs"),
            "use crate::rtweekend::*;\n",
        ),
        false => {
            let prelude = include_str!("skeletons/head.rs");
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

/// The modules of chapter 5.
const HITTABLE_LIST: &[(&str, &str)] = &[
    (
        "src/hittable.rs",
        include_str!("skeletons/hittable_list/hittable.rs"),
    ),
    (
        "src/sphere.rs",
        include_str!("skeletons/hittable_list/sphere.rs"),
    ),
    (
        "src/hittable_list.rs",
        include_str!("skeletons/hittable_list/hittable_list.rs"),
    ),
];

/// The files of a prelude that the reader types.
pub(super) const OWN_PRELUDE: [(&str, &str); 4] = [
    (
        "src/rtweekend.rs",
        include_str!("skeletons/own/rtweekend.rs"),
    ),
    ("src/vec3.rs", include_str!("skeletons/own/vec3.rs")),
    ("src/ray.rs", include_str!("skeletons/own/ray.rs")),
    ("src/render.rs", include_str!("skeletons/own/render.rs")),
];

/// Where the workspace is, as seen from a crate: one that lies in it moves with it.
pub(super) fn from_crate(folder: &Path, workspace: &Path) -> PathBuf {
    let real = folder.parent().and_then(|mine| mine.canonicalize().ok());
    let below = real
        .as_deref()
        .and_then(|it| it.strip_prefix(workspace).ok());
    below.map_or(workspace.to_owned(), |below| {
        Path::new("..").join(below.iter().map(|_| "..").collect::<PathBuf>())
    })
}

/// All crates of readers, wherever they are, share what was built once, and in each of
/// them `cargo rtrace` is what it is in the workspace. The alias is one text, as there, or
/// cargo would not put the two together; so there is none where a path has a space in it.
/// It is read wherever the reader is in the crate, and so its paths are absolute.
pub(super) fn config(from_crate: &Path, workspace: &Path) -> String {
    let shared = toml_string(&from_crate.join("target/mine"));
    let target = format!("[build]\ntarget-dir = {shared}\n");
    let paths = ["Cargo.toml", "target"].map(|name| workspace.join(name).display().to_string());
    if paths.iter().any(|path| path.contains(char::is_whitespace)) {
        return target;
    }
    let [manifest, built] = paths;
    let alias = format!("run --manifest-path {manifest} --target-dir {built} --package rtrace --");
    format!("{target}\n[alias]\nrtrace = {alias:?}\n")
}

/// Renews the settings of a crate after the workspace was moved, if nobody has changed more
/// in them than the paths.
///
/// # Errors
/// If they can't be written.
pub(crate) fn renew_config(folder: &Path) -> io::Result<()> {
    let Some(workspace) = workspace() else {
        return Ok(());
    };
    let file = folder.join(".cargo/config.toml");
    let old = fs::read_to_string(&file).unwrap_or_default();
    let new = config(&from_crate(folder, workspace), workspace);
    let without_paths = |text: &str| text.split('"').step_by(2).collect::<String>();
    match old != new && without_paths(&old) == without_paths(&new) {
        true => output::to_file(&file, |out| out.write_all(new.as_bytes())),
        false => Ok(()),
    }
}

/// The head of the chapter: its steps.
pub(super) fn about(chapter: Chapter) -> String {
    let number = chapter as usize;
    let mut about = format!(
        "//! Chapter {number}, {}, typed by hand.\n//!\n",
        chapter.name()
    );
    for (step, says) in (1..).zip(steps::of(chapter).iter().map(|step| step.says)) {
        let lines = textwrap::wrap(says, 72);
        for (n, line) in lines.iter().enumerate() {
            let label = match n {
                0 => format!("{step}."),
                _ => "  ".to_owned(),
            };
            about += &format!("//! {label} {line}\n");
        }
    }
    about + "\n"
}

pub(super) fn main(chapter: Chapter, own: bool) -> String {
    let name = chapter.name();
    let body = match own {
        true => format!("fn main() {{\n    print!(\"{{}}\", my_{name}::picture(400));\n}}\n"),
        false => format!(
            "fn main() -> std::process::ExitCode {{\n    common::engine::main(400, my_{name}::picture)\n}}\n"
        ),
    };
    format!("//! Prints the picture: `cargo run > {name}.ppm`\n\n{body}")
}

pub(super) fn manifest(chapter: Chapter, own: bool, workspace: &Path) -> String {
    let name = chapter.name();
    let path = |package: &str| toml_string(&workspace.join(package));
    let common = format!("common = {{ path = {} }}\n", path("common"));
    let laws = format!("laws = {{ path = {} }}\n", path("tests/laws"));
    // An own prelude meets ours in the tests alone.
    let (common, common_for_tests) = match own {
        true => ("", common.as_str()),
        false => (common.as_str(), ""),
    };
    // The standard library asks the system for a random number to seed its hash tables.
    let random = RandomState::new().build_hasher().finish();
    format!(
        "[package]\nname = \"my_{name}\"\n\
         # By this number cargo tells your crates of that name apart: all are built in one place.\n\
         version = \"0.1.0+{random:016x}\"\nedition = \"2024\"\npublish = false\n\n\
         [dependencies]\n{common}\n[dev-dependencies]\n{common_for_tests}{laws}\n\
         # A workspace of its own: what breaks here breaks nothing else.\n[workspace]\n\n\
         # What a debugger needs takes its time in every build: the setup page says how to ask for it.\n\
         [profile.dev]\nopt-level = 1\ndebug = false\n"
    )
}

/// The path as TOML quotes it.
fn toml_string(path: &Path) -> String {
    format!("{:?}", path.display().to_string())
}

/// The test that puts what the reader types under the laws; empty where nobody would look
/// for a mistake.
pub(super) fn test(chapter: Chapter, own: bool) -> String {
    let test = match (chapter, own) {
        (Chapter::HittableList, false) => include_str!("skeletons/laws/hittable_list.rs"),
        (Chapter::HittableList, true) => include_str!("skeletons/own/laws/hittable_list.rs"),
        (Chapter::Gradient, true) => include_str!("skeletons/own/laws/gradient.rs"),
        (Chapter::BuildTest | Chapter::Gradient | Chapter::SpeedVsAccuracy, _) => {
            return String::new();
        }
        (_, false) => include_str!("skeletons/laws/nearer_root.rs"),
        (_, true) => include_str!("skeletons/own/laws/nearer_root.rs"),
    };
    let prelude = match own {
        true => include_str!("skeletons/own/laws/prelude.rs"),
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
