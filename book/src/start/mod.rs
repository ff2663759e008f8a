//! `start`: a crate of the reader's own, ready to be typed into.

mod carry;

use std::error::Error;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{fs, io};

use carry::Written;
use check::Chapter;
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use common::engine::{companion, output};

use crate::mine::Mine;
use crate::misuse::misuse;
use crate::{steps, terminal};
use check::places::{shown, workspace};

/// What `cargo rtrace start` is told.
#[derive(Args)]
pub(crate) struct Arguments {
    /// The chapter that you are about to type
    #[arg(value_name = "CHAPTER", value_parser = typed_parser())]
    chapter: Chapter,

    /// Where your crates are to be [default: mine]
    #[arg(long, value_name = "FOLDER")]
    into: Option<PathBuf>,

    /// Type the prelude as well: vectors, rays, camera and the text of a picture
    #[arg(long)]
    own_prelude: bool,

    /// Begin the chapter once more; what you have typed is kept beside it
    #[arg(long)]
    again: bool,
}

/// The chapters that are typed; the setup page has the one before.
const TYPED: [Chapter; 5] = [
    Chapter::Gradient,
    Chapter::RedSphere,
    Chapter::Normals,
    Chapter::HalfBSphere,
    Chapter::HittableList,
];

/// Makes the crate, and says where it is and what comes next.
pub(crate) fn start(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let mine = Mine::find(arguments.into.as_deref());
    let folder = mine.of(arguments.chapter);
    let mut said = String::new();
    if folder.exists() {
        if !arguments.again {
            return Err(misuse(&format!(
                "{} is there already, and nothing is written over it\n\
                 Go on with {companion} watch {name}, or begin once more with {companion} start {name} --again.",
                shown(&folder),
                companion = companion(),
                name = arguments.chapter.name(),
            )));
        }
        let kept = put_aside(&folder)?;
        writeln!(said, "What you had is in {}", shown(&kept))?;
    }
    let before = TYPED.into_iter().rev().filter(|&it| it < arguments.chapter);
    let before = before
        .map(|chapter| mine.of(chapter))
        .find(|it| it.is_dir());
    let new = New::compose(arguments, before.as_deref())?;
    new.write(&folder)
        .map_err(|cause| format!("cannot write {}: {cause}", shown(&folder)))?;
    said += &new.said(&folder);
    Ok(output::to_stdout(|out| out.write_all(said.as_bytes()))?)
}

/// A crate that is about to be written.
struct New {
    chapter: Chapter,
    /// Its files, by their names.
    files: Vec<(String, String)>,
    /// What was carried over from the chapter before, or why nothing was.
    carried: String,
}

impl New {
    fn compose(arguments: &Arguments, before: Option<&Path>) -> Result<Self, Box<dyn Error>> {
        let chapter = arguments.chapter;
        let workspace = workspace().ok_or(
            "your crate would use the prelude and the laws of the workspace that this program \
             was built from, and that is not there any more",
        )?;
        let written = before.map(Written::read).transpose()?;
        let own = arguments.own_prelude || written.as_ref().is_some_and(Written::has_own_prelude);
        let mut carried = carry::into(&skeleton(chapter, own), written.as_ref());
        if own && written.is_none() && chapter > Chapter::Gradient {
            carried.source += include_str!("skeletons/own/sky.rs");
        }
        let kept = written.map_or(Vec::new(), |written| written.files);
        let mut files: Vec<(String, String)> = [
            ("src/lib.rs", about(chapter) + &carried.source),
            ("src/main.rs", main(chapter, own)),
            ("tests/laws.rs", test(chapter, own)),
            ("Cargo.toml", manifest(chapter, own, workspace)),
            // The same versions as ours: they have been downloaded.
            (
                "Cargo.lock",
                fs::read_to_string(workspace.join("Cargo.lock"))?,
            ),
        ]
        .map(|(name, text)| (name.to_owned(), text))
        .into();
        if own && kept.is_empty() {
            files.extend(OWN_PRELUDE.map(|(name, text)| (name.to_owned(), text.to_owned())));
        }
        files.extend(kept);
        files.retain(|(_, text)| !text.is_empty());
        let carried = carried.said;
        Ok(Self {
            chapter,
            files,
            carried,
        })
    }

    /// Writes all files, or none: into a folder beside it, which then gets the name.
    fn write(&self, folder: &Path) -> io::Result<()> {
        let mine = folder.parent().expect("a crate is in a folder");
        fs::create_dir_all(mine.join(".cargo"))?;
        let config = mine.join(".cargo/config.toml");
        if !config.exists() {
            fs::write(config, CONFIG)?;
        }
        let partial = tempfile::Builder::new()
            .prefix(".start-")
            .tempdir_in(mine)?;
        for (name, text) in &self.files {
            let path = partial.path().join(name);
            fs::create_dir_all(path.parent().expect("a file is in a folder"))?;
            fs::write(path, text)?;
        }
        fs::rename(partial.keep(), folder)
    }

