//! File notification: waits until something below a folder is saved.
//!
//! What counts is what a file holds once nothing happens any more. A program that draws
//! the same picture again, or an editor that saves twice, changes nothing.

use std::collections::{HashMap, HashSet};
use std::fs::{self, File};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Read;
use std::mem;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant, SystemTime};

use notify::event::{EventKind, ModifyKind};
use notify::{Config, Event, PollWatcher, RecommendedWatcher, RecursiveMode, Watcher};

use crate::done::DONE;

/// The files below a folder, as far as they change.
pub(super) struct Changes {
    folder: PathBuf,
    /// When the folder was made, where the system knows: another one may take its place.
    made: Option<SystemTime>,
    events: Receiver<notify::Result<Event>>,
    /// What something has happened to since it was last looked at.
    touched: HashSet<PathBuf>,
    /// What the files held when they were last looked at.
    held: HashMap<PathBuf, u64>,
    /// Whether all files are the reader's, because nothing else writes there.
    are_all_typed: bool,
    /// Files that have changed while no program ran: the reader's too.
    typed: HashSet<PathBuf>,
    /// In how many runs, one after the other, other files have changed.
    restless: u32,
    /// Ends the notification when it is dropped.
    _watcher: Box<dyn Watcher>,
}

/// How long nothing must happen before a save counts as finished, and after what time it
/// does whatever happens.
const QUIET: Duration = Duration::from_millis(40);
const PATIENCE: Duration = Duration::from_secs(1);

/// How often to see whether the folder is still there.
const LOOK: Duration = Duration::from_millis(500);

/// What changes in every one of so many runs is written by the program.
const OFTEN: u32 = 3;

/// So much of a file is looked at: more than any source has.
const MOST: u64 = 1 << 24;

impl Changes {
    pub(super) fn below(folder: &Path, are_all_typed: bool) -> notify::Result<Self> {
        let (sender, events) = channel();
        // A link may lead to all that there is.
        let config = Config::default().with_follow_symlinks(false);
        let config = config.with_poll_interval(LOOK);
        let mut watcher: Box<dyn Watcher> =
            Box::new(RecommendedWatcher::new(sender.clone(), config)?);
        // Where the system has no more watches to give, looking now and then will do.
        if watcher.watch(folder, RecursiveMode::Recursive).is_err() {
            watcher = Box::new(PollWatcher::new(sender, config)?);
            watcher.watch(folder, RecursiveMode::Recursive)?;
        }
        Ok(Self {
            folder: folder.to_owned(),
            made: made(folder),
            events,
            touched: HashSet::new(),
            held: HashMap::new(),
            are_all_typed,
            typed: HashSet::new(),
            restless: 0,
            _watcher: watcher,
        })
    }

    /// Whether the reader has saved something since the program was started.
    pub(super) fn has_a_save(&mut self) -> bool {
        while let Ok(event) = self.events.try_recv() {
            self.touch(event);
        }
        let is_news = |path: &PathBuf| holds(path).as_ref() != self.held.get(path);
        let is_typed = |path: &&PathBuf| self.are_all_typed || self.typed.contains(*path);
        self.touched.iter().filter(is_typed).any(is_news)
    }

    /// Waits for a save, or returns at once if there was one since the program was
    /// started, which has ended at `end`; `false` if the folder is gone.
    ///
    /// # Errors
    /// If another folder has taken its place and can't be watched.
    pub(super) fn wait(&mut self, end: SystemTime) -> notify::Result<bool> {
        self.settle();
        let (later, during): (HashSet<PathBuf>, HashSet<PathBuf>) =
            self.news().partition(|path| is_from_after(path, end));
        self.restless = if during.is_empty() {
            0
        } else {
            self.restless + 1
        };
        let is_typed = |path: &PathBuf| self.typed.contains(path);
        let mut again = !later.is_empty() || during.iter().any(is_typed);
        again |= (1..OFTEN).contains(&self.restless);
        self.typed.extend(later);
        while !again {
            if !self.folder.is_dir() {
                return Ok(false);
            }
            if made(&self.folder) != self.made {
                *self = Self::below(&self.folder, self.are_all_typed)?;
                return Ok(true);
            }
            match self.events.recv_timeout(LOOK) {
                Ok(event) => {
                    if self.touch(event) {
                        self.settle();
                    }
                    let news: Vec<PathBuf> = self.news().collect();
                    again = !news.is_empty();
                    self.typed.extend(news);
                }
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => return Ok(false),
            }
        }
        Ok(true)
    }

    /// Takes events until nothing happens any more to what is watched.
    fn settle(&mut self) {
        let patience = Instant::now() + PATIENCE;
        let mut quiet = Instant::now() + QUIET;
        while let Ok(event) = self.events.recv_timeout(quiet - Instant::now().min(quiet)) {
            if self.touch(event) {
                quiet = (Instant::now() + QUIET).min(patience);
            }
        }
    }

    /// Notes what something has happened to, and says whether that is watched.
    fn touch(&mut self, event: notify::Result<Event>) -> bool {
        let Ok(Event { kind, paths, .. }) = event else {
            return false;
        };
        if let EventKind::Access(_) | EventKind::Modify(ModifyKind::Metadata(_)) = kind {
            return false;
        }
        let mut watched = false;
        for path in paths {
            if is_watched(&self.folder, &path) {
                self.touched.insert(path);
                watched = true;
            }
        }
        watched
    }

    /// The files that hold something else than when they were last looked at.
    fn news(&mut self) -> impl Iterator<Item = PathBuf> + use<'_> {
        let Self { held, typed, .. } = self;
        mem::take(&mut self.touched)
            .into_iter()
            .filter(move |path| match holds(path) {
                Some(now) => held.insert(path.clone(), now) != Some(now),
                // What a program has removed comes back as it was.
                None => typed.contains(path) && held.remove(path).is_some(),
            })
    }
}

/// Not what is hidden, what is built, and what is written here.
fn is_watched(folder: &Path, path: &Path) -> bool {
    path.strip_prefix(folder)
        .unwrap_or(path)
        .iter()
        .all(|name| {
            let name = name.to_string_lossy();
            !name.starts_with('.') && !["target", "__pycache__", DONE].contains(&&*name)
        })
}

/// What the file holds, as a number; `None` for what is no file, or is gone.
fn holds(path: &Path) -> Option<u64> {
    // To open a pipe would be to wait for somebody at its other end.
    let file = fs::metadata(path).ok().filter(|file| file.is_file())?;
    let mut bytes = Vec::new();
    File::open(path)
        .ok()?
        .take(MOST)
        .read_to_end(&mut bytes)
        .ok()?;
    let mut hasher = DefaultHasher::new();
    (file.len(), bytes).hash(&mut hasher);
    Some(hasher.finish())
}

fn is_from_after(path: &Path, end: SystemTime) -> bool {
    let saved = fs::metadata(path).and_then(|file| file.modified());
    saved.is_ok_and(|saved| saved > end)
}

fn made(folder: &Path) -> Option<SystemTime> {
    fs::metadata(folder)
        .and_then(|folder| folder.created())
        .ok()
}
