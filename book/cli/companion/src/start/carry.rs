//! Carrying over: the functions that a reader wrote in one chapter go on into the next.
//!
//! Items that no skeleton knows, such as a function that the reader added, go to the end.

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use interpreter::{SourceFile, nesting};
use skeletons::CarriedPlace;
use skeletons::source::{self, NamedItem};
use slips::Chapter;

use crate::limited;

/// The crate that a reader wrote for an earlier chapter.
pub(super) struct EarlierCrate {
    chapter: String,
    /// The named items of `src/lib.rs`, from the top; or why that file can't be read.
    items: Result<Vec<NamedItem>, String>,
    pub(super) folder: PathBuf,
    /// The other files of `src`, by their paths from the crate.
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
                nesting::parse_file(&text).map_err(|it| source::describe_error(&it))?;
                source::items(&text)
            }),
            folder: folder.to_owned(),
            files: other_files(folder, Path::new("src")),
        }
    }

    /// Returns true if the reader typed vectors and rays, too.
    pub(super) fn has_own_prelude(&self) -> bool {
        let prelude = Path::new("src/rtweekend.rs");
        self.files.iter().any(|name| name == prelude)
    }
}

/// The files of a chapter to be typed, and a sentence about their origin, empty for a first crate.
pub(super) struct CarriedFiles {
    pub(super) files: Vec<SourceFile>,
    pub(super) said: String,
}

/// Makes the skeletons of a chapter, with the functions of the reader's earlier crate put into
/// them. With `own`, they use a prelude of the reader's own.
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
    for skeleton in &files {
        let items = source::items(&skeleton.text).expect("a skeleton is Rust");
        used.extend(items.into_iter().map(|item| item.name));
    }
    for function in skeletons::carried_functions(chapter) {
        let name = function.name;
        used.push(name.to_owned());
        if let CarriedPlace::AboveAs(other) = function.place {
            used.push(other.to_owned());
        }
        if let Some(NamedItem { text, .. }) = items.iter().find(|item| item.name == name) {
            let has_item = |file: &&mut SourceFile| file.text.contains(function.item);
            let file = files.iter_mut().find(has_item);
            let skeleton = &mut file.expect("a skeleton has the item").text;
            let place = place(skeleton, function.item);
            match function.place {
                CarriedPlace::Instead => skeleton.replace_range(place, text),
                CarriedPlace::AboveAs(other) => {
                    let text = text.replacen(&format!("fn {name}("), &format!("fn {other}("), 1);
                    skeleton.insert_str(place.start, &format!("{text}\n\n"));
                }
                // What was never written has nothing to show.
                CarriedPlace::AboveAsComment if text.contains("todo!()") => {}
                CarriedPlace::AboveAsComment => {
                    skeleton.insert_str(place.start, &as_comment(text));
                }
            }
        }
    }
    let lib = files.last_mut().expect("a chapter has a file");
    for NamedItem { name, text, .. } in items {
        if !used.contains(name) {
            lib.text += &format!("\n{text}\n");
        }
    }
    CarriedFiles { files, said }
}

/// Finds the range of bytes of the skeleton's item that has `text` in it.
fn place(skeleton: &str, text: &str) -> Range<usize> {
    let items = source::items(skeleton).expect("a skeleton is Rust");
    let mut places = items.into_iter().map(|item| item.place);
    let has_it = |place: &Range<usize>| skeleton[place.clone()].contains(text);
    places.find(has_it).expect("a skeleton has the item")
}

/// Returns the items of the earlier crate, and a sentence about the origin of the new one.
fn origin(written: Option<&EarlierCrate>) -> (&[NamedItem], String) {
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

/// Writes the item as a comment, without its documentation.
fn as_comment(text: &str) -> String {
    let is_doc = |line: &&str| line.trim_start().starts_with("///");
    let lines = text.lines().filter(|line| !is_doc(line));
    let comment: String = lines.map(|line| format!("// {line}\n")).collect();
    format!("// What you wrote before:\n//\n{comment}\n")
}

/// Lists the files below a folder of the crate, but for `src/lib.rs`, `src/main.rs`, hidden ones
/// and links.
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
