//! Polling: looks a few times a second whether a file below a folder was saved.
//!
//! A file is another one if its length or its time has changed. Files that change while the
//! reader's program runs are taken for its output, unless they are sources, or were edited before.

use std::collections::{HashMap, HashSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, Instant, SystemTime};

use crate::done::DONE;
use crate::sources;

/// The files below a folder, to tell a reader's save from what a program wrote.
pub(super) struct FolderChanges {
    folder: PathBuf,
    /// The files when the last run began, or at the last look since.
    judged: FileStamps,
    /// The files that changed while no program ran: the reader edits them.
    edited: HashSet<PathBuf>,
    last_look: Instant,
}

/// Why a wait has ended.
#[derive(Clone, Copy)]
pub(super) enum Waited {
    /// The reader has saved a file.
    Saved,
    /// What was waited for beside that has ended.
    Ended,
    /// The folder is gone.
    Gone,
}

/// The time and the length of each file.
type FileStamps = HashMap<PathBuf, (Option<SystemTime>, u64)>;

/// The time between two looks at the files.
const LOOK: Duration = Duration::from_millis(100);

/// The greatest number of looks, one after the other, until a save counts as finished.
const PATIENCE: usize = 20;

/// The number of files that are looked at: a folder with more has something else in it.
const MOST_FILES: usize = 10_000;

impl FolderChanges {
    pub(super) fn below(folder: &Path) -> Self {
        Self {
            folder: folder.to_owned(),
            judged: files_in(folder),
            edited: HashSet::new(),
            last_look: Instant::now(),
        }
    }

    /// Returns true if the reader has saved a file since the program was started. Looks at the
    /// files at most ten times a second, and returns false in between.
    pub(super) fn has_a_save(&mut self) -> bool {
        if self.last_look.elapsed() < LOOK {
            return false;
        }
        self.last_look = Instant::now();
        let now = files_in(&self.folder);
        changed(&self.judged, &now).any(|path| self.is_the_readers(path))
    }

    /// Waits until the reader saves a file, or `has_ended` returns true. Returns at once if there
    /// was a save since the program was started.
    pub(super) fn wait_for_save(&mut self, has_ended: &mut dyn FnMut() -> bool) -> Waited {
        let now = files_in(&self.folder);
        let mut is_saved = changed(&self.judged, &now).any(|path| self.is_the_readers(path));
        self.judged = now;
        while !is_saved {
            thread::sleep(LOOK);
            let now = settled(&self.folder);
            if now.is_empty() && !self.folder.is_dir() {
                return Waited::Gone;
            }
            let saved: Vec<PathBuf> = changed(&self.judged, &now).cloned().collect();
            is_saved = !saved.is_empty();
            self.edited.extend(saved);
            self.judged = now;
            if !is_saved && has_ended() {
                return Waited::Ended;
            }
        }
        Waited::Saved
    }

    fn is_the_readers(&self, path: &Path) -> bool {
        sources::is_source(path) || self.edited.contains(path)
    }
}

/// Lists the files that differ, or are only in one of the two.
fn changed<'a>(old: &'a FileStamps, new: &'a FileStamps) -> impl Iterator<Item = &'a PathBuf> {
    let gone = old.keys().filter(|path| !new.contains_key(*path));
    let is_news = |(path, now): &(&PathBuf, &_)| old.get(*path) != Some(*now);
    gone.chain(new.iter().filter(is_news).map(|(path, _)| path))
}

/// Waits until the files do not change any more, and returns them.
fn settled(folder: &Path) -> FileStamps {
    let mut files = files_in(folder);
    for _ in 0..PATIENCE {
        thread::sleep(LOOK / 2);
        let now = files_in(folder);
        if now == files {
            break;
        }
        files = now;
    }
    files
}

/// Lists all files below the folder, but for hidden ones, builds, and the list of done things.
/// Follows no links.
fn files_in(folder: &Path) -> FileStamps {
    let mut files = FileStamps::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop()
        && files.len() < MOST_FILES
    {
        for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
            let name = entry.file_name();
            let name = name.to_string_lossy();
            if name.starts_with('.') || ["target", "__pycache__", DONE].contains(&&*name) {
                continue;
            }
            match entry.metadata() {
                Ok(file) if file.is_dir() => folders.push(entry.path()),
                Ok(file) => {
                    files.insert(entry.path(), (file.modified().ok(), file.len()));
                }
                Err(_) => {}
            }
        }
    }
    files
}
