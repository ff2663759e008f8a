//! Atomic replacement of a file: a partial file beside it takes its name in one step.
//!
//! The name of a partial file is random, so that programs which know nothing of
//! each other never share one. An advisory lock on it says that it is still being
//! written. The system takes the lock from a program that was killed, which
//! tells what was left behind from what is in use.

use std::fs::{self, File, Metadata, OpenOptions, TryLockError};
use std::hash::{BuildHasher, Hasher, RandomState};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

#[cfg(unix)]
use super::signals;

/// Writes the file at `target`, which is there afterwards in full, or is as it
/// was. A file that is replaced, `old`, hands on its permissions.
///
/// First removes what programs that were killed have left of the same file.
///
/// # Errors
/// Any failure to create, write or rename the file.
pub(super) fn replace(
    target: &Path,
    old: Option<&Metadata>,
    write: impl FnOnce(&File) -> io::Result<()>,
) -> io::Result<()> {
    #[cfg(unix)]
    let _until_it_is_tidy = signals::Deferral::new();
    remove_abandoned(target);
    let (path, file) = create_beside(target, old.is_some())?;
    let done = write(&file)
        .and_then(|()| old.map_or(Ok(()), |old| make_alike(&file, old)))
        .and_then(|()| stop_here_if_asked_to())
        .and_then(|()| fs::rename(&path, target));
    if done.is_err() {
        // The first failure is the one to report, whether or not this works.
        let _ = fs::remove_file(&path);
    }
    done
}

/// Hands on what is written, until a signal asks the program to end.
pub(super) struct Stoppable<W>(pub(super) W);

impl<W: Write> Write for Stoppable<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        stop_here_if_asked_to()?;
        self.0.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

fn stop_here_if_asked_to() -> io::Result<()> {
    #[cfg(unix)]
    signals::check()?;
    Ok(())
}

/// The folder that `path` is in; `.` for a bare file name.
pub(super) fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// A new partial file of `target`, locked. A `private` one is for nobody else's
/// eyes, not even for a moment.
fn create_beside(target: &Path, private: bool) -> io::Result<(PathBuf, File)> {
    loop {
        let path = target.with_file_name(Name::of(target).with(random()));
        let file = match new_file(private).open(&path) {
            Err(cause) if cause.kind() == ErrorKind::AlreadyExists => continue,
            file => file?,
        };
        match file.try_lock() {
            // Before it was locked, someone took it for abandoned.
            Err(TryLockError::WouldBlock) => {}
            Ok(()) if !path.exists() => {}
            // Where there are no locks, nobody can take it for abandoned.
            Ok(()) | Err(TryLockError::Error(_)) => return Ok((path, file)),
        }
        let _ = fs::remove_file(&path);
    }
}

#[cfg_attr(not(unix), expect(unused_variables, reason = "there are no modes"))]
fn new_file(private: bool) -> OpenOptions {
    let mut options = OpenOptions::new();
    options.write(true).create_new(true);
    #[cfg(unix)]
    if private {
        std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    }
    options
}

/// Removes the partial files of `target` that nobody holds a lock on.
fn remove_abandoned(target: &Path) {
    let Ok(entries) = fs::read_dir(folder_of(target)) else {
        return;
    };
    let name = Name::of(target);
    for entry in entries.flatten() {
        let is_file = entry.file_type().is_ok_and(|kind| kind.is_file());
        if is_file && entry.file_name().to_str().is_some_and(|it| name.is_of(it)) {
            let path = entry.path();
            let opened = OpenOptions::new().write(true).open(&path);
            if opened.is_ok_and(|file| file.try_lock().is_ok()) {
                let _ = fs::remove_file(path);
            }
        }
    }
}

/// What the names of all partial files of one file begin with.
struct Name(String);

/// What they end with.
const SUFFIX: &str = ".partial";

impl Name {
    fn of(target: &Path) -> Self {
        let name = target.file_name().unwrap_or_default().to_string_lossy();
        // A name that is as long as a name may be has no room for more.
        let end = name.floor_char_boundary(100);
        Self(format!(".{}.", &name[..end]))
    }

    fn with(&self, number: u64) -> String {
        format!("{}{number:016x}{SUFFIX}", self.0)
    }

    fn is_of(&self, file_name: &str) -> bool {
        file_name
            .strip_prefix(&self.0)
            .and_then(|rest| rest.strip_suffix(SUFFIX))
            .and_then(|digits| u64::from_str_radix(digits, 16).ok())
            .is_some_and(|number| file_name == self.with(number))
    }
}

/// A number that no other program gets: the standard library asks the system for
/// it, to make its hash tables unpredictable.
fn random() -> u64 {
    RandomState::new().build_hasher().finish()
}

/// Gives `file` the permissions of `old`, and its owner and group where possible.
#[cfg(unix)]
fn make_alike(file: &File, old: &Metadata) -> io::Result<()> {
    use std::os::unix::fs::{MetadataExt, PermissionsExt, fchown};
    // Only the superuser gives files away, and only members give to a group.
    let _ = fchown(file, None, Some(old.gid()));
    let _ = fchown(file, Some(old.uid()), None);
    let mut permissions = old.permissions();
    if file.metadata()?.gid() != old.gid() {
        // What one group may do, another one may not.
        permissions.set_mode(permissions.mode() & !0o070);
    }
    file.set_permissions(permissions)
}

/// Gives `file` the permissions of `old`.
#[cfg(not(unix))]
fn make_alike(file: &File, old: &Metadata) -> io::Result<()> {
    file.set_permissions(old.permissions())
}
