//! Input: a file, standard input, or what a reader's program prints.

use std::ffi::OsString;
use std::fmt;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;
use std::process::{Command, Stdio};

use check::reading::{Cause, MOST_BYTES};

/// A place to read a picture from.
#[derive(Clone, Copy)]
pub(crate) enum Source<'a> {
    /// A file.
    File(&'a Path),
    /// Standard input.
    Stdin,
    /// What a program prints: its name and arguments.
    Program(&'a [OsString]),
}

impl<'a> Source<'a> {
    /// The file of that name, or standard input for `-`.
    pub(crate) fn of(path: &'a Path) -> Self {
        match path.to_str() {
            Some("-") => Self::Stdin,
            _ => Self::File(path),
        }
    }

    /// All bytes, as long as there are not too many.
    pub(crate) fn read(&self) -> Result<Vec<u8>, Cause> {
        match self {
            Self::File(path) => File::open(path).and_then(limited).map_err(|cause| {
                let problem = format!("it can't be read: {cause}");
                Cause::new("unreadable", problem, "Is this the name of your picture?")
            }),
            Self::Stdin => limited(io::stdin().lock()).map_err(|cause| {
                let problem = format!("standard input can't be read: {cause}");
                Cause::new("unreadable", problem, "Name a file instead.")
            }),
            Self::Program(words) => run(words),
        }
    }
}

impl fmt::Display for Source<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File(path) => write!(f, "{}", path.display()),
            Self::Stdin => write!(f, "standard input"),
            Self::Program(words) => {
                let words: Vec<String> = words
                    .iter()
                    .map(|word| word.display().to_string())
                    .collect();
                write!(f, "what {} prints", words.join(" "))
            }
        }
    }
}

/// Reads to the end, or one byte more than a picture may have, so that the
/// reading of pictures can say so.
fn limited(input: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    input.take(MOST_BYTES as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn run(words: &[OsString]) -> Result<Vec<u8>, Cause> {
    let name = words[0].display();
    let failed = |problem: String, fix: &str| Cause::new("program-failed", problem, fix);
    let not_started = |cause: io::Error| {
        failed(
            format!("{name} does not start: {cause}"),
            "Is it built, and is its path right? In this folder it is ./NAME.",
        )
    };
    let mut child = Command::new(&words[0])
        .args(&words[1..])
        .stdout(Stdio::piped())
        .spawn()
        .map_err(not_started)?;
    let bytes = child.stdout.take().map_or(Ok(Vec::new()), limited);
    // One that still prints will find its pipe closed, and should not be waited for.
    if bytes
        .as_ref()
        .map_or(true, |bytes| bytes.len() > MOST_BYTES)
    {
        let _ = child.kill();
    }
    let status = child.wait().map_err(not_started)?;
    match bytes {
        Ok(bytes) if bytes.len() > MOST_BYTES || status.success() => Ok(bytes),
        Ok(_) => Err(failed(
            format!("{name} ended with {status}"),
            "A program that draws a picture ends with 0. What does it say above?",
        )),
        Err(cause) => Err(failed(
            format!("the output of {name} can't be read: {cause}"),
            "Let it write a file, and check that.",
        )),
    }
}
