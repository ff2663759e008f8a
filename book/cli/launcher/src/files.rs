//! A manifest: a folder is ours to fill if it has a list of what an earlier program wrote there.
//!
//! Files are written where they will be, each of them whole. The list comes first, with the names
//! and checksums of old and new, so what an interrupted program leaves is known to the next. A
//! file is ours if its name and its bytes are on the list, and no link leads to it.

use std::collections::BTreeSet;
use std::error::Error;
use std::path::{Component, Path};
use std::{fs, io};

use common::engine::output;
use course::names::{companion_command, escaped_name, name_from_here};

use crate::limited;
use crate::misuse::misuse;

/// Files by their names as seen from a folder, with a slash between parts.
pub type FolderFiles = Vec<(String, Vec<u8>)>;

/// Lines, each with the checksum of a file and its name.
type ManifestLines = BTreeSet<String>;

/// Makes `folder` hold these `files`, which are a `kind` of thing, in the place of an earlier
/// one. All else in it stays.
///
/// # Errors
/// If one of the files would take the place of a reader's, or can't be written.
pub fn fill_folder(folder: &Path, kind: &str, files: &FolderFiles) -> Result<(), Box<dyn Error>> {
    let old = ours(folder, kind)?;
    let new: ManifestLines = files
        .iter()
        .map(|(name, bytes)| line(name, bytes))
        .collect();
    let mut names = files.iter().map(|(name, _)| name);
    if let Some(name) = names.find(|name| !is_missing(folder, name) && !is_ours(folder, name, &old))
    {
        return Err(refused(folder, kind, name));
    }
    create(folder)?;
    output::forget_partials(&folder.join(LIST));
    write_list(folder, kind, old.union(&new))?;
    let names: BTreeSet<&str> = new.iter().filter_map(|it| name(it)).collect();
    for name in old.iter().filter_map(|it| name(it)) {
        output::forget_partials(&folder.join(name));
        if !names.contains(name) && is_ours(folder, name, &old) {
            remove(folder, name);
        }
    }
    for (name, bytes) in files {
        let path = folder.join(name);
        create(path.parent().unwrap_or(folder))?;
        output::to_file(&path, |out| out.write_all(bytes))?;
    }
    // What could not be removed stays ours.
    let is_left = |line: &&String| {
        name(line).is_some_and(|it| !names.contains(it) && !is_missing(folder, it))
    };
    let left: ManifestLines = old.iter().filter(is_left).cloned().collect();
    Ok(write_list(folder, kind, new.union(&left))?)
}

/// Removes the file, and the folders that it leaves empty.
fn remove(folder: &Path, name: &str) {
    // It may have been removed before.
    let _ = fs::remove_file(folder.join(name));
    for above in Path::new(name).ancestors().skip(1) {
        // It fails for a folder with something in it, which stays.
        let _ = fs::remove_dir(folder.join(above));
    }
}

/// Returns true if nothing is there, and no link on the way to it.
fn is_missing(folder: &Path, name: &str) -> bool {
    let found = folder.join(name).symlink_metadata();
    found.is_err_and(|cause| cause.kind() == io::ErrorKind::NotFound) && has_no_link(folder, name)
}

/// Returns true if a file is there that is on the list, and no link on the way to it.
fn is_ours(folder: &Path, name: &str, list: &ManifestLines) -> bool {
    let path = folder.join(name);
    let is_file = path.symlink_metadata().is_ok_and(|it| it.is_file());
    let is_listed = || {
        limited::read_bytes(&path, LONGEST).is_ok_and(|bytes| list.contains(&line(name, &bytes)))
    };
    is_file && has_no_link(folder, name) && is_listed()
}

/// Returns true if only folders are on the way to the file, or nothing yet.
fn has_no_link(folder: &Path, name: &str) -> bool {
    let mut above = Path::new(name).ancestors().skip(1);
    above.all(|above| {
        let found = folder.join(above).symlink_metadata();
        above.as_os_str().is_empty() || found.map_or(true, |found| found.is_dir())
    })
}

