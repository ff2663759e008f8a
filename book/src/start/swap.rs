//! Directory swap: a folder is filled in a hidden place, and takes its name in one step.
//!
//! One would use this where the old folder is worth more than the new one. Whenever the
//! program ends, its name leads to the old folder as a whole or to the new one as a whole.

use std::collections::BTreeMap;
use std::fs::{self, DirBuilder, File};
use std::io;
use std::path::{Path, PathBuf};

#[cfg(unix)]
use crate::signals;

/// A place in a reader's folder where one program at a time makes one of its folders.
pub(super) struct Place {
    /// The name that is to be taken.
    folder: PathBuf,
    /// A folder that nobody else may look into.
    hidden: PathBuf,
    /// Whoever comes second waits until this is closed, if the system can tell.
    _turn: Option<File>,
    #[cfg(unix)]
    _until_it_is_in_order: signals::Deferral,
}

impl Place {
    /// Waits for its turn.
    pub(super) fn of(folder: &Path) -> io::Result<Self> {
        let mine = folder.parent().expect("a crate is in a folder");
        fs::create_dir_all(mine)?;
        let turn = File::open(mine).and_then(|mine| mine.lock().map(|()| mine));
        let name = folder.file_name().unwrap_or_default().to_string_lossy();
        let place = Self {
            folder: folder.to_owned(),
            hidden: mine.join(format!(".start-{name}")),
            _turn: turn.ok(),
            #[cfg(unix)]
            _until_it_is_in_order: signals::Deferral::begin(),
        };
        // What is there was left by a program that did not come to its end.
        let _ = fs::remove_dir_all(&place.hidden);
        private().create(&place.hidden)?;
        Ok(place)
    }

    /// Where the new folder is to be filled.
    pub(super) fn new_folder(&self) -> PathBuf {
        self.hidden.join("new")
    }

    /// Gives the new folder its name. What had that before gets the first free one of those
    /// beside it.
    pub(super) fn take(&self) -> io::Result<()> {
        stop_here_if_asked_to()?;
        if self.folder.symlink_metadata().is_err() {
            return fs::rename(self.new_folder(), &self.folder);
        }
        let aside = self.free();
        fs::rename(self.new_folder(), &aside)?;
        if exchange(&aside, &self.folder).is_ok() {
            return Ok(());
        }
        // A system that can't do it in one step has two.
        let old = self.free();
        // Windows refuses where another program has a file of it open.
        let put_back = |cause| fs::rename(&aside, self.new_folder()).and(Err(cause));
        fs::rename(&self.folder, &old).or_else(put_back)?;
        match fs::rename(&aside, &self.folder) {
            Ok(()) => fs::rename(&old, &aside),
            Err(cause) => fs::rename(&old, &self.folder).and(Err(cause)),
        }
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

impl Drop for Place {
    fn drop(&mut self) {
        // The next one does it, where this one can't.
        let _ = fs::remove_dir_all(&self.hidden);
    }
}

/// Makes folders that are for nobody else's eyes.
fn private() -> DirBuilder {
    #[allow(unused_mut, reason = "systems without modes have nothing to set")]
    let mut builder = DirBuilder::new();
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    builder
}

/// Lets nobody into `new` who is kept out of its namesake `old`, if there is one: what is
/// carried from one to the other stays private.
#[cfg(unix)]
pub(super) fn close_like(old: &Path, new: &Path) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt;

    let Ok(old) = fs::metadata(old) else {
        return Ok(());
    };
    let mode = fs::metadata(new)?.permissions().mode();
    // The owner has to be able to go on.
    let closed = mode & (old.permissions().mode() | 0o700) & 0o777;
    fs::set_permissions(new, fs::Permissions::from_mode(closed))
}

#[cfg(not(unix))]
pub(super) fn close_like(_old: &Path, _new: &Path) -> io::Result<()> {
    Ok(())
}

#[cfg(any(target_os = "linux", target_os = "macos"))]
fn exchange(one: &Path, other: &Path) -> io::Result<()> {
    use rustix::fs::{CWD, RenameFlags, renameat_with};

    Ok(renameat_with(CWD, one, CWD, other, RenameFlags::EXCHANGE)?)
}

#[cfg(not(any(target_os = "linux", target_os = "macos")))]
fn exchange(_one: &Path, _other: &Path) -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}

/// A signal that comes later waits until the folder has its name.
fn stop_here_if_asked_to() -> io::Result<()> {
    #[cfg(unix)]
    signals::check()?;
    Ok(())
}
