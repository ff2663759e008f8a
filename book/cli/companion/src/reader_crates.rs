//! Path discovery: finds the folder of a reader's own crates.

use std::env;
use std::ffi::OsStr;
use std::path::{MAIN_SEPARATOR, Path, PathBuf};

use check::names::{self, companion_command};
use check::workspace;
use slips::Chapter;

use crate::limited;

/// The folder of a reader's crates, each of which is named after its chapter.
pub(crate) struct ReaderCrates {
    folder: PathBuf,
    /// The folder as a word of a command line; `None` if the reader has not chosen it.
    chosen: Option<String>,
}

impl ReaderCrates {
    /// Takes the `chosen` folder. Without one, takes the folder of the crate that the reader is in,
    /// or else `mine` in the workspace if the reader is there, or else in the nearest folder above
    /// the current one that has such a crate, or else in the current folder.
    pub(crate) fn find(chosen: Option<&Path>) -> Self {
        let here = env::current_dir().unwrap_or_default();
        let has_one = |folder: &&Path| {
            let mut typed = Chapter::TYPED.iter();
            typed.any(|chapter| folder.join("mine").join(chapter.name()).is_dir())
        };
        let usual = || {
            let home = workspace_around(&here).or_else(|| here.ancestors().find(has_one));
            home.unwrap_or(&here).join("mine")
        };
        let of_crate = crate_around(&here).and_then(|(_, folder)| folder.parent());
        let folder = match (chosen, of_crate) {
            (Some(chosen), _) => here.join(chosen),
            (None, Some(folder)) => folder.to_owned(),
            (None, None) => usual(),
        };
        Self {
            folder,
            chosen: chosen.map(shell_word),
        }
    }

    /// Returns the path of the folder, which may not exist yet.
    pub(crate) fn folder(&self) -> &Path {
        &self.folder
    }

    /// Returns true if this is the folder `mine` of the workspace, and the reader is in the
    /// workspace.
    pub(crate) fn is_of_workspace(&self) -> bool {
        let workspace = env::current_dir().ok();
        let workspace = workspace.and_then(|here| workspace_around(&here));
        workspace.is_some_and(|it| self.folder == it.join("mine"))
    }

    /// Writes the command that makes the crate of `chapter` in this folder.
    pub(crate) fn start_command(&self, chapter: Chapter) -> String {
        self.command("start", chapter, "--into")
    }

    /// Writes the command that judges the crate of `chapter` in this folder at each save.
    pub(crate) fn watch_command(&self, chapter: Chapter) -> String {
        self.command("watch", chapter, "--in")
    }

    fn command(&self, what: &str, chapter: Chapter, option: &str) -> String {
        let command = format!("{} {what} {}", companion_command(), chapter.name());
        match &self.chosen {
            Some(folder) => format!("{command} {option} {folder}"),
            None => command,
        }
    }

    /// Returns the folder of the crate of `chapter`, which may not exist yet.
    pub(crate) fn folder_of(&self, chapter: Chapter) -> PathBuf {
        self.folder.join(chapter.name())
    }
}

/// Returns the chapter of the reader's crate that the current folder is in; `None` if it is in none.
pub(crate) fn chapter_here() -> Option<Chapter> {
    let here = env::current_dir().ok()?;
    crate_around(&here).map(|(chapter, _)| chapter)
}

/// Finds a crate that `start` made, by its manifest: its chapter, and its folder, in which `here`
/// is.
fn crate_around(here: &Path) -> Option<(Chapter, &Path)> {
    here.ancestors().find_map(|folder| {
        let manifest = limited::read_text(&folder.join("Cargo.toml")).ok()?;
        let is_of = |chapter: &Chapter| manifest.contains(&format!("\"my_{}\"", chapter.name()));
        Some((Chapter::TYPED.into_iter().find(is_of)?, folder))
    })
}

/// Returns the workspace if the folder is in it.
fn workspace_around(here: &Path) -> Option<&'static Path> {
    workspace::workspace().filter(|workspace| here.starts_with(workspace))
}

/// Writes a word so that a shell reads it as one: in quotation marks if it has other characters
/// than letters, digits and `-_./=`. Control characters become escapes.
pub(crate) fn shell_word(word: impl AsRef<OsStr>) -> String {
    let word = names::escaped_name(word);
    let is_plain = |c: char| c.is_alphanumeric() || "-_./=".contains(c) || c == MAIN_SEPARATOR;
    if !word.is_empty() && word.chars().all(is_plain) {
        word
    } else if cfg!(windows) {
        format!("\"{word}\"")
    } else {
        // Nothing is expanded between single quotation marks.
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}
