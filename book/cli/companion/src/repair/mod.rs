//! Automated program repair: finds the single edit of a reader's own crate after which it draws the
//! right picture and obeys the laws.
//!
//! All plausible edits are written into one copy of the crate as alternatives (mutant schemata), so
//! that rustc drops in few runs those that don't type-check; then the program is run once for each.
//! So it works for any Rust, and what it finds was tried.

mod copy;
mod own_crate;
mod rank;
mod schema;
mod trial;

use std::collections::HashSet;
use std::ffi::OsString;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::sync::mpsc::{Receiver, TryRecvError};
use std::time::{Duration, Instant};

use check::answer::{Answer, Row, RowKind};
use edits::{Edit, EditedLines};
use slips::{Chapter, SphereCount};

use crate::subprocess::in_a_thread;
use copy::Copy;
use own_crate::OwnCrate;
use schema::Build;
use trial::{Court, Grade};
pub(crate) use trial::{RightPictures, SMALL, numbers};

/// A wrong crate, and what would be right.
pub(crate) struct WrongCrate {
    /// The folder of the crate.
    pub(crate) folder: PathBuf,
    /// Its program, which cargo has built.
    pub(crate) program: OsString,
    /// The chapter that it is about.
    pub(crate) chapter: Chapter,
    /// The pictures that count as right.
    pub(crate) right: RightPictures,
}

/// A search for the edit that makes a crate right, in a thread. Dropping this stops it, with all
/// that it has started.
pub(crate) struct Search {
    stop: Arc<AtomicBool>,
    outcome: Receiver<Outcome>,
}

/// What a search has found.
pub(crate) enum Outcome {
    /// The edits that make the crate right.
    Found(Repairs),
    /// None of so many edits makes the crate right.
    Nothing(usize),
    /// The crate may not be searched, for this reason.
    NotSearched(String),
}

/// Edits after which a crate is right, those of one line as one.
pub(crate) struct Repairs {
    /// Of the first few the reader's line, or that a line is missing, and what should be there.
    lines: Vec<Vec<Row>>,
    /// The number of all.
    count: usize,
    /// What holds with each of them.
    holds: &'static str,
    /// True if laws hold, too, with each of them, or the chapter has none: where a ray meets a
    /// sphere, a wrong repair can draw the right picture.
    is_certain: bool,
}

/// How many repairs are shown.
const SHOWN: usize = 3;
/// The most repairs that tell something: of more, each is only possible.
const TELLING: usize = 5;
/// The greatest ranks of the edits that are tried first and then.
const WAVES: [u32; 2] = [6, u32::MAX];
/// How long the edits of a wave are tried, after which no more are begun.
const PATIENCE: Duration = Duration::from_secs(20);

impl Search {
    /// Starts a search.
    pub(crate) fn start(wrong: WrongCrate) -> Self {
        let stop = Arc::new(AtomicBool::new(false));
        let stopped = Arc::clone(&stop);
        Self {
            stop,
            outcome: in_a_thread(move || wrong.search(&stopped)),
        }
    }

    /// Returns what was found; `None` while the search goes on.
    pub(crate) fn outcome(&self) -> Option<Outcome> {
        match self.outcome.try_recv() {
            Ok(outcome) => Some(outcome),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Outcome::Nothing(0)),
        }
    }

    /// Waits for what is found.
    pub(crate) fn wait(self) -> Outcome {
        self.outcome.recv().unwrap_or(Outcome::Nothing(0))
    }
}

impl Drop for Search {
    fn drop(&mut self) {
        self.stop.store(true, Relaxed);
    }
}

impl Outcome {
    /// Adds what was found to an answer: a repair takes the place of what else may be wrong.
    pub(crate) fn join(self, answer: &mut Answer) {
        match self {
            Self::Found(repairs) => repairs.join(answer),
            // Rounding, as in f32, is no line's fault.
            Self::Nothing(count) if count == 0 || is_rounded(answer) => {}
            Self::Nothing(count) => {
                let none = format!("none of {count} single changes of your text makes it right");
                answer.rows.push(Row::new(RowKind::Besides, none));
            }
            Self::NotSearched(why) => {
                let not = format!("no line is looked for that makes it right: {why}");
                answer.rows.push(Row::new(RowKind::Besides, not));
            }
        }
    }
}

impl Repairs {
    /// Takes the best of the edits that are good.
    fn of(
        good: &[(usize, Grade)],
        own: &OwnCrate,
        edits: &[Edit],
        is_hidden: bool,
        chapter: Chapter,
    ) -> Self {
        let best = good.iter().map(|it| it.1).min();
        let good = good.iter().filter(|it| Some(it.1) == best);
        let mut seen = HashSet::new();
        let is_other = |edit: &&Edit| seen.insert((edit.file, line_of(own, edit).number));
        let all: Vec<&Edit> = good.map(|it| &edits[it.0]).filter(is_other).collect();
        let is_lawful = is_hidden || best == Some(Grade::Lawful) && !own.laws.is_empty();
        let holds = match (is_hidden, is_lawful) {
            (true, _) => "all laws hold",
            (_, true) => "your program draws the picture, and the laws hold",
            _ => "your program draws the picture",
        };
        Self {
            lines: all.iter().take(SHOWN).map(|it| shown(own, it)).collect(),
            count: all.len(),
            holds,
            is_certain: is_lawful || chapter.sphere_count() == SphereCount::None,
        }
    }

