//! File notification: waits until something below a folder is saved.
//!
//! What counts is what a file holds. A program that draws the same picture again, or an
//! editor that saves twice, changes nothing.

use std::collections::{HashMap, HashSet};
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::mem;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, SystemTime};

use notify::event::{EventKind, ModifyKind};
use notify::{Config, Event, PollWatcher, RecursiveMode, Watcher};

use crate::done::DONE;

/// The files below a folder, as far as they change.
pub(super) struct Changes {
    folder: PathBuf,
    events: Receiver<notify::Result<Event>>,
    /// What was saved and has not been judged yet.
    fresh: HashSet<PathBuf>,
    /// What the files held when they were last looked at.
    held: HashMap<PathBuf, u64>,
    /// Files that have changed while no program ran: the reader's.
    typed: HashSet<PathBuf>,
    /// In how many runs, one after the other, another file has changed.
    written: HashMap<PathBuf, u32>,
    /// Ends the notification when it is dropped.
    _watcher: Box<dyn Watcher>,
}

/// How long nothing must happen before a save counts as finished.
const QUIET: Duration = Duration::from_millis(40);

/// How often to see whether the folder is still there.
const LOOK: Duration = Duration::from_millis(500);

/// A file that changes in every one of so many runs is written by the program.
const OFTEN: u32 = 3;

impl Changes {
    pub(super) fn below(folder: &Path) -> notify::Result<Self> {
        let (sender, events) = channel();
        let config = Config::default().with_poll_interval(LOOK);
        let mut watcher: Box<dyn Watcher> = Box::new(notify::recommended_watcher(sender.clone())?);
        // Where the system has no more watches to give, looking now and then will do.
        if watcher.watch(folder, RecursiveMode::Recursive).is_err() {
            watcher = Box::new(PollWatcher::new(sender, config)?);
            watcher.watch(folder, RecursiveMode::Recursive)?;
        }
        Ok(Self {
            folder: folder.to_owned(),
            events,
            fresh: HashSet::new(),
            held: HashMap::new(),
            typed: HashSet::new(),
            written: HashMap::new(),
            _watcher: watcher,
        })
    }

    /// Whether the reader has saved something since the program was started.
    pub(super) fn make_it_old(&mut self) -> bool {
        while let Ok(event) = self.events.try_recv() {
            self.take(event);
        }
        self.fresh.iter().any(|path| self.typed.contains(path))
    }

    /// Waits for a save, or returns at once if there was one since the program was
    /// started, which has ended at `end`; `false` if the folder is gone.
    pub(super) fn wait(&mut self, end: SystemTime) -> bool {
        self.settle();
        let (during, later): (HashSet<PathBuf>, HashSet<PathBuf>) = self
            .fresh
            .drain()
            .partition(|path| is_from_before(path, end));
        self.written.retain(|path, _| during.contains(path));
        let mut again = !later.is_empty();
        self.typed.extend(later);
        for path in during {
            let runs = self.written.entry(path.clone()).or_default();
            *runs += 1;
            again |= self.typed.contains(&path) || *runs < OFTEN;
        }
        while !again {
            match self.events.recv_timeout(LOOK) {
                Ok(event) => {
                    self.take(event);
                    self.settle();
                    let fresh = mem::take(&mut self.fresh);
                    again = !fresh.is_empty();
                    self.typed.extend(fresh);
                }
                Err(RecvTimeoutError::Timeout) if self.folder.is_dir() => {}
                Err(_) => return false,
            }
        }
        self.folder.is_dir()
    }

    /// Takes events until nothing happens any more.
    fn settle(&mut self) {
        while let Ok(event) = self.events.recv_timeout(QUIET) {
            self.take(event);
        }
    }

    fn take(&mut self, event: notify::Result<Event>) {
        let Ok(event) = event else { return };
        let is_change = !matches!(
            event.kind,
            EventKind::Access(_) | EventKind::Modify(ModifyKind::Metadata(_))
        );
        for path in event.paths.into_iter().filter(|_| is_change) {
            if self.is_watched(&path) && self.has_changed(&path) {
                self.fresh.insert(path);
            }
        }
    }

    /// Not what is hidden, what is built, and what is written here.
    fn is_watched(&self, path: &Path) -> bool {
        let below = path.strip_prefix(&self.folder).unwrap_or(path);
        below.iter().all(|name| {
            let name = name.to_string_lossy();
            !name.starts_with('.') && !["target", "__pycache__", DONE].contains(&&*name)
        })
    }

    /// Whether the file holds something else than when it was last looked at.
    fn has_changed(&mut self, path: &Path) -> bool {
        let Ok(bytes) = fs::read(path) else {
            // A folder, or a file that is gone.
            return self.held.remove(path).is_some();
        };
        let mut hasher = DefaultHasher::new();
        bytes.hash(&mut hasher);
        let holds = hasher.finish();
        self.held.insert(path.to_owned(), holds) != Some(holds)
    }
}

fn is_from_before(path: &Path, end: SystemTime) -> bool {
    let saved = fs::metadata(path).and_then(|file| file.modified());
    saved.is_ok_and(|saved| saved <= end)
}
