//! Input: a picture from a file, from standard input, or from a reader's program.

use std::ffi::OsString;
use std::fmt;
use std::fs::File;
use std::io;
use std::path::Path;
use std::time::Duration;

use check::names;
use check::reading::Cause;

use crate::subprocess;

/// The place that a picture is read from.
#[derive(Clone, Copy)]
pub(crate) enum PictureInput<'a> {
    /// A file at this path.
    File(&'a Path),
    /// Standard input, to its end.
    Stdin,
    /// The standard output of a program: its name, followed by its arguments; never empty.
    Program(&'a [OsString]),
}

impl<'a> PictureInput<'a> {
    /// Returns standard input for the path `-`, and else the file at `path`.
    pub(crate) fn of(path: &'a Path) -> Self {
        match path.to_str() {
            Some("-") => Self::Stdin,
            _ => Self::File(path),
        }
    }

    /// Reads all bytes, up to one more than a picture may have. A program is ended after `limit`.
    pub(crate) fn read(&self, limit: Duration) -> Result<Vec<u8>, Cause> {
        match self {
            Self::File(path) => File::open(path)
                .and_then(subprocess::read_picture_bytes)
                .map_err(|cause| {
                    let problem = format!("the file can't be read: {cause}");
                    Cause::new("unreadable", problem, "Is this the name of your picture?")
                }),
            Self::Stdin => subprocess::read_picture_bytes(io::stdin().lock()).map_err(|cause| {
                let problem = format!("standard input can't be read: {cause}");
                Cause::new("unreadable", problem, "Name a file instead.")
            }),
            Self::Program(words) => subprocess::output_of(words, limit),
        }
    }
}

impl fmt::Display for PictureInput<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File(path) => write!(f, "{}", names::escaped_name(path)),
            Self::Stdin => write!(f, "standard input"),
            Self::Program(words) => {
                let words: Vec<String> = words.iter().map(names::escaped_name).collect();
                write!(f, "what {} prints", words.join(" "))
            }
        }
    }
}
