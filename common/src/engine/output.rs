//! Buffered output: to a file, which is written whole or not at all, or to a stream.
//!
//! A stream is standard output, a pipe or a device. Nothing can be taken back that
//! was written there.

use std::borrow::Cow;
use std::ffi::OsStr;
use std::fmt;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};

use super::partial::{self, Stoppable, folder_of};
use super::standard;

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
/// A name of standard output, such as `/dev/stdout`, means standard output.
///
/// # Errors
/// Any failure to create, write or rename the file.
pub fn to_file(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), OutputError> {
    let descriptor = standard::descriptor(path);
    if descriptor == Some(1) {
        return to_stdout(write);
    }
    let written = match fs::metadata(path) {
        _ if path.as_os_str().is_empty() => Err(ErrorKind::InvalidInput.into()),
        Ok(found) if found.is_dir() => Err(ErrorKind::IsADirectory.into()),
        Ok(found) if found.permissions().readonly() => Err(ErrorKind::PermissionDenied.into()),
        // A device or a pipe can't be replaced by a file: write into it. What the
        // shell has opened is not replaced either: it writes there too.
        Ok(found) if !found.is_file() || descriptor.is_some() => OpenOptions::new()
            .append(true)
            .open(path)
            .and_then(|file| write_and_flush(&file, write)),
        // Follow a link, so that what it points to is replaced and not the link.
        Ok(found) => fs::canonicalize(path).and_then(|target| {
            partial::replace(&target, Some(&found), |file| write_and_flush(file, write))
        }),
        Err(cause) if path.is_symlink() => Err(cause),
        Err(_) => partial::replace(path, None, |file| write_and_flush(file, write)),
    };
    written.map_err(|cause| OutputError {
        place: Some(path.to_owned()),
        cause,
    })
}

/// `text`, which may be the name of a file, with those characters spelled out that
/// a terminal obeys instead of showing them, or that turn the order of the others.
pub fn visible(text: &str) -> Cow<'_, str> {
    let obeyed = |c: char| c.is_control() || TURNS.contains(&c);
    if !text.contains(obeyed) {
        return text.into();
    }
    let spell = |c: char| match obeyed(c) {
        true => c.escape_default().to_string(),
        false => c.to_string(),
    };
    text.chars().map(spell).collect()
}

/// The name of a file, or another word of a command line, as a message shows it.
pub fn shown(name: impl AsRef<OsStr>) -> String {
    visible(&name.as_ref().to_string_lossy()).into_owned()
}

/// The marks of Unicode by which a text runs from right to left, or back.
const TURNS: [char; 9] = [
    '\u{202a}', '\u{202b}', '\u{202c}', '\u{202d}', '\u{202e}', '\u{2066}', '\u{2067}', '\u{2068}',
    '\u{2069}',
];

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
            Some(path) => write!(f, "cannot write {}: {}", shown(path), self.cause)?,
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
                shown(folder_of(path))
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

fn write_and_flush(
    file: &File,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut out = BufWriter::with_capacity(1 << 16, Stoppable(file));
    write(&mut out)?;
    out.flush()
}
