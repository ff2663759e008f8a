//! Places: where the pages and the sources are that a slip leads to.

use std::env;
use std::path::{Path, PathBuf};

use common::engine::output;

use crate::slips::Slip;

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

impl Slip {
    /// The page of the book that tells how it is right, with the heading, if the book was
    /// woven in that workspace.
    pub fn page_in(&self, workspace: &Path) -> Option<PathBuf> {
        let path = workspace.join(self.read());
        let (file, _) = path.to_str()?.rsplit_once('#')?;
        Path::new(file).is_file().then_some(path)
    }

    /// The file that has the line right, if it is in that workspace.
    pub fn source_in(&self, workspace: &Path) -> Option<PathBuf> {
        Some(workspace.join(self.source)).filter(|file| file.is_file())
    }

    /// The page and its heading in words, for whoever can't open it.
    pub fn page_in_words(&self) -> String {
        let (page, heading) = self.page.split_once('#').unwrap_or((self.page, ""));
        format!(
            "\"{}\", on the page {page} of the book",
            heading.replace('-', " ")
        )
    }
}
