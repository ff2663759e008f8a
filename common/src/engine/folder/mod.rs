//! Atomic replacement of folders: a folder is filled under another name, and then
//! takes the place of the old one by renaming, as [`output`](super::output) does
//! with files.
//!
//! ```text
//! book/                             the target, with a manifest of what is in it
//! .book.91f0c2d17a3be645.partial/   the staging folder
//!     lock                          locked for as long as its program runs
//!     new/                          filled first, the manifest last
//!     old/                          the target on its way out
//! ```
//!
//! Both are in one folder, so on one disk, and renaming moves no byte. Only what a
//! manifest lists is ever replaced or removed: a folder that holds anything else is
//! refused. Two programs that fill one folder do not wait for each other; the one
//! that is done last wins. For the moment between two renames there is no target; a
//! program that is killed then leaves the old one in its staging folder, from
//! where the next one puts it back.

mod manifest;
mod staging;

use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::{env, error, fmt, fs};

use staging::Staging;

pub use manifest::is_unlisted;

use super::companion;

/// A folder that is being filled, and will take the place of another.
///
/// Dropped before it is [put in place](Self::put_in_place), it goes, and nothing has
/// changed.
#[derive(Debug)]
pub struct NewFolder {
    kind: &'static str,
    staging: Staging,
}

impl NewFolder {
    /// An empty folder beside `target`, to be filled with a `kind` of thing: only a
    /// folder with the same kind of thing in it is replaced.
    ///
    /// First cleans up after programs that were killed while they filled this target.
    ///
    /// # Errors
    /// If there can be no folder at `target`, or none can be created beside it.
    pub fn beside(target: &Path, kind: &'static str) -> Result<Self, FolderError> {
        let target = resolve(target)?;
        staging::clean_up(&target);
        let staging =
            Staging::beside(&target).map_err(failure("create a folder beside", &target))?;
        if let Ok(found) = fs::metadata(&target) {
            // What is private stays private, also while it is written.
            fs::set_permissions(staging.incoming(), found.permissions())
                .map_err(failure("create a folder beside", &target))?;
        }
        Ok(Self { kind, staging })
    }

    /// Where to write.
    pub fn path(&self) -> PathBuf {
        self.staging.incoming()
    }

    /// Where it will be: absolute, and not a link.
    pub fn target(&self) -> &Path {
        self.staging.target()
    }

    /// Refuses now what would be refused in the end, for those who have a long way
    /// to go until then.
    ///
    /// # Errors
    /// If the target holds anything that is not in its manifest.
    pub fn check(&self) -> Result<(), FolderError> {
        self.refuse_strangers(self.target())
    }

    /// Replaces the target by what was written.
    ///
    /// # Errors
    /// If the target holds anything that is not in its manifest, or can't be renamed.
    /// It is then as it was.
    pub fn put_in_place(self) -> Result<(), FolderError> {
        let (target, new, old) = (
            self.target(),
            self.staging.incoming(),
            self.staging.outgoing(),
        );
        manifest::write(&new, self.kind).map_err(failure("write into", &new))?;
        loop {
            match fs::rename(target, &old) {
                Err(cause) if cause.kind() != ErrorKind::NotFound => {
                    return Err(failure("replace", target)(cause));
                }
                _ => {}
            }
            // Here it is out of everybody's reach, so this is the last word.
            self.refuse_strangers(&old)?;
            match fs::rename(&new, target) {
                Ok(()) => return Ok(()),
                // Another program was quicker: now what it wrote is the old one.
                Err(_) if target.exists() => manifest::remove_listed(&old),
                Err(cause) => return Err(failure("create", target)(cause)),
            }
        }
    }