    /// Puts the repairs before what else may be wrong. Where a named mistake has the first of them,
    /// its reason is told, too.
    fn join(self, answer: &mut Answer) {
        let place = |row: &Row| row.text.split("  ").next().map(str::to_owned);
        let is_named =
            |it: &Row| it.kind == RowKind::Yours && place(it) == place(&self.lines[0][0]);
        let has_reason = answer.rows.iter().any(|it| it.kind == RowKind::Why);
        if has_reason && answer.rows.iter().any(is_named) {
            let tried = format!("with this change {}", self.holds);
            let last = answer.rows.iter().rposition(|it| is_guess(it.kind));
            let tried = Row::new(RowKind::Tried, tried);
            answer.rows.insert(last.map_or(0, |it| it + 1), tried);
            return;
        }
        let with = match self.count {
            1 => "with this change",
            2..=TELLING => "with any of these changes",
            _ => "with any of these changes, and with others,",
        };
        let tried = Row::new(RowKind::Tried, format!("{with} {}", self.holds));
        let mut rows = Vec::new();
        for (n, mut lines) in self.lines.into_iter().enumerate() {
            if n > 0 {
                lines[0].kind = RowKind::Or;
            } else if self.count > TELLING || !self.is_certain {
                lines[0].kind = RowKind::Perhaps;
            }
            rows.append(&mut lines);
        }
        rows.push(tried);
        answer.rows.retain(|it| !is_guess(it.kind));
        rows.append(&mut answer.rows);
        answer.rows = rows;
    }
}

fn line_of(own: &OwnCrate, edit: &Edit) -> EditedLines {
    edit.lines(&own.files[edit.file].1)
}

/// Shows one repair: the line and what should be in its place, or the line that is missing.
fn shown(own: &OwnCrate, edit: &Edit) -> Vec<Row> {
    let lines = line_of(own, edit);
    let squeezed = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let at = |text: &str| {
        format!(
            "{}:{}  {}",
            own.files[edit.file].0,
            lines.number,
            squeezed(text)
        )
    };
    if edit.at.is_empty() {
        return vec![Row::new(RowKind::Missing, at(&edit.new))];
    }
    let should_be = match &*squeezed(&lines.new) {
        "" => "left out".to_owned(),
        new => new.to_owned(),
    };
    vec![
        Row::new(RowKind::Yours, at(&lines.old)),
        Row::new(RowKind::ShouldBe, should_be),
    ]
}

/// Returns true if the picture is right but for a level here and there.
fn is_rounded(answer: &Answer) -> bool {
    answer.pictures.as_ref().is_some_and(|it| {
        let mut both = it.yours.rgb().iter().zip(it.right.rgb());
        both.all(|(yours, right)| yours.abs_diff(*right) <= 1)
    })
}

/// Returns true for a row about what may be wrong, as far as the picture tells.
fn is_guess(kind: RowKind) -> bool {
    use RowKind::*;
    let is_line = matches!(
        kind,
        Yours | Probably | Perhaps | Or | InRust | ShouldBe | Missing
    );
    is_line || matches!(kind, More | Why | Tried)
}

impl WrongCrate {
    fn search(mut self, stop: &AtomicBool) -> Outcome {
        let own = match OwnCrate::read(&self.folder) {
            Ok(own) => own,
            Err(why) => return Outcome::NotSearched(why),
        };
        let copy = match Copy::make(&own, self.program.as_ref(), stop) {
            Ok(copy) => copy,
            Err(cause) => return Outcome::NotSearched(format!("no copy can be made: {cause}")),
        };
        let texts: Vec<&str> = own.files.iter().map(|it| &*it.1).collect();
        // What is no Rust by itself was built all the same: it is left alone.
        let Ok(mut all) = edits::of_texts(&texts) else {
            return Outcome::Nothing(0);
        };
        rank::rank(&mut all.edits, &texts, &self.chapters());
        if !own.is_sized {
            self.right.small.clear();
        }
        all.edits.retain(|it| !own.is_given(it.file));
        let (mut least, mut tried) = (0, 0);
        for most in WAVES {
            let ranks = least..=most;
            least = most.saturating_add(1);
            let chosen = all.edits.iter().enumerate();
            let chosen = chosen
                .filter(|it| ranks.contains(&it.1.rank))
                .map(|it| it.0);
            let mut build = Build::new(&own, &copy, &all, chosen);
            let Some(built) = build.build(&mut || stop.load(Relaxed)) else {
                continue;
            };
            let mut court = Court::new(&built, &copy.empty, &self.right, stop);
            if court.accepts_as_it_is() {
                break;
            }
            let (good, count) = court.try_all(TELLING + 1, Instant::now() + PATIENCE);
            tried += count;
            if !good.is_empty() {
                let is_hidden = court.is_hidden();
                let repairs = Repairs::of(&good, &own, &all.edits, is_hidden, self.chapter);
                return Outcome::Found(repairs);
            }
        }
        Outcome::Nothing(tried)
    }

    /// Returns the texts of this chapter and those before it.
    fn chapters(&self) -> Vec<String> {
        let before = Chapter::TYPED.into_iter().filter(|it| *it <= self.chapter);
        let files = before.flat_map(slips::typed_files);
        files.map(|it| it.text).collect()
    }
}
