//! A folder that is replaced whole: the new one is made beside it, and renamed when it is complete.
//!
//! A marker in the folder lists the files that were written there. A folder with anything else in
//! it is the reader's, and stays as it is.

use std::collections::BTreeSet;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::{fs, io};

use launcher::limited;
use launcher::misuse::misuse;
use launcher::names::{escaped_name, name_from_here};
use launcher::output;

/// Puts a new folder in the place of `folder`, which is missing, empty, or was made by an earlier
/// call. `make` fills the new one, whose path it gets: an empty folder beside `folder`.
///
/// A program that is interrupted leaves the old folder or the new one, or in the instant between
/// two renames neither; the next call removes what is left beside it.
///
/// # Errors
/// If `folder` is a link or holds a link, or a file that no earlier call has written there: then
/// nothing is changed. If `make` fails, or a folder can't be made or renamed.
pub fn replace(
    folder: &Path,
    make: impl FnOnce(&Path) -> Result<(), Box<dyn Error>>,
) -> Result<(), Box<dyn Error>> {
    let folder = &whole_path(folder)?;
    refuse_strangers(folder)?;
    let [new, old] = [output::partial(folder)?, output::partial(folder)?];
    output::forget_partials(folder);
    let made = make_whole(&new, make).and_then(|()| {
        // Making it may take seconds.
        refuse_strangers(folder)?;
        exchange(folder, &new, &old).map_err(|cause| {
            let shown = name_from_here(folder);
            format!("cannot put the new folder in the place of {shown}: {cause}").into()
        })
    });
    // Of the two, what is left is ours: the new folder if it has failed, else the old one.
    for ours in [new, old] {
        let _ = fs::remove_dir_all(ours);
    }
    made
}

/// Makes the folder above, if it is missing, and returns the whole path: to rename `a` would break
/// `a/../a`.
fn whole_path(folder: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let nameless = || misuse(&format!("{folder:?} is no name for a new folder"));
    let name = folder.file_name().ok_or_else(nameless)?;
    let above = match folder.parent() {
        Some(above) if !above.as_os_str().is_empty() => above,
        _ => Path::new("."),
    };
    let found = fs::create_dir_all(above).and_then(|()| fs::canonicalize(above));
    let found = found.map_err(|cause| {
        let shown = name_from_here(above);
        format!("cannot make the folder {shown}: {cause}\nName one where you may write.")
    })?;
    Ok(found.join(name))
}

/// Makes the folder `new`, and writes the list of all files that `make` has put into it.
fn make_whole(
    new: &Path,
    make: impl FnOnce(&Path) -> Result<(), Box<dyn Error>>,
) -> Result<(), Box<dyn Error>> {
    fs::create_dir(new).map_err(|cause| {
        let shown = name_from_here(new);
        format!("cannot make the folder {shown}: {cause}\nName one where you may write.")
    })?;
    make(new)?;
    let mut names = String::from(HEADING);
    walk(new, "", &mut |name, _| {
        names += &format!("{name}\n");
        Ok(())
    })?;
    Ok(fs::write(new.join(MARKER), names)?)
}

/// Moves `folder`, if it is there, to `old`, and `new` to its place.
fn exchange(folder: &Path, new: &Path, old: &Path) -> io::Result<()> {
    let is_there = folder.exists();
    if is_there {
        fs::rename(folder, old)?;
    }
    fs::rename(new, folder).inspect_err(|_| {
        // The failure to report is the first one, whether or not this works.
        let _ = is_there.then(|| fs::rename(old, folder));
    })
}

/// Returns an error if the folder, or the marker in it, is not ours to replace.
fn refuse_strangers(folder: &Path) -> Result<(), Box<dyn Error>> {
    match folder.symlink_metadata() {
        Err(cause) if cause.kind() == io::ErrorKind::NotFound => return Ok(()),
        Ok(found) if found.is_symlink() => {
            let shown = name_from_here(folder);
            return Err(misuse(&format!(
                "{shown} is a link\nNothing was changed. Name the folder itself, or a new one."
            )));
        }
        _ => {}
    }
    let marker = folder.join(MARKER);
    let is_file = marker.symlink_metadata().is_ok_and(|found| found.is_file());
    let list = is_file.then(|| limited::read_text(&marker).ok()).flatten();
    let names = list.as_deref().and_then(|list| list.strip_prefix(HEADING));
    let is_marked = names.is_some();
    let names: BTreeSet<&str> = names.unwrap_or_default().lines().collect();
    walk(folder, "", &mut |name, is_plain| {
        let is_ours = names.contains(name) || is_marked && name == MARKER;
        if is_plain && is_ours {
            return Ok(());
        }
        let (shown, stranger) = (name_from_here(folder), escaped_name(name));
        Err(misuse(&format!(
            "{shown} holds {stranger}, which is not of a book that was written there\n\
             Nothing was changed. Move {stranger} elsewhere, or name a new folder, or an empty one."
        )))
    })
}

/// The file that lists the names of all others, each relative to the folder, with `/`.
const MARKER: &str = ".rtrace-book";

/// The first line of the marker.
const HEADING: &str = "The next book takes the place of this whole folder. Its files:\n";

/// Calls `visit` with the name of each file below `folder`, hidden ones included, and of each link
/// and empty folder, in alphabetical order. The names have `/` between folders, and begin with
/// `above`. True stands for a file, false for all else.
fn walk(
    folder: &Path,
    above: &str,
    visit: &mut impl FnMut(&str, bool) -> Result<(), Box<dyn Error>>,
) -> Result<(), Box<dyn Error>> {
    let cannot = |cause| format!("cannot look into {}: {cause}", name_from_here(folder));
    let entries = fs::read_dir(folder).map_err(cannot)?;
    let mut entries: Vec<fs::DirEntry> = entries.collect::<io::Result<_>>().map_err(cannot)?;
    entries.sort_by_key(fs::DirEntry::file_name);
    for entry in &entries {
        let name = format!("{above}{}", entry.file_name().to_string_lossy());
        let (path, kind) = (entry.path(), entry.file_type()?);
        if kind.is_dir() && fs::read_dir(&path).map_err(cannot)?.next().is_some() {
            walk(&path, &format!("{name}/"), visit)?;
        } else {
            visit(&name, kind.is_file())?;
        }
    }
    Ok(())
}