/// Writes the line of the list for a file.
fn line(name: &str, bytes: &[u8]) -> String {
    format!("{:08x} {name:?}", crc32fast::hash(bytes))
}

/// Returns the name on a line of the list, if it leads to a place in the folder: anybody may have
/// written into the list.
fn name(line: &str) -> Option<&str> {
    let (_, name) = line.split_once(' ')?;
    let name = name.trim_matches('"');
    let mut parts = Path::new(name).components();
    let is_inside = parts.all(|part| matches!(part, Component::Normal(_)));
    is_inside.then_some(name)
}

/// Refuses at once a folder that [`fill_folder`] would refuse after all files are computed.
///
/// # Errors
/// If the folder holds something that is not of an earlier `kind`, or can't be read.
pub fn refuse_strangers(folder: &Path, kind: &str) -> Result<(), Box<dyn Error>> {
    ours(folder, kind).map(drop)
}

/// Reads all files below `folder`.
///
/// # Errors
/// If one can't be read.
pub fn read_folder(folder: &Path) -> io::Result<FolderFiles> {
    let mut files = FolderFiles::new();
    let mut folders = vec![String::new()];
    while let Some(above) = folders.pop() {
        for entry in fs::read_dir(folder.join(&above))? {
            let entry = entry?;
            let name = format!("{above}{}", entry.file_name().to_string_lossy());
            if entry.file_type()?.is_dir() {
                folders.push(name + "/");
            } else {
                files.push((name, fs::read(entry.path())?));
            }
        }
    }
    Ok(files)
}

/// The name of the list, and how long it may be.
const LIST: &str = ".rtrace-manifest";
const MOST_BYTES: u64 = 1 << 20;

/// No file that is written here is longer.
const LONGEST: u64 = 1 << 26;

/// Reads the list of files that an earlier program wrote into `folder` as a `kind` of thing. A
/// folder without it must be new, or hold nothing but what is hidden.
fn ours(folder: &Path, kind: &str) -> Result<ManifestLines, Box<dyn Error>> {
    let list = folder.join(LIST);
    if let Ok(found) = list.symlink_metadata() {
        let text = limited::read_bytes(&list, MOST_BYTES)
            .ok()
            .filter(|_| found.is_file());
        let text = text.and_then(|bytes| String::from_utf8(bytes).ok());
        let lines = text.as_ref().and_then(|it| it.strip_prefix(&heading(kind)));
        let lines = lines.ok_or_else(|| refused(folder, kind, LIST))?;
        return Ok(lines.lines().map(str::to_owned).collect());
    }
    let entries = match fs::read_dir(folder) {
        Err(cause) if cause.kind() == io::ErrorKind::NotFound => return Ok(ManifestLines::new()),
        entries => entries
            .map_err(|cause| format!("cannot look into {}: {cause}", name_from_here(folder)))?,
    };
    let names = entries
        .flatten()
        .map(|entry| escaped_name(entry.file_name()));
    match names.filter(|name| !name.starts_with('.')).min() {
        Some(name) => Err(refused(folder, kind, &name)),
        None => Ok(ManifestLines::new()),
    }
}

fn refused(folder: &Path, kind: &str, name: &str) -> Box<dyn Error> {
    misuse(&format!(
        "{} holds {name}, which {} did not write there as part of a {kind}\n\
         Nothing was changed. Move that elsewhere, or name a new folder, or an empty one.",
        name_from_here(folder),
        companion_command(),
    ))
}

fn write_list<'a>(
    folder: &Path,
    kind: &str,
    lines: impl Iterator<Item = &'a String>,
) -> io::Result<()> {
    let lines: String = lines.map(|line| format!("{line}\n")).collect();
    let list = heading(kind) + &lines;
    output::to_file(&folder.join(LIST), |out| out.write_all(list.as_bytes()))
}

fn heading(kind: &str) -> String {
    format!("This {kind} is replaced as a whole by the next one. cargo rtrace wrote:\n")
}

fn create(folder: &Path) -> Result<(), String> {
    fs::create_dir_all(folder).map_err(|cause| {
        let shown = name_from_here(folder);
        format!("cannot create the folder {shown}: {cause}\nName one that you may write to.")
    })
}
