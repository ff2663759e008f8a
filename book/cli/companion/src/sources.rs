//! Source discovery: finds the files of a crate that `start` made, and knows a source by its name.

use std::fs;
use std::path::{Path, PathBuf};

use check::sources::{SourceFile, Sources};
use slips::Chapter;

use crate::limited;

/// Reads the files of a crate that `start` made for `chapter`, beside the chapter's own.
pub(crate) fn of_crate(folder: &Path, chapter: Chapter) -> Sources {
    Sources::of_chapter(rust_files(folder), chapter)
}

/// Reads the files in Rust below `src` of a crate.
pub(crate) fn rust_files(folder: &Path) -> Vec<SourceFile> {
    texts(folder, &all_in(folder, Path::new("src")))
}

/// The endings of the names of source files.
const ENDINGS: [&str; 20] = [
    "rs", "cc", "cpp", "cxx", "h", "hpp", "hxx", "c", "py", "js", "mjs", "cjs", "ts", "mts",
    "java", "cs", "go", "kt", "kts", "swift",
];

/// Returns true if the file is a source in a usual language, by the ending of its name.
pub(crate) fn is_source(path: &Path) -> bool {
    let ending = path.extension().and_then(|it| it.to_str());
    ending.is_some_and(|it| ENDINGS.contains(&it))
}

/// The number of files that no program of these chapters exceeds.
const MOST_FILES: usize = 40;
/// The number of folders, one in the other, that no program of these chapters exceeds.
const DEEPEST: usize = 3;

/// Lists the files in Rust in the folder `below` and the folders in it, each with its path from
/// `folder`: at most [`MOST_FILES`], the nearest first.
fn all_in(folder: &Path, below: &Path) -> Vec<PathBuf> {
    let mut all = Vec::new();
    let mut folders = vec![below.to_owned()];
    for _ in 0..=DEEPEST {
        let mut next = Vec::new();
        for below in folders {
            let entries = fs::read_dir(folder.join(&below))
                .into_iter()
                .flatten()
                .flatten();
            let mut paths: Vec<_> = entries.map(|it| below.join(it.file_name())).collect();
            paths.sort();
            for path in paths {
                match folder.join(&path).symlink_metadata() {
                    Ok(it) if it.is_dir() => next.push(path),
                    Ok(_) if path.extension().is_some_and(|it| it == "rs") => all.push(path),
                    _ => {}
                }
            }
        }
        folders = next;
    }
    all.truncate(MOST_FILES);
    all
}

/// Reads the files, but for those that are too long or are not UTF-8.
fn texts(folder: &Path, files: &[PathBuf]) -> Vec<SourceFile> {
    let file = |it: &PathBuf| {
        let text = limited::read_text(&folder.join(it)).ok()?;
        Some(SourceFile::new(it.to_str()?, text))
    };
    files.iter().filter_map(file).collect()
}
