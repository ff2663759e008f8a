//! Places: where the pages and the sources are that a slip leads to.

use std::env;
use std::path::Path;

use common::engine::output;

use slips::Slip;

/// The workspace that this was built in, if it is there: a program that was installed
/// may outlive it.
pub fn workspace() -> Option<&'static Path> {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2)?;
    workspace.join("Cargo.toml").is_file().then_some(workspace)
}

/// `path` as seen from the folder that the reader is in, if it is below that.
pub fn shown(path: &Path) -> String {
    let here = env::current_dir().ok();
    let below = here.and_then(|here| path.strip_prefix(here).ok());
    output::shown(below.unwrap_or(path))
}

/// The page of the book that tells how it is right, with the heading, as seen from where
/// the reader is; `None` if it was not woven here.
pub fn page(slip: &Slip) -> Option<String> {
    let path = slip.page_in(workspace()?)?;
    Some(shown(&path))
}

/// The file that has the line right, likewise.
pub fn source(slip: &Slip) -> Option<String> {
    let path = slip.source_in(workspace()?)?;
    Some(shown(&path))
}
