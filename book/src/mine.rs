//! The reader's own folder: where their crates are.

use std::env;
use std::path::{Path, PathBuf};

use check::names;
use check::workspace;
use slips::Chapter;

/// The chapters that are typed in a crate of one's own; the one before them is the setup.
pub(crate) const TYPED: [Chapter; 5] = [
    Chapter::Gradient,
    Chapter::RedSphere,
    Chapter::Normals,
    Chapter::HalfBSphere,
    Chapter::HittableList,
];

/// The folder of a reader's crates, each of which is named after its chapter.
pub(crate) struct Mine {
    folder: PathBuf,
    /// The words that choose it on a command line, if it was chosen.
    option: String,
}

impl Mine {
    /// The chosen folder. Or else `mine`: in this workspace for whoever stands in it, and
    /// for everybody else in the nearest folder above that has one with a crate, or here.
    pub(crate) fn find(chosen: Option<&Path>) -> Self {
        let here = env::current_dir().unwrap_or_default();
        let workspace = workspace::workspace().filter(|workspace| here.starts_with(workspace));
        let has_one = |folder: &&Path| {
            TYPED
                .iter()
                .any(|it| folder.join("mine").join(it.name()).is_dir())
        };
        let usual = || {
            let home = workspace.or_else(|| here.ancestors().find(has_one));
            home.unwrap_or(&here).join("mine")
        };
        Self {
            folder: chosen.map_or_else(usual, |chosen| here.join(chosen)),
            option: chosen.map_or(String::new(), |chosen| {
                format!(" --in {:?}", names::spelled(chosen))
            }),
        }
    }

    /// The folder itself, which may not exist yet.
    pub(crate) fn folder(&self) -> &Path {
        &self.folder
    }

    /// What a command is to be told that is about this folder.
    pub(crate) fn option(&self) -> &str {
        &self.option
    }

    /// Where the reader's crate of `chapter` is, or would be.
    pub(crate) fn of(&self, chapter: Chapter) -> PathBuf {
        self.folder.join(chapter.name())
    }
}
