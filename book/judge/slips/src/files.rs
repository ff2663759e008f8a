//! The source files of a chapter's whole program, assembled for the interpreter.

use interpreter::SourceFile;

use crate::chapter::Chapter;
use crate::code::ChapterCode;

/// Embeds a text of the prelude.
macro_rules! prelude {
    ($name:literal) => {
        (
            $name,
            include_str!(concat!("../texts/src/prelude/", $name, ".rs")),
        )
    };
}

/// The loop over the pixels, the header and the levels of the file.
pub(crate) const FILE: (&str, &str) = prelude!("file");
/// What every program of rays uses.
const OF_RAYS: [(&str, &str); 4] = [
    prelude!("camera"),
    prelude!("render"),
    prelude!("vectors"),
    prelude!("ray"),
];
/// What chapters with spheres use besides. The first chapter with rays has no function for its sky.
const OF_SPHERES: [(&str, &str); 2] = [prelude!("color"), prelude!("dot")];

/// Returns the source files in Rust of a chapter's package, as a reader of the chapter should type
/// them. Names are relative to the package: `src/lib.rs`.
pub fn typed_files(chapter: Chapter) -> Vec<SourceFile> {
    let files = chapter.files().iter();
    files
        .map(|file| SourceFile::new(file.name, file.text))
        .collect()
}

/// Returns the source files that the interpreter needs to run a chapter, `src/lib.rs` first: those
/// of the chapter, then a plain loop over the pixels, and for a chapter with rays what it uses of
/// the prelude.
pub fn program_files(chapter: Chapter) -> Vec<SourceFile> {
    let mut files = typed_files(chapter);
    files.sort_by_key(|it| !it.name.ends_with("lib.rs"));
    let mut add = |all: &[(&str, &str)]| {
        let all = all.iter();
        files.extend(all.map(|(name, text)| SourceFile::new(format!("src/{name}.rs"), *text)));
    };
    add(&[FILE]);
    if chapter > Chapter::BuildTest {
        add(&OF_RAYS);
    }
    if chapter > Chapter::Gradient {
        add(&OF_SPHERES);
    }
    files
}
