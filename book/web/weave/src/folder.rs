//! A folder that is replaced whole: the new one is made beside it, and renamed when it is complete.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::{fs, io};

use launcher::misuse::misuse;
use launcher::names::name_from_here;
use launcher::output;

/// What is done, or why it can't be.
type Done = Result<(), Box<dyn Error>>;

/// Puts a new folder in the place of `folder`, which is missing or empty, or is `ours`: then all in
/// it goes. `make` fills the new one, whose path it gets: an empty folder beside `folder`.
///
/// A program that is interrupted leaves the old folder or the new one, or in the instant between
/// two renames neither; the next call removes what is left beside it.
///
/// # Errors
/// If `folder` is a link or a file, or has something in it and is not ours: then nothing is
/// changed. If `make` fails, or a folder can't be made or renamed.
pub fn replace(folder: &Path, ours: &Path, make: impl FnOnce(&Path) -> Done) -> Done {
    let folder = &whole_path(folder)?;
    let is_ours = fs::canonicalize(ours).is_ok_and(|ours| ours == *folder);
    refuse_strangers(folder, is_ours)?;
    let [new, old] = [output::partial(folder)?, output::partial(folder)?];
    output::forget_partials(folder);
    let made = fs::create_dir(&new).map_err(|cause| unmade(&new, &cause));
    let made = made.and_then(|()| make(&new)).and_then(|()| {
        // Making it may have taken seconds.
        refuse_strangers(folder, is_ours)?;
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
    let above = folder
        .parent()
        .filter(|above| !above.as_os_str().is_empty());
    let above = above.unwrap_or(Path::new("."));
    let found = fs::create_dir_all(above).and_then(|()| fs::canonicalize(above));
    Ok(found.map_err(|cause| unmade(above, &cause))?.join(name))
}

fn unmade(folder: &Path, cause: &io::Error) -> Box<dyn Error> {
    let shown = name_from_here(folder);
    format!("cannot make the folder {shown}: {cause}\nName one where you may write.").into()
}

/// Returns an error if the folder is a link or a file, or has something in it that is not ours.
fn refuse_strangers(folder: &Path, is_ours: bool) -> Done {
    let shown = name_from_here(folder);
    let advice = "Nothing was changed. Name a new folder, or an empty one.";
    match folder.symlink_metadata() {
        Err(cause) if cause.kind() == io::ErrorKind::NotFound => return Ok(()),
        Ok(found) if found.is_symlink() => {
            return Err(misuse(&format!("{shown} is a link\n{advice}")));
        }
        _ => {}
    }
    let cannot = |cause| format!("cannot look into {shown}: {cause}");
    let is_full = fs::read_dir(folder).map_err(cannot)?.next().is_some();
    match is_full && !is_ours {
        true => Err(misuse(&format!("{shown} is not empty\n{advice}"))),
        false => Ok(()),
    }
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
