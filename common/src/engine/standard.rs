//! The standard streams as the shell hands them over: by whatever name, or closed.

use std::path::Path;

#[cfg(unix)]
use {
    super::partial::folder_of,
    std::fs::{self, File, Metadata},
    std::io::{self, Read},
    std::os::fd::AsFd,
    std::os::unix::fs::{FileTypeExt, MetadataExt},
};

/// The number of the open file that `path` is a name of, as `/dev/stdout` is of
/// number 1, and as a link to `/dev/stdout` is.
///
/// To open such a name anew would lose the place up to which others have written.
#[cfg(unix)]
pub(super) fn descriptor(path: &Path) -> Option<u32> {
    let folders = ["/dev/fd", "/proc/self/fd", "/proc/thread-self/fd"]
        .map(|folder| fs::canonicalize(folder).ok());
    let mut path = path.to_owned();
    // As many links as Linux follows.
    for _ in 0..40 {
        let folder = fs::canonicalize(folder_of(&path)).ok()?;
        if folders.contains(&Some(folder.clone())) {
            return path.file_name()?.to_str()?.parse().ok();
        }
        // Of a link that leads nowhere, the next round finds no folder.
        path = folder.join(fs::read_link(&path).ok()?);
    }
    None
}

/// Elsewhere no file is called that.
#[cfg(not(unix))]
pub(super) fn descriptor(_path: &Path) -> Option<u32> {
    None
}

/// Whether the program was started with its standard output closed, by `>&-`.
///
/// Rust then puts the null device in its place before the program begins, and
/// opens it for reading too, which a shell does not do for `> /dev/null`. Some
/// other programs do, which can't be told apart.
#[cfg(unix)]
pub(super) fn output_is_closed() -> bool {
    let can_read_from_null = || -> io::Result<bool> {
        let mut output = File::from(io::stdout().as_fd().try_clone_to_owned()?);
        let device = |about: Metadata| (about.file_type().is_char_device(), about.rdev());
        let null = device(fs::metadata("/dev/null")?);
        Ok(device(output.metadata()?) == null && output.read(&mut [0])? == 0)
    };
    can_read_from_null().unwrap_or(false)
}

/// Elsewhere there is no telling.
#[cfg(not(unix))]
pub(super) fn output_is_closed() -> bool {
    false
}
