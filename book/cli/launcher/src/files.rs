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

/// The files of a folder and of all folders below, each with its path from that folder, with `/`,
/// and its bytes.
pub type FolderFiles = Vec<(String, Vec<u8>)>;

/// The lines of a manifest, each with the checksum of a file and its name.
type ManifestLines = BTreeSet<String>;

/// Writes `files` into `folder`, which is made if it is missing. Other files that an earlier call
/// wrote there are removed, unless they have changed since. Files that are not in the folder's
/// manifest, the list of what an earlier call wrote, stay. `kind` names the whole in messages, such
/// as `report`, and has to be that of the earlier call.
///
/// # Errors
/// If a file that is no longer as it was written, or another program's, is in the way, in which
/// case nothing is changed; or if a file can't be written.
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

/// Removes a file, and the folders that are empty then.
fn remove(folder: &Path, name: &str) {
    // It may have been removed before.
    let _ = fs::remove_file(folder.join(name));
    for above in Path::new(name).ancestors().skip(1) {
        // It fails for a folder with something in it, which stays.
        let _ = fs::remove_dir(folder.join(above));
    }
}

/// Returns true if nothing has that name in the folder, and no link is on the way to it.
fn is_missing(folder: &Path, name: &str) -> bool {
    let found = folder.join(name).symlink_metadata();
    found.is_err_and(|cause| cause.kind() == io::ErrorKind::NotFound) && has_no_link(folder, name)
}

/// Returns true if the folder has a file of that name whose checksum is on the list, and no link is
/// on the way to it.
fn is_ours(folder: &Path, name: &str, list: &ManifestLines) -> bool {
    let path = folder.join(name);
    let is_file = path.symlink_metadata().is_ok_and(|it| it.is_file());
    let is_listed = || {
        limited::read_bytes(&path, LONGEST).is_ok_and(|bytes| list.contains(&line(name, &bytes)))
    };
    is_file && has_no_link(folder, name) && is_listed()
}

/// Returns true if all that is on the way to the file are folders, or missing.
fn has_no_link(folder: &Path, name: &str) -> bool {
    let mut above = Path::new(name).ancestors().skip(1);
    above.all(|above| {
        let found = folder.join(above).symlink_metadata();
        above.as_os_str().is_empty() || found.map_or(true, |found| found.is_dir())
    })
}

/// Writes the line of the manifest for a file.
fn line(name: &str, bytes: &[u8]) -> String {
    format!("{:08x} {name:?}", crc32fast::hash(bytes))
}

/// Returns the name on a line of the manifest; `None` if it leads out of the folder, for anybody
/// may have written into the manifest.
fn name(line: &str) -> Option<&str> {
    let (_, name) = line.split_once(' ')?;
    let name = name.trim_matches('"');
    let mut parts = Path::new(name).components();
    let is_inside = parts.all(|part| matches!(part, Component::Normal(_)));
    is_inside.then_some(name)
}

/// Refuses a folder that [`fill_folder`] would refuse whatever the files are, so that these need
/// not be computed. `kind` is what [`fill_folder`] would get.
///
/// # Errors
/// If the folder has files but no manifest of this `kind`, or can't be read. An empty and a missing
/// folder are no error; nor is one with nothing but hidden files.
pub fn refuse_strangers(folder: &Path, kind: &str) -> Result<(), Box<dyn Error>> {
    ours(folder, kind).map(drop)
}

/// Reads all files below `folder`, hidden ones included, in no order. Does not enter links to
/// folders: reading one is an error.
///
/// # Errors
/// If a file or a folder can't be read.
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

/// The name of the manifest.
const LIST: &str = ".rtrace-manifest";
/// The length that no manifest exceeds, in bytes.
const MOST_BYTES: u64 = 1 << 20;

/// The length that no file of a report or of the book exceeds, in bytes.
const LONGEST: u64 = 1 << 26;

/// Reads the manifest of `folder`, a list of what an earlier program wrote there as a `kind` of
/// thing. Empty for a folder that is missing, or has nothing but hidden files.
///
/// # Errors
/// If the folder has files but no manifest, one of another kind, or one that can't be read.
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
         Nothing was changed. Move {name} elsewhere, or name a new folder, or an empty one.",
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
