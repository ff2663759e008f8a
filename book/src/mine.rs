//! The reader's own folder: where their crates are, and where ours is.

use std::env;
use std::path::{Path, PathBuf};

use check::Chapter;
use check::places;

/// The folder of a reader's crates, each of which is named after its chapter.
pub(crate) struct Mine(PathBuf);

impl Mine {
    /// The chosen folder; or else `mine`, in this workspace for whoever stands in it,
    /// and in the current folder for everybody else.
    pub(crate) fn find(chosen: Option<&Path>) -> Self {
        let here = env::current_dir().unwrap_or_default();
        let home = places::workspace().filter(|workspace| here.starts_with(workspace));
        let usual = || home.unwrap_or(&here).join("mine");
        Self(chosen.map_or_else(usual, |chosen| here.join(chosen)))
    }

    /// The folder itself, which may not exist yet.
    pub(crate) fn folder(&self) -> &Path {
        &self.0
    }

    /// Where the reader's crate of `chapter` is, or would be.
    pub(crate) fn of(&self, chapter: Chapter) -> PathBuf {
        self.0.join(chapter.name())
    }
}
