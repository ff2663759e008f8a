//! Snapshots: text that a test keeps fresh.

use std::fs;
use std::path::Path;

/// What the snapshot at `path` holds, without the header of the file.
pub(crate) fn text(path: &Path) -> Result<String, String> {
    let text = fs::read_to_string(path).map_err(|cause| format!("{}: {cause}", path.display()))?;
    // insta begins a snapshot with a header between lines of dashes.
    let body = text.splitn(3, "---\n").nth(2);
    Ok(body.unwrap_or(&text).to_owned())
}
