//! The source files of a chapter's whole program, assembled for the interpreter.

use interpreter::SourceFile;

use crate::chapter::Chapter;
use crate::code::ChapterCode;

/// The loop over the pixels, the header and the levels of the file. The code of `common` for these
/// paints many pixels at once, which the interpreter can't run.
pub(crate) const FILE: &str = include_str!("../texts/src/file.rs");

/// Returns the judge's own source files of a chapter in Rust, which do what a reader should type. Names
/// are relative to a package: `src/lib.rs`.
pub fn typed_files(chapter: Chapter) -> Vec<SourceFile> {
    let files = chapter.files().iter();
    files
        .map(|file| SourceFile::new(file.name, file.text))
        .collect()
}

/// Returns the source files that the interpreter needs to run a chapter, `src/lib.rs` first: those
/// of the chapter, then a plain loop over the pixels. It has the prelude's text itself.
pub(crate) fn program_files(chapter: Chapter) -> Vec<SourceFile> {
    let mut files = typed_files(chapter);
    files.sort_by_key(|it| !it.name.ends_with("lib.rs"));
    files.push(SourceFile::new("src/file.rs", FILE));
    files
}
