//! A bounded read: the file of a scene, of no more bytes than a scene can have.

use std::error::Error;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use check::names;
use measure::scene_file;
use speed_vs_accuracy::Scene;

/// The largest file, in bytes: so much is more than the most spheres can take, with
/// all digits.
const MOST_BYTES: u64 = 1 << 24;

/// The scene that the file at `path` describes, under the name of the file.
///
/// # Errors
/// If it can't be read; or its first mistake, with line and column.
pub(super) fn read(path: &Path) -> Result<Scene, Box<dyn Error>> {
    let shown = names::spelled(path);
    let text = text(path).map_err(|cause| {
        format!("cannot read {shown}: {cause}\nA scene is a TOML file; --help shows an example.")
    })?;
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    scene_file::read(&name, &text).map_err(|mistake| format!("{shown}: {mistake}").into())
}

fn text(path: &Path) -> io::Result<String> {
    let mut text = String::new();
    File::open(path)?
        .take(MOST_BYTES + 1)
        .read_to_string(&mut text)?;
    if text.len() as u64 > MOST_BYTES {
        let problem = format!("it has more than {MOST_BYTES} bytes");
        return Err(io::Error::other(problem));
    }
    Ok(text)
}
