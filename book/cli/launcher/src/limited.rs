//! Reading with limits: what is read is a file, and short. Its type and its size come before the
//! first byte, and to open it waits for nobody.

use std::fs::OpenOptions;
use std::io::{self, Read};
use std::path::Path;

/// The greatest length, in bytes, that [`read_text`] accepts: 128 KiB. No source, manifest, list or
/// scene of these chapters is longer.
pub const MOST_BYTES: u64 = 1 << 17;

/// Reads a whole file of UTF-8 text that has at most [`MOST_BYTES`] bytes.
///
/// # Errors
/// If `path` leads to something else, such as a folder or a pipe, if the file is longer or is not
/// UTF-8, or if it can't be read.
pub fn read_text(path: &Path) -> io::Result<String> {
    io::read_to_string(&*read_bytes(path, MOST_BYTES)?)
}

/// Reads a whole file that has at most `most` bytes.
///
/// # Errors
/// If `path` leads to something else, such as a folder or a pipe, if the file is longer, or if it
/// can't be read.
pub fn read_bytes(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    let mut options = OpenOptions::new();
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt;
        // A pipe would wait for somebody who writes into it.
        options.custom_flags(rustix::fs::OFlags::NONBLOCK.bits() as i32);
    }
    let file = options.read(true).open(path)?;
    if !file.metadata()?.is_file() {
        return Err(io::Error::other("this is not a file"));
    }
    let mut bytes = Vec::new();
    file.take(most + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most {
        return Err(io::Error::other(format!(
            "the file has more than {most} bytes"
        )));
    }
    Ok(bytes)
}
