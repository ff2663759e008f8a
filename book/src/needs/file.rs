//! The file of a scene, read with limits.

use std::error::Error;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;
use std::string::FromUtf8Error;

use check::names;
use measure::scene_file;
use speed_vs_accuracy::Scene;

/// The largest file, in bytes: so much is more than the most spheres can take, with
/// all digits.
const MOST_BYTES: u64 = 1 << 24;

/// The scene that the file at `path` describes, under the name of the file.
///
/// # Errors
/// If it can't be read; or its first mistake, with line, column and fix.
pub(super) fn read(path: &Path) -> Result<Scene, Box<dyn Error>> {
    let shown = names::spelled(path);
    let bytes = bytes(path).map_err(|cause| {
        format!(
            "cannot read {shown}: {cause}\nA scene is a TOML file; its form is shown by --help."
        )
    })?;
    let text = String::from_utf8(bytes).map_err(|error| {
        let line = line_of(&error);
        format!(
            "{shown}:{line}: this is no text in UTF-8\nSave it as UTF-8, in an editor for texts."
        )
    })?;
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    scene_file::read(&name, &text).map_err(|mistake| format!("{shown}: {mistake}").into())
}

fn bytes(path: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?
        .take(MOST_BYTES + 1)
        .read_to_end(&mut bytes)?;
    match bytes.len() as u64 > MOST_BYTES {
        true => Err(io::Error::other(format!(
            "it has more than {MOST_BYTES} bytes"
        ))),
        false => Ok(bytes),
    }
}

/// Line and column of the first byte that is none of UTF-8.
fn line_of(error: &FromUtf8Error) -> String {
    let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
    let before = String::from_utf8_lossy(before);
    let line = before.matches('\n').count() + 1;
    let last = before.rsplit('\n').next().unwrap_or_default();
    format!("{line}:{}", last.chars().count() + 1)
}
