//! A wrong picture that can be seen: three panels in one file, beside a snapshot that a test
//! compares.

use std::path::Path;
use std::{env, fs, io, thread};

use common::rtweekend::Picture;

use crate::{Comparison, differing_pixels, panels, png};

/// The folder of the snapshots in the workspace: the book shows what is compared.
pub const FOLDER: &str = "book/notes/pictures";

/// Compares a picture with its snapshot in the workspace `root`, the file `NAME.snap.png` in
/// [`FOLDER`]. If they differ, leaves the [`panels`] beside it, and returns what differs, with the
/// commands that show the panels and that accept the picture as the test in this thread compares
/// it. Else removes earlier panels, and returns `None`; also if there is no snapshot.
///
/// # Errors
/// If the panels can't be written.
pub fn leave_panels(root: &Path, name: &str, drawn: &Picture) -> io::Result<Option<String>> {
    let snapshot = fs::read(root.join(format!("{FOLDER}/{name}.snap.png")));
    let right = snapshot.ok().and_then(|bytes| png::decode(&bytes));
    // Insta removes what begins with `NAME.snap.new.`; git ignores `*.snap.new.*`.
    let file = format!("{FOLDER}/{name}.panels.snap.new.png");
    let Some((right, difference)) =
        right.and_then(|right| describe(&right, drawn).map(|difference| (right, difference)))
    else {
        let _ = fs::remove_file(root.join(file));
        return Ok(None);
    };
    fs::write(root.join(&file), png::encode(&panels(&right, drawn)))?;
    let thread = thread::current();
    let test = thread.name().unwrap_or_default();
    // Cargo sets this for the tests that it runs.
    let package = env::var("CARGO_PKG_NAME").map_or(String::new(), |name| format!("-p {name} "));
    Ok(Some(format!(
        "The picture of `{name}` is another one: {difference}.\n\
         look:     {OPEN} {file}\n\
         accept:   INSTA_UPDATE=always cargo test {package}{test}\n"
    )))
}

/// The command that shows a file.
const OPEN: &str = if cfg!(windows) {
    "start"
} else if cfg!(target_os = "macos") {
    "open"
} else {
    "xdg-open"
};

/// Describes how a picture differs from the right one; `None` if it does not.
fn describe(right: &Picture, drawn: &Picture) -> Option<String> {
    let count = match Comparison::of(right, drawn) {
        Comparison::Equal => return None,
        Comparison::AnotherSize => return Some("it has another size".to_owned()),
        Comparison::Pixels(difference) => difference.count,
    };
    let first = differing_pixels(right, drawn).next()?;
    Some(format!(
        "{count} pixels differ; the first, in column {} and row {}, should be {:?} and is {:?}",
        first.column, first.row, first.expected, first.actual
    ))
}
