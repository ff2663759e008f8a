//! A manifest: the list, in a folder, of what a program wrote there.
//!
//! It tells a program's own folder from everybody else's. A line names a file, or with
//! a slash after it a folder. What is in the folder is looked up in the list, never
//! the other way round, so a list that was tampered with leads nowhere.

use std::collections::BTreeSet;
use std::fs::{self, FileType};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// The name of the list.
const NAME: &str = ".rtrace-manifest";

/// What a system's file manager leaves in every folder that it has shown.
const LEFT_BY_FILE_MANAGERS: [&str; 2] = [".DS_Store", "Thumbs.db"];

/// Whether `folder` is a folder that holds something, and no list of it.
pub fn is_unlisted(folder: &Path) -> bool {
    let holds_something = fs::read_dir(folder).is_ok_and(|mut found| found.next().is_some());
    holds_something && !folder.join(NAME).is_file()
}

/// Lists what `folder` holds: a `kind` of thing.
pub(super) fn write(folder: &Path, kind: &str) -> io::Result<()> {
    let mut list = heading(kind) + "\n";
    let lines: BTreeSet<String> = entries(folder, |_| true)?
        .into_iter()
        .map(|entry| entry.line)
        .collect();
    for line in lines {
        list += &line;
        list.push('\n');
    }
    fs::write(folder.join(NAME), list)
}

/// What `folder` holds that is not in its list, or all of it if that is not the list
/// of a `kind` of thing.
pub(super) fn strangers(folder: &Path, kind: &str) -> io::Result<Vec<String>> {
    loop {
        let list = List::of(folder);
        let found = entries(folder, |line| list.has(kind, line));
        // Another program may have put its own folder here meanwhile.
        if list == List::of(folder) {
            let mut strangers = found?;
            strangers
                .retain(|entry| !list.has(kind, &entry.line) && !entry.is_left_by_a_file_manager());
            let mut lines: Vec<String> = strangers.into_iter().map(|entry| entry.line).collect();
            lines.sort();
            return Ok(lines);
        }
    }
}

/// Removes what is in the list of `folder`, and the folder itself if nothing else is
/// in it. The list goes last: until then it is known what may go.
pub(super) fn remove_listed(folder: &Path) {
    let list = List::of(folder);
    let found = entries(folder, |line| list.lines.contains(line)).unwrap_or_default();
    // A folder is found before what is in it.
    for entry in found.iter().rev() {
        if !list.lines.contains(&entry.line) && !entry.is_left_by_a_file_manager() {
            continue;
        }
        // What can't be removed keeps its folder from being removed.
        let _ = match entry.kind.is_dir() {
            true => fs::remove_dir(&entry.path),
            false => fs::remove_file(&entry.path),
        };
    }
    let alone = fs::read_dir(folder).is_ok_and(|rest| rest.count() == 1);
    if alone && !list.lines.is_empty() {
        let _ = fs::remove_file(folder.join(NAME));
    }
    let _ = fs::remove_dir(folder);
}

#[derive(PartialEq)]
struct List {
    heading: String,
    lines: BTreeSet<String>,
}

impl List {
    /// The list in `folder`, or an empty one.
    fn of(folder: &Path) -> Self {
        let text = fs::read_to_string(folder.join(NAME)).unwrap_or_default();
        let mut lines = text.lines().map(str::to_owned);
        Self {
            heading: lines.next().unwrap_or_default(),
            lines: lines.collect(),
        }
    }

    fn has(&self, kind: &str, line: &str) -> bool {
        self.heading == heading(kind) && (self.lines.contains(line) || line == quoted(NAME))
    }
}

fn heading(kind: &str) -> String {
    format!("This {kind} is replaced as a whole by the next one. cargo rtrace wrote:")
}

/// A file, a folder or a link.
struct Entry {
    /// How it is listed.
    line: String,
    path: PathBuf,
    kind: FileType,
}

impl Entry {
    fn is_left_by_a_file_manager(&self) -> bool {
        let name = self.path.file_name().unwrap_or_default();
        self.kind.is_file() && LEFT_BY_FILE_MANAGERS.iter().any(|left| name == *left)
    }
}

/// What is in `folder`, and in those folders in it whose lines it `enters`.
fn entries(folder: &Path, enters: impl Fn(&str) -> bool) -> io::Result<Vec<Entry>> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        let inside = match fs::read_dir(&next) {
            // It went meanwhile, so there is nothing in it.
            Err(cause) if cause.kind() == ErrorKind::NotFound => continue,
            inside => inside?,
        };
        for entry in inside {
            let entry = entry?;
            let (path, kind) = (entry.path(), entry.file_type()?);
            let line = line(path.strip_prefix(folder).unwrap_or(&path), kind);
            if kind.is_dir() && enters(&line) {
                folders.push(path.clone());
            }
            found.push(Entry { line, path, kind });
        }
    }
    Ok(found)
}

/// In quotation marks, with escapes for whatever could not be read or would end the
/// line. The sign at the end tells a folder, or a link, that took the place of a file.
fn line(path: &Path, kind: FileType) -> String {
    let sign = match (kind.is_dir(), kind.is_file()) {
        (true, _) => "/",
        (_, true) => "",
        _ => "@",
    };
    quoted(path) + sign
}

fn quoted(path: impl AsRef<Path>) -> String {
    format!("{:?}", path.as_ref())
}
