//! A manifest: a folder is ours to fill if a list in it names all that it holds.
//!
//! Files are written where they will be, each of them whole. The list comes first, with
//! the names of old and new, so what an interrupted program leaves is known to the next.

use std::collections::BTreeSet;
use std::error::Error;
use std::path::Path;
use std::{fs, io};

use common::engine::output;
use course::names::{companion, from_here};

use crate::misuse::misuse;

/// Files by their names as seen from a folder, with a slash between parts.
pub type Files = Vec<(String, Vec<u8>)>;

/// Makes `folder` hold these `files`, which are a `kind` of thing, and no others.
///
/// # Errors
/// If the folder holds anything but an earlier thing of that kind, or can't be written.
pub fn fill(folder: &Path, kind: &str, files: &Files) -> Result<(), Box<dyn Error>> {
    let old = ours(folder, kind)?;
    let names = files.iter().map(|(name, _)| name.clone());
    let new: BTreeSet<String> = names.chain([LIST.to_owned()]).collect();
    create(folder)?;
    write_list(folder, kind, old.union(&new))?;
    for name in old.difference(&new) {
        fs::remove_file(folder.join(name))?;
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

/// Refuses now what [`fill`] would refuse in the end: until then much may be computed.
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

/// What a system's file manager leaves in every folder that it has shown.
const LEFT_BY_FILE_MANAGERS: [&str; 2] = [".DS_Store", "Thumbs.db"];

/// The files in `folder` that an earlier program wrote there as a `kind` of thing.
fn ours(folder: &Path, kind: &str) -> Result<BTreeSet<String>, Box<dyn Error>> {
    let shown = from_here(folder);
    let (ours, strangers) = match sorted(folder, kind) {
        Err(cause) if cause.kind() == io::ErrorKind::NotFound => return Ok(BTreeSet::new()),
        sorted => sorted.map_err(|cause| format!("cannot look into {shown}: {cause}"))?,
    };
    // More of them say no more.
    let few: Vec<&str> = strangers.iter().take(5).map(String::as_str).collect();
    let more = match strangers.len() - few.len() {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    match few[..] {
        [] => Ok(ours),
        _ => Err(misuse(&format!(
            "{shown} holds what {} did not write there as a {kind}: {}{more}.\n\
             Nothing was changed. Move that elsewhere, or name a new folder, or an empty one.",
            companion(),
            few.join(", "),
        ))),
    }
}

/// What is in `folder`: the files that its list names, and whatever else. Names are
/// looked up in the list, never the other way round, so a list that was tampered with
/// leads nowhere.
fn sorted(folder: &Path, kind: &str) -> io::Result<(BTreeSet<String>, BTreeSet<String>)> {
    let list = fs::read_to_string(folder.join(LIST)).unwrap_or_default();
    let lines = list.strip_prefix(&heading(kind)).unwrap_or_default();
    let listed: BTreeSet<&str> = lines.lines().map(|line| line.trim_matches('"')).collect();
    let is_listed = |name: &str| name == LIST || listed.contains(name);
    let (mut ours, mut strangers) = (BTreeSet::new(), BTreeSet::new());
    let mut folders = vec![String::new()];
    while let Some(above) = folders.pop() {
        for entry in fs::read_dir(folder.join(&above))? {
            let (kind, last) = entry.and_then(|it| Ok((it.file_type()?, it.file_name())))?;
            let name = format!("{above}{}", last.to_string_lossy());
            let inside = format!("{name}/");
            let is_interrupted = || interrupted(&name).is_some_and(|whole| is_listed(&whole));
            if kind.is_dir() && listed.iter().any(|line| line.starts_with(&inside)) {
                folders.push(inside);
            } else if kind.is_file() && (is_listed(&name) || is_interrupted()) {
                ours.insert(name);
            } else if !(kind.is_file() && LEFT_BY_FILE_MANAGERS.iter().any(|it| last == *it)) {
                strangers.insert(format!("{name:?}"));
            }
        }
    }
    Ok((ours, strangers))
}

/// The file that a program was writing when it was ended and left this one: see
/// [`output::to_file`].
fn interrupted(name: &str) -> Option<String> {
    let (above, last) = name.split_at(name.rfind('/').map_or(0, |slash| slash + 1));
    let (whole, random) = last
        .strip_prefix('.')?
        .strip_suffix(".partial")?
        .rsplit_once('.')?;
    let is_random = random.len() == 16 && random.bytes().all(|digit| digit.is_ascii_hexdigit());
    is_random.then(|| format!("{above}{whole}"))
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
