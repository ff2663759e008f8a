//! Open files as the shell hands them over, by whatever name.

use std::path::Path;

#[cfg(unix)]
use {super::partial::folder_of, std::fs};

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
