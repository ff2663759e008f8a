//! A manifest: a folder is ours to fill if it has a list of what an earlier program wrote there.
//!
//! Files are written where they will be, each of them whole. The list comes first, with
//! the names of old and new, so what an interrupted program leaves is known to the next.

use std::collections::BTreeSet;
use std::error::Error;
use std::path::{Component, Path};
use std::{fs, io};

use common::engine::output;
use course::names::{companion, from_here, spelled};

use crate::misuse::misuse;

/// Files by their names as seen from a folder, with a slash between parts.
pub type Files = Vec<(String, Vec<u8>)>;

/// Makes `folder` hold these `files`, which are a `kind` of thing, in the place of an earlier
/// one. All else in it stays.
///
/// # Errors
/// If one of the files would take the place of a reader's, or can't be written.
pub fn fill(folder: &Path, kind: &str, files: &Files) -> Result<(), Box<dyn Error>> {
    let old = ours(folder, kind)?;
    let new: BTreeSet<String> = files.iter().map(|(name, _)| name.clone()).collect();
    let is_taken = |name: &&String| {
        let found = folder.join(name).symlink_metadata();
        found.is_ok_and(|found| !found.is_file() || !old.contains(*name))
    };
    if let Some(name) = new.iter().find(is_taken) {
        return Err(refused(folder, kind, name));
    }
    create(folder)?;
    write_list(folder, kind, old.union(&new))?;
    for name in old.difference(&new) {
        // It may have been removed before.
        let _ = fs::remove_file(folder.join(name));
        for above in Path::new(name).ancestors().skip(1) {
            // It fails for a folder with something in it, which stays.
            let _ = fs::remove_dir(folder.join(above));
        }
    }
    for (name, bytes) in files {
        let path = folder.join(name);
        create(path.parent().expect("it is in the folder"))?;
        output::to_file(&path, |out| out.write_all(bytes))?;
    }
    Ok(write_list(folder, kind, new.iter())?)
}

/// Refuses now a folder that [`fill`] would refuse in the end: until then much may be computed.
pub fn refuse_strangers(folder: &Path, kind: &str) -> Result<(), Box<dyn Error>> {
    ours(folder, kind).map(drop)
}

/// All files below `folder`.
pub fn read(folder: &Path) -> io::Result<Files> {
    let mut files = Files::new();
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

/// The name of the list.
const LIST: &str = ".rtrace-manifest";

/// The files in `folder` that an earlier program wrote there as a `kind` of thing. A folder
/// without their list must be new, or hold nothing but what is hidden.
fn ours(folder: &Path, kind: &str) -> Result<BTreeSet<String>, Box<dyn Error>> {
    let list = fs::read_to_string(folder.join(LIST)).unwrap_or_default();
    if let Some(names) = list.strip_prefix(&heading(kind)) {
        let names = names.lines().map(|line| line.trim_matches('"'));
        return Ok(names.filter(is_inside).map(str::to_owned).collect());
    }
    let entries = match fs::read_dir(folder) {
        Err(cause) if cause.kind() == io::ErrorKind::NotFound => return Ok(BTreeSet::new()),
        entries => {
            entries.map_err(|cause| format!("cannot look into {}: {cause}", from_here(folder)))?
        }
    };
    let names = entries.flatten().map(|entry| spelled(entry.file_name()));
    match names.filter(|name| !name.starts_with('.')).min() {
        Some(name) => Err(refused(folder, kind, &name)),
        None => Ok(BTreeSet::new()),
    }
}

/// Whether the name leads to a place in the folder: anybody may have written into the list.
fn is_inside(name: &&str) -> bool {
    let mut parts = Path::new(name).components();
    parts.all(|part| matches!(part, Component::Normal(_)))
}

fn refused(folder: &Path, kind: &str, name: &str) -> Box<dyn Error> {
    misuse(&format!(
        "{} holds {name}, which {} did not write there as part of a {kind}\n\
         Nothing was changed. Move that elsewhere, or name a new folder, or an empty one.",
        from_here(folder),
        companion(),
    ))
}

fn write_list<'a>(
    folder: &Path,
    kind: &str,
    names: impl Iterator<Item = &'a String>,
) -> io::Result<()> {
    let lines: String = names.map(|name| format!("{name:?}\n")).collect();
    let list = heading(kind) + &lines;
    output::to_file(&folder.join(LIST), |out| out.write_all(list.as_bytes()))
}

fn heading(kind: &str) -> String {
    format!("This {kind} is replaced as a whole by the next one. cargo rtrace wrote:\n")
}

fn create(folder: &Path) -> Result<(), String> {
    fs::create_dir_all(folder).map_err(|cause| {
        let shown = from_here(folder);
        format!("cannot create the folder {shown}: {cause}\nName one that you may write to.")
    })
}