    /// `folder` is the target, by whatever name.
    fn refuse_strangers(&self, folder: &Path) -> Result<(), FolderError> {
        let target = self.target();
        let strangers =
            manifest::strangers(folder, self.kind).map_err(failure("look into", target))?;
        if strangers.is_empty() {
            return Ok(());
        }
        Err(FolderError::Refused(format!(
            "{} holds what {} did not write there as a {}: {}.\n\
             Nothing was changed. Move that elsewhere, or name a new folder, or an empty one.",
            target.display(),
            companion(),
            self.kind,
            first_few(&strangers)
        )))
    }
}

/// Moves `folder` out of the way, to a name beside it that is free. Returns that
/// name, or `None` if there is no such folder any more.
///
/// # Errors
/// If it can't be renamed.
pub fn set_aside(folder: &Path) -> Result<Option<PathBuf>, FolderError> {
    for n in 1.. {
        let aside = folder.with_added_extension(format!("unlisted-{n}"));
        match fs::symlink_metadata(&aside) {
            Ok(_) => continue,
            Err(_) => match fs::rename(folder, &aside) {
                Ok(()) => return Ok(Some(aside)),
                Err(cause) if cause.kind() == ErrorKind::NotFound => break,
                Err(cause) => return Err(failure("move aside", folder)(cause)),
            },
        }
    }
    Ok(None)
}

/// Why a folder was not replaced, and what helps.
#[derive(Debug)]
pub enum FolderError {
    /// It is not ours to replace, or can't be.
    Refused(String),
    /// The system said no.
    Failed(String),
}

impl fmt::Display for FolderError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Refused(why) | Self::Failed(why) => f.write_str(why),
        }
    }
}

impl error::Error for FolderError {}

/// The folder that `path` means, links followed. The folders above it are created.
fn resolve(path: &Path) -> Result<PathBuf, FolderError> {
    let refused = |why: &str| FolderError::Refused(format!("{} {why}", path.display()));
    // Without the slash that may end it, which would hide a link.
    let plain: PathBuf = path.components().collect();
    let target = match plain.file_name() {
        _ if plain.is_symlink() && !plain.exists() => {
            return Err(refused("is a link to nothing: name a folder."));
        }
        Some(_) if !plain.is_symlink() => std::path::absolute(&plain),
        _ => fs::canonicalize(&plain),
    }
    .map_err(failure("find", path))?;
    let Some(above) = target.parent() else {
        return Err(refused("can't be replaced: name a folder in it."));
    };
    if target.exists() && !target.is_dir() {
        return Err(refused("is a file: name a folder."));
    }
    if is_around_us(&target) {
        return Err(refused(
            "is the current folder, or around it, and would be replaced as a whole.\n\
             Run this from elsewhere, or name a folder in it.",
        ));
    }
    fs::create_dir_all(above).map_err(failure("create", above))?;
    Ok(target)
}

/// Who replaces the folder that a shell is in leaves the shell in one that is gone.
fn is_around_us(target: &Path) -> bool {
    let here = env::current_dir().and_then(fs::canonicalize);
    let there = fs::canonicalize(target);
    here.is_ok_and(|here| there.is_ok_and(|there| here.starts_with(there)))
}

fn first_few(names: &[String]) -> String {
    const FEW: usize = 5;
    let shown = names[..names.len().min(FEW)].join(", ");
    match names.len().saturating_sub(FEW) {
        0 => shown,
        more => format!("{shown} and {more} more"),
    }
}

fn failure(doing: &str, path: &Path) -> impl FnOnce(io::Error) -> FolderError {
    move |cause| {
        let advice = match cause.kind() {
            ErrorKind::StorageFull | ErrorKind::QuotaExceeded => {
                "Free some space, or name a folder on another disk."
            }
            ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => {
                "Name a folder that you may write to, in one that you may write to."
            }
            ErrorKind::ResourceBusy | ErrorKind::CrossesDevices => {
                "A disk begins there, or somebody uses it: name a folder in it."
            }
            _ => "Name another folder.",
        };
        let path = path.display();
        FolderError::Failed(format!("cannot {doing} {path}: {cause}\n{advice}"))
    }
}
