//! Directory replacement: a folder is filled in a hidden place, and takes its name when it is
//! whole.
//!
//! What had that name before is put aside under a number first, and never written to: whenever
//! the program ends, all that the reader typed is there.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::{fs, io};

use tempfile::TempDir;

/// A place in a reader's folder where one of its folders is made.
pub(super) struct Place {
    /// The name that is to be taken.
    folder: PathBuf,
    /// A folder that only its owner may look into.
    hidden: TempDir,
}

impl Place {
    pub(super) fn of(folder: &Path) -> io::Result<Self> {
        let mine = folder.parent().expect("a crate is in a folder");
        fs::create_dir_all(mine)?;
        Ok(Self {
            folder: folder.to_owned(),
            hidden: tempfile::Builder::new()
                .prefix(".start-")
                .tempdir_in(mine)?,
        })
    }

    /// Where the new folder is to be filled.
    pub(super) fn new_folder(&self) -> PathBuf {
        self.hidden.path().join("new")
    }

    /// Gives the new folder its name. What had that before gets the first free one of those
    /// beside it, and has it back if this fails.
    pub(super) fn take(&self) -> io::Result<()> {
        if self.folder.symlink_metadata().is_err() {
            return fs::rename(self.new_folder(), &self.folder);
        }
        let aside = self.free();
        fs::rename(&self.folder, &aside)?;
        fs::rename(self.new_folder(), &self.folder)
            .or_else(|cause| fs::rename(&aside, &self.folder).and(Err(cause)))
    }

    /// All that had the name before, each with its number, the first one first.
    pub(super) fn kept(&self) -> BTreeMap<u32, PathBuf> {
        let numbered = |path: PathBuf| {
            let is_named_so = path.file_stem() == self.folder.file_name();
            let number = path.extension()?.to_str()?.parse().ok()?;
            is_named_so.then_some((number, path))
        };
        let mine = self.folder.parent().map(fs::read_dir);
        let all = mine.into_iter().flatten().flatten().flatten();
        all.filter_map(|entry| numbered(entry.path())).collect()
    }

    fn free(&self) -> PathBuf {
        let last = self.kept().pop_last().map_or(0, |(number, _)| number);
        self.folder.with_extension((last + 1).to_string())
    }
}

/// Keeps out of the crate `new` whom the crate `old`, if there is one, keeps from its chapter:
/// what is carried from one to the other stays private.
#[cfg(unix)]
pub(super) fn close_like(old: &Path, new: &Path) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt;

    let mut mode = fs::metadata(new)?.permissions().mode();
    for part in ["", "src", "src/lib.rs"] {
        if let Ok(old) = fs::metadata(old.join(part)) {
            let readers = (old.permissions().mode() & 0o044) >> 2;
            // A digit of the mode is all or nothing; the owner has to be able to go on.
            mode &= 0o700 | (readers * 7);
        }
    }
    fs::set_permissions(new, fs::Permissions::from_mode(mode))
}

#[cfg(not(unix))]
pub(super) fn close_like(_old: &Path, _new: &Path) -> io::Result<()> {
    Ok(())
}
