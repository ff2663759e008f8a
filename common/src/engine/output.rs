//! Atomic replacement of files: a file is written whole, or not at all.
//!
//! What is written goes to a partial file beside the target, which then takes its
//! name in one step.

use std::fmt;
use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process;

/// Writes to standard output.
///
/// A reader that has seen enough and closes the pipe, as `head` does, is no
/// error.
///
/// # Errors
/// Any other failure to write, such as a full disk behind `>`.
pub fn to_stdout(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), OutputError> {
    let mut stdout = BufWriter::new(io::stdout().lock());
    match write(&mut stdout).and_then(|()| stdout.flush()) {
        Err(cause) if cause.kind() != ErrorKind::BrokenPipe => {
            Err(OutputError { place: None, cause })
        }
        _ => Ok(()),
    }
}

/// Writes the file at `path`, which exists afterwards in full or not at all: if
/// anything goes wrong, a file that was there before stays as it was.
///
/// # Errors
/// Any failure to create, write or rename the file.
pub fn to_file(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), OutputError> {
    let written = match fs::metadata(path) {
        _ if path.as_os_str().is_empty() => Err(ErrorKind::InvalidInput.into()),
        Ok(found) if found.is_dir() => Err(ErrorKind::IsADirectory.into()),
        Ok(found) if found.permissions().readonly() => Err(ErrorKind::PermissionDenied.into()),
        // A device or a pipe can't be replaced by a file: write into it.
        Ok(found) if !found.is_file() => OpenOptions::new()
            .write(true)
            .open(path)
            .and_then(|file| write_and_flush(file, write)),
        // Follow a link, so that what it points to is replaced and not the link.
        Ok(found) => fs::canonicalize(path)
            .and_then(|target| replace(&target, Some(found.permissions()), write)),
        Err(cause) if path.is_symlink() => Err(cause),
        Err(_) => replace(path, None, write),
    };
    written.map_err(|cause| OutputError {
        place: Some(path.to_owned()),
        cause,
    })
}

/// Why nothing was written, and what helps.
#[derive(Debug)]
pub struct OutputError {
    /// The file, or `None` for standard output.
    place: Option<PathBuf>,
    cause: io::Error,
}

impl fmt::Display for OutputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.place {
            Some(path) => write!(f, "cannot write {}: {}", path.display(), self.cause)?,
            None => write!(f, "cannot write to standard output: {}", self.cause)?,
        }
        write!(f, "\n{}", self.advice())
    }
}

impl std::error::Error for OutputError {}

impl OutputError {
    fn advice(&self) -> String {
        let Some(path) = &self.place else {
            return match self.cause.kind() {
                ErrorKind::StorageFull | ErrorKind::QuotaExceeded => MAKE_ROOM.to_owned(),
                _ => "Send it somewhere else.".to_owned(),
            };
        };
        match self.cause.kind() {
            ErrorKind::NotFound if path.is_symlink() => {
                "That is a link to nothing: name another file.".to_owned()
            }
            ErrorKind::NotFound | ErrorKind::NotADirectory => format!(
                "Is {} a folder? Create it first, or name another one.",
                folder_of(path).display()
            ),
            ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => {
                "Choose a file and a folder that you may write to.".to_owned()
            }
            ErrorKind::StorageFull | ErrorKind::QuotaExceeded => MAKE_ROOM.to_owned(),
            ErrorKind::IsADirectory => "That is a folder: name a file inside it.".to_owned(),
            _ => "Try another file, or another folder.".to_owned(),
        }
    }
}

const MAKE_ROOM: &str = "Free some space, or write to another disk.";

/// Writes beside `path` under another name, then renames.
fn replace(
    path: &Path,
    permissions: Option<Permissions>,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let partial = path.with_file_name(format!(".{}.partial", process::id()));
    let done = File::create_new(&partial)
        .and_then(|file| write_and_flush(file, write))
        .and_then(|()| permissions.map_or(Ok(()), |same| fs::set_permissions(&partial, same)))
        .and_then(|()| fs::rename(&partial, path));
    if done.is_err() {
        // The first failure is the one to report, whether or not this works.
        let _ = fs::remove_file(&partial);
    }
    done
}

fn write_and_flush(
    file: File,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut out = BufWriter::with_capacity(1 << 16, file);
    write(&mut out)?;
    out.flush()
}

/// The folder that `path` is in; `.` for a bare file name.
fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}
