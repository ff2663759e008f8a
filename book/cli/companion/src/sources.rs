//! Source discovery: what a reader wrote, where it can be found.

use std::ffi::OsString;
use std::fs;
use std::path::Path;

use check::sources::Sources;
use slips::{Chapter, Edition, Letters};

use crate::short;

/// Reads the files of a crate that `start` made, beside those of the chapter.
pub(crate) fn of_crate(folder: &Path, chapter: Chapter) -> Sources {
    Sources::of_chapter(files_in(&folder.join("src"), "src/"), chapter)
}

/// Reads the files of a program of the reader's own, and finds their language: the one that its
/// command names, or else those of the folder, unless it has several programs.
pub(crate) fn of_program(words: &[OsString], folder: &Path) -> (Sources, Option<Letters>) {
    let named = words.iter().map(|word| folder.join(word));
    let named: Vec<_> = named.filter(|path| is_source(path)).collect();
    let files = match &named[..] {
        [] => [files_in(folder, ""), files_in(&folder.join("src"), "src/")].concat(),
        paths => paths.iter().filter_map(|path| file(path, "")).collect(),
    };
    let is_program = |(_, text): &&(String, String)| text.contains(" main(");
    if files.iter().filter(is_program).count() > 1 {
        return (Sources::default(), None);
    }
    let first = files.first().and_then(|(name, _)| language(name.as_ref()));
    (Sources::new(files, Vec::new()), first.flatten())
}

/// Reads the only source in a picture's folder, and finds its language, unless it was changed after
/// the picture was drawn.
pub(crate) fn beside(picture: &Path) -> (Sources, Option<Letters>) {
    let changed = |path: &Path| fs::metadata(path).and_then(|it| it.modified()).ok();
    let folder = picture.parent().unwrap_or(Path::new(""));
    let folder = if folder.as_os_str().is_empty() {
        Path::new(".")
    } else {
        folder
    };
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let sources = entries
        .map(|entry| entry.path())
        .filter(|path| is_source(path));
    match &sources.collect::<Vec<_>>()[..] {
        [source] if changed(source) <= changed(picture) => {
            of_program(&[source.into()], Path::new(""))
        }
        _ => (Sources::default(), None),
    }
}

/// Returns true if the file is a source in a language that is known here.
pub(crate) fn is_source(path: &Path) -> bool {
    language(path).is_some()
}

/// No program of these chapters has more files.
const MOST_FILES: usize = 40;

/// Reads the sources in the folder itself, by their names, with `before` before them.
fn files_in(folder: &Path, before: &str) -> Vec<(String, String)> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut paths: Vec<_> = entries.map(|entry| entry.path()).collect();
    paths.sort();
    let sources = paths.iter().filter(|path| is_source(path));
    let files = sources.filter_map(|path| file(path, before));
    files.take(MOST_FILES).collect()
}

fn file(path: &Path, before: &str) -> Option<(String, String)> {
    let text = short::text(path).ok()?;
    Some((format!("{before}{}", path.file_name()?.display()), text))
}

/// Finds the language of a source file, in which a slip can be said if it has a name here; `None`
/// for any other file.
pub(crate) fn language(path: &Path) -> Option<Option<Letters>> {
    match path.extension()?.to_str()? {
        "rs" => Some(Some(Letters::Rust)),
        "py" => Some(Some(Letters::Python(Edition::V4))),
        "cc" | "cpp" | "cxx" | "c" | "h" | "hpp" => Some(None),
        _ => None,
    }
}
