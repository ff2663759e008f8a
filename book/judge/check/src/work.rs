//! A budget of work, counted and not timed, so that each machine gives the same answer.
//!
//! The unit is the time that an interpreted pixel of the build test takes, half a microsecond in the
//! dev build of a usual computer.

use std::cell::Cell;

use slips::Chapter;

/// The work of one answer: 0.8 s in the dev build.
const ALL: u64 = 1_500_000;
/// The fewest pixels of a large picture that are compared to say that a program draws it.
pub(crate) const FEWEST: u64 = 8000;
/// The price of a text that is read anew: a function with a mistake.
pub(crate) const TEXT: u64 = 700;
/// The price of a byte of a function that is read with all of its edits.
pub(crate) const BYTE: u64 = 3;
/// The price of a mutant that takes the place of another.
pub(crate) const MUTANT: u64 = 8;
/// The price of a program that begins to draw.
pub(crate) const START: u64 = 120;

/// The work that is left for an answer.
#[derive(Debug)]
pub(crate) struct Work(Cell<u64>);

impl Work {
    /// Returns the whole budget of an answer.
    pub(crate) fn new() -> Self {
        Self(Cell::new(ALL))
    }

    /// Takes work of a price; false if less is left, and then none is left at all.
    pub(crate) fn take(&self, price: u64) -> bool {
        let left = self.0.get().checked_sub(price);
        self.0.set(left.unwrap_or_default());
        left.is_some()
    }

    /// Returns how much is left.
    pub(crate) fn left(&self) -> u64 {
        self.0.get()
    }

    /// Splits a part off for a search of its own, as a fraction of what is left.
    pub(crate) fn part(&self, parts: u64) -> Self {
        self.set_aside(self.left() / parts)
    }

    /// Sets work aside, at most all that is left.
    pub(crate) fn set_aside(&self, work: u64) -> Self {
        let part = work.min(self.left());
        self.0.set(self.left() - part);
        Self(Cell::new(part))
    }

    /// Adds what a search of its own has left.
    pub(crate) fn add(&self, left: &Self) {
        self.0.set(self.left() + left.left());
    }
}

/// Returns the price of a pixel of a chapter.
pub(crate) fn pixel(chapter: Chapter) -> u64 {
    match chapter {
        Chapter::BuildTest => 1,
        Chapter::Gradient => 3,
        Chapter::HittableList => 11,
        _ => 4,
    }
}
