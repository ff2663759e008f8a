//! Carrying over: the functions that a reader wrote in one chapter go on into the next.
//!
//! Items that no skeleton knows, such as a function that the reader added, go to the end.

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use interpreter::nesting;
use skeletons::{How, source};
use slips::Chapter;

use crate::limited;

/// The crate that a reader wrote for a chapter.
pub(super) struct EarlierCrate {
    chapter: String,
    /// The named items of `src/lib.rs` with their texts; or why it can't be read.
    items: Result<Vec<(String, String)>, String>,
    pub(super) folder: PathBuf,
    /// The other files of `src`, by their names as seen from the crate.
    pub(super) files: Vec<PathBuf>,
}

impl EarlierCrate {
    pub(super) fn read(folder: &Path) -> Self {
        let text = limited::read_text(&folder.join("src/lib.rs"));
        let items = text.map_err(|cause| format!("src/lib.rs: {cause}"));
        let chapter = folder.file_name().unwrap_or_default();
        Self {
            chapter: chapter.to_string_lossy().into_owned(),
            items: items.and_then(|text| {
                nesting::parse_file(&text).map_err(|it| source::said(&it))?;
                items_of(&text)
            }),
            folder: folder.to_owned(),
            files: other_files(folder, Path::new("src")),
        }
    }

    /// Returns true if vectors and rays are the reader's own.
    pub(super) fn has_own_prelude(&self) -> bool {
        let prelude = Path::new("src/rtweekend.rs");
        self.files.iter().any(|name| name == prelude)
    }
}

/// The files of a chapter to be typed, and a sentence about their origin.
pub(super) struct CarriedFiles {
    pub(super) files: Vec<(&'static str, String)>,
    pub(super) said: String,
}

/// Makes the chapter's skeletons with the functions that were written before.
pub(super) fn carry_over(
    chapter: Chapter,
    own: bool,
    written: Option<&EarlierCrate>,
) -> CarriedFiles {
    let (items, said) = origin(written);
    let mut files = skeletons::files(chapter, own);
    let mut used = Vec::new();
    if own {
        // Their own prelude takes the place of ours.
        used.push("common::rtweekend::*".to_owned());
    }
    for (_, skeleton) in &files {
        let items = items_of(skeleton).expect("a skeleton is Rust");
        used.extend(items.into_iter().map(|(name, _)| name));
    }
    for (name, at, how) in skeletons::carried(chapter) {
        used.push((*name).to_owned());
        if let How::As(other) = how {
            used.push((*other).to_owned());
        }
        if let Some((_, text)) = items.iter().find(|(it, _)| it == name) {
            let file = files.iter_mut().find(|(_, text)| text.contains(at));
            let (_, skeleton) = file.expect("a skeleton has the item");
            let place = place(skeleton, at);
            match how {
                How::InPlace => skeleton.replace_range(place, text),
                How::As(other) => {
                    let text = text.replacen(&format!("fn {name}("), &format!("fn {other}("), 1);
                    skeleton.insert_str(place.start, &format!("{text}\n\n"));
                }
                // What was never written has nothing to show.
                How::Shown if text.contains("todo!()") => {}
                How::Shown => skeleton.insert_str(place.start, &as_comment(text)),
            }
        }
    }
    let (_, lib) = files.last_mut().expect("a chapter has a file");
    for (name, text) in items {
        if !used.contains(name) {
            *lib += &format!("\n{text}\n");
        }
    }
    CarriedFiles { files, said }
}

/// Finds the place, in bytes, of the item of the skeleton that has this text.
fn place(skeleton: &str, text: &str) -> Range<usize> {
    let items = source::items(skeleton).expect("a skeleton is Rust");
    let mut places = items.into_iter().map(|(_, place)| place);
    let has_it = |place: &Range<usize>| skeleton[place.clone()].contains(text);
    places.find(has_it).expect("a skeleton has the item")
}

/// Returns the items of the chapter before, and a sentence about their origin.
fn origin(written: Option<&EarlierCrate>) -> (&[(String, String)], String) {
    let Some(EarlierCrate { chapter, items, .. }) = written else {
        return (&[], String::new());
    };
    match items {
        Ok(items) => (
            items,
            format!("It begins with what you wrote in {chapter}.\n"),
        ),
        Err(why) => (
            &[],
            format!("Nothing is carried over from {chapter}, which can't be read: {why}\n"),
        ),
    }
}

/// Writes the item as a comment.
fn as_comment(text: &str) -> String {
    let is_doc = |line: &&str| line.trim_start().starts_with("///");
    let lines = text.lines().filter(|line| !is_doc(line));
    let comment: String = lines.map(|line| format!("// {line}\n")).collect();
    format!("// What you wrote before:\n//\n{comment}\n")
}

/// Lists the items of the source that have a name, with their texts.
fn items_of(source: &str) -> Result<Vec<(String, String)>, String> {
    let items = source::items(source)?.into_iter();
    Ok(items
        .map(|(name, place)| (name, source[place].to_owned()))
        .collect())
}

/// Lists the files below a folder of the crate, however deep, but for the chapter itself and hidden
/// files. A link is left where it is.
fn other_files(folder: &Path, below: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder.join(below)).into_iter().flatten();
    let mut files = Vec::new();
    for entry in entries.flatten() {
        let name = below.join(entry.file_name());
        let is_hidden = entry.file_name().to_string_lossy().starts_with('.');
        let is_chapter = ["src/lib.rs", "src/main.rs"]
            .map(Path::new)
            .contains(&&*name);
        match entry.file_type() {
            _ if is_hidden || is_chapter => {}
            Ok(kind) if kind.is_dir() => files.extend(other_files(folder, &name)),
            Ok(kind) if kind.is_file() => files.push(name),
            _ => {}
        }
    }
    files
}
