//! The source files of a chapter's whole program, assembled for the interpreter.

use interpreter::SourceFile;

use crate::chapter::Chapter;
use crate::code::ChapterCode;

// The sources of `common` that a program of rays uses.
const CAMERA: &str = include_str!("../../../../common/src/camera.rs");
const RENDER: &str = include_str!("../../../../common/src/engine/render.rs");
const COLOR: &str = include_str!("../../../../common/src/color.rs");
/// The program around a chapter: the loop over the pixels, the header and the levels of the file.
pub(crate) const FILE: &str = include_str!("text/file.rs");
/// Functions of vectors and rays that take the place of the library's.
const VECTORS: &str = include_str!("text/vectors.rs");
/// The dot product, for chapters that use it.
const DOT: &str = include_str!("text/dot.rs");

/// Returns the source files in Rust of a chapter's package, as a reader of the chapter should type
/// them. Names are relative to the package: `src/lib.rs`.
pub fn typed_files(chapter: Chapter) -> Vec<SourceFile> {
    let files = chapter.files().iter();
    files
        .map(|file| SourceFile::new(file.name, file.text))
        .collect()
}

/// Returns the source files that the interpreter needs to run a chapter, `src/lib.rs` first: those
/// of the chapter, then a plain loop over the pixels, and for a chapter with rays the camera and
/// the functions of `common` that the chapter uses.
pub fn program_files(chapter: Chapter) -> Vec<SourceFile> {
    let mut files = typed_files(chapter);
    files.sort_by_key(|it| !it.name.ends_with("lib.rs"));
    let mut add = |name: &str, text: &str, imported: &str| {
        files[0].text += &format!("\nmod {name};\n{imported}");
        // What stands first in a file comes later here.
        let is_own = |line: &&str| !line.starts_with("use ") && !line.starts_with("//!");
        let own = text.lines().filter(is_own);
        let own = own.fold(String::new(), |text, line| text + line + "\n");
        let import = match name {
            "render" => "use crate::camera::Camera;\n",
            _ => "",
        };
        let own = format!("use common::rtweekend::*;\n{import}{own}");
        files.push(SourceFile::new(format!("src/{name}.rs"), own));
    };
    add("file", FILE, "");
    if chapter > Chapter::BuildTest {
        add("camera", CAMERA, "");
        add("render", RENDER, "use crate::render::render;\n");
        add("vectors", VECTORS, "");
    }
    // The first chapter with rays has no function for its sky.
    if chapter > Chapter::Gradient {
        let sky = COLOR.split("\n/// Stores").next().unwrap_or_default();
        add("color", sky, "use crate::color::sky;\n");
        add("dot", DOT, "");
    }
    files
}

/// Returns the path in this workspace of a file from [`program_files`].
pub(crate) fn path_in_workspace(chapter: Chapter, name: &str) -> String {
    match name {
        "src/camera.rs" | "src/color.rs" => format!("common/{name}"),
        "src/render.rs" => "common/src/engine/render.rs".to_owned(),
        "src/vectors.rs" | "src/dot.rs" => "common/src/vec3.rs".to_owned(),
        "src/file.rs" => "book/judge/slips/src/text/file.rs".to_owned(),
        name => format!("chapters/{}_{}/{name}", chapter as usize, chapter.name()),
    }
}
