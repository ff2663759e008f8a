//! Staging folders with advisory locks: whose lock nobody holds was abandoned.
//!
//! The system drops the locks of a program that ends, however it ends, so nobody
//! need guess from a process id or an age whether a folder is still in use.

use std::ffi::OsString;
use std::fs::{self, File};
use std::hash::{BuildHasher, Hasher, RandomState};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// A folder beside `target`, in which a new one is made and the old one ends.
#[derive(Debug)]
pub(super) struct Staging {
    target: PathBuf,
    folder: PathBuf,
    /// Held until all is done.
    _lock: File,
}

impl Staging {
    /// Creates one, with an empty folder [`incoming`](Self::incoming) in it.
    pub(super) fn beside(target: &Path) -> io::Result<Self> {
        loop {
            let name = RandomState::new().build_hasher().finish();
            let folder = target.with_file_name(name_of(target, &format!("{name:016x}")));
            fs::create_dir(&folder)?;
            let lock = match File::create_new(folder.join(LOCK)) {
                // As long as nobody holds its lock, another program may take it for
                // abandoned, and remove it.
                Err(cause) if cause.kind() == ErrorKind::NotFound => continue,
                lock => lock?,
            };
            // Where nothing can be locked, nothing is taken for abandoned either.
            let _ = lock.lock();
            if folder.join(LOCK).exists() {
                let staging = Self {
                    target: target.to_owned(),
                    folder,
                    _lock: lock,
                };
                fs::create_dir(staging.incoming())?;
                return Ok(staging);
            }
        }
    }

    /// The folder at `folder`, if its program has ended.
    fn abandoned(target: &Path, folder: PathBuf) -> Option<Self> {
        let lock = File::options()
            .read(true)
            .write(true)
            .open(folder.join(LOCK));
        let Ok(lock) = lock else {
            // Killed before it could create the lock, so it is empty. Any other folder
            // can't be removed like this.
            let _ = fs::remove_dir(folder);
            return None;
        };
        lock.try_lock().ok()?;
        Some(Self {
            target: target.to_owned(),
            folder,
            _lock: lock,
        })
    }

    pub(super) fn target(&self) -> &Path {
        &self.target
    }

    /// What will take the place of the target.
    pub(super) fn incoming(&self) -> PathBuf {
        self.folder.join("new")
    }

    /// Where the target goes then.
    pub(super) fn outgoing(&self) -> PathBuf {
        self.folder.join("old")
    }
}

/// Puts the target back if nothing came in its place, and removes the rest.
impl Drop for Staging {
    fn drop(&mut self) {
        // Whatever fails here is tried again by the next program.
        if !self.target.exists() {
            let _ = fs::rename(self.outgoing(), &self.target);
        }
        let _ = fs::remove_dir_all(self.incoming());
        super::manifest::remove_listed(&self.outgoing());
        if !self.outgoing().exists() {
            let _ = fs::remove_file(self.folder.join(LOCK));
        }
        let _ = fs::remove_dir(&self.folder);
    }
}

/// Finishes what programs left undone that were killed while they replaced `target`.
pub(super) fn clean_up(target: &Path) {
    let Some(Ok(beside)) = target.parent().map(fs::read_dir) else {
        return;
    };
    for entry in beside.flatten() {
        let is_folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
        if is_folder && is_name_of_staging(&entry.file_name(), target) {
            drop(Staging::abandoned(target, entry.path()));
        }
    }
}

/// The file whose lock says that the folder is in use.
const LOCK: &str = "lock";

fn name_of(target: &Path, random: &str) -> OsString {
    let mut name = OsString::from(".");
    name.push(target.file_name().unwrap_or_default());
    name.push(format!(".{random}.partial"));
    name
}

fn is_name_of_staging(name: &OsString, target: &Path) -> bool {
    let text = name.to_string_lossy();
    let random = text
        .strip_suffix(".partial")
        .and_then(|rest| rest.rsplit('.').next())
        .unwrap_or_default();
    let is_random = random.len() == 16 && random.bytes().all(|byte| byte.is_ascii_hexdigit());
    is_random && *name == name_of(target, random)
}