    fn said(&self, folder: &Path) -> String {
        let name = self.chapter.name();
        let file = folder.join("src/lib.rs");
        let mut said = format!("{} is yours.\n{}", shown(&file), self.carried);
        for (number, step) in (1..).zip(steps::of(self.chapter)) {
            let line = format!("  step {number}  {}", step.says);
            said += &(terminal::hanging(&line, 10) + "\n");
        }
        said + &format!(
            "Open it in your editor, and in a terminal: {} watch {name}\n",
            companion()
        )
    }
}

/// Renames the folder to the first name beside it that is free.
fn put_aside(folder: &Path) -> io::Result<PathBuf> {
    let name = |n: u32| folder.with_extension(n.to_string());
    let free = (1..).map(name).find(|path| !path.exists());
    let free = free.expect("there are more numbers than folders");
    fs::rename(folder, &free)?;
    Ok(free)
}

/// The chapter with nothing in its functions.
fn skeleton(chapter: Chapter, own: bool) -> String {
    let body = match chapter {
        Chapter::Gradient => include_str!("skeletons/gradient.rs"),
        Chapter::RedSphere => include_str!("skeletons/red_sphere.rs"),
        Chapter::Normals => include_str!("skeletons/normals.rs"),
        Chapter::HalfBSphere => include_str!("skeletons/half_b_sphere.rs"),
        Chapter::HittableList => include_str!("skeletons/hittable_list.rs"),
        Chapter::BuildTest | Chapter::SpeedVsAccuracy => unreachable!("it is not typed"),
    };
    let prelude = match own {
        true => include_str!("skeletons/own/head.rs"),
        false => include_str!("skeletons/head.rs"),
    };
    format!("{prelude}\n{body}")
}

/// The files of a prelude that the reader types.
const OWN_PRELUDE: [(&str, &str); 4] = [
    (
        "src/rtweekend.rs",
        include_str!("skeletons/own/rtweekend.rs"),
    ),
    ("src/vec3.rs", include_str!("skeletons/own/vec3.rs")),
    ("src/ray.rs", include_str!("skeletons/own/ray.rs")),
    ("src/render.rs", include_str!("skeletons/own/render.rs")),
];

/// All crates of a reader share what was built once.
const CONFIG: &str = "[build]\ntarget-dir = \"target\"\n";

/// The head of the chapter: its steps.
fn about(chapter: Chapter) -> String {
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

fn main(chapter: Chapter, own: bool) -> String {
    let name = chapter.name();
    let body = match own {
        true => format!("fn main() {{\n    print!(\"{{}}\", my_{name}::picture(400));\n}}\n"),
        false => format!(
            "fn main() -> std::process::ExitCode {{\n    common::engine::main(400, my_{name}::picture)\n}}\n"
        ),
    };
    format!("//! Prints the picture: `cargo run > {name}.ppm`\n\n{body}")
}

fn manifest(chapter: Chapter, own: bool, workspace: &Path) -> String {
    let name = chapter.name();
    let path = |package: &str| toml_string(&workspace.join(package));
    let common = format!("common = {{ path = {} }}\n", path("common"));
    let laws = format!("laws = {{ path = {} }}\n", path("tests/laws"));
    // An own prelude meets ours in the tests alone.
    let (common, common_for_tests) = match own {
        true => ("", common.as_str()),
        false => (common.as_str(), ""),
    };
    format!(
        "[package]\nname = \"my_{name}\"\nversion = \"0.1.0\"\nedition = \"2024\"\npublish = false\n\n\
         [dependencies]\n{common}\n[dev-dependencies]\n{common_for_tests}{laws}\n\
         # A workspace of its own: what breaks here breaks nothing else.\n[workspace]\n\n\
         [profile.dev]\nopt-level = 1\ndebug = \"line-tables-only\"\n"
    )
}

/// The path as TOML quotes it.
fn toml_string(path: &Path) -> String {
    format!("{:?}", path.display().to_string())
}

/// The test that puts what the chapter computes under the laws; empty where it
/// intersects nothing.
fn test(chapter: Chapter, own: bool) -> String {
    let test = match (chapter, own) {
        (Chapter::RedSphere, false) => include_str!("skeletons/laws/red_sphere.rs"),
        (Chapter::RedSphere, true) => include_str!("skeletons/own/laws/red_sphere.rs"),
        (Chapter::HittableList, false) => include_str!("skeletons/laws/hittable_list.rs"),
        (Chapter::HittableList, true) => include_str!("skeletons/own/laws/hittable_list.rs"),
        (Chapter::Normals | Chapter::HalfBSphere, false) => {
            include_str!("skeletons/laws/nearer_root.rs")
        }
        (Chapter::Normals | Chapter::HalfBSphere, true) => {
            include_str!("skeletons/own/laws/nearer_root.rs")
        }
        _ => "",
    };
    test.replace("my_chapter", &format!("my_{}", chapter.name()))
}

fn typed_parser() -> impl TypedValueParser<Value = Chapter> {
    PossibleValuesParser::new(TYPED.map(Chapter::name))
        .map(|name| Chapter::find(&name).expect("only names of chapters are accepted"))
}
