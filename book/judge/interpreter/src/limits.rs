//! Budgets: what a text may take before it is stopped, far above what the chapters need.

/// So many turns of loops and calls are no pixel's of a chapter.
pub(crate) const TURNS: u32 = 200_000;
/// A reader's own loop over all pixels takes more.
pub(crate) const TURNS_OF_A_PICTURE: u32 = 20_000_000;
/// So deep is no call in a chapter.
pub(crate) const DEEPEST: u32 = 60;
/// So many bytes are made for no pixel of a chapter.
pub(crate) const MEMORY: usize = 1 << 28;
/// So deep is no value in a chapter: what is in a box, in a struct, in a list is three deep.
pub(crate) const DEEPEST_VALUE: usize = 100;
/// So many parts of a value are looked at to see that.
pub(crate) const VISITS: usize = 10_000;
/// The widest and the highest picture that is drawn whole.
pub(crate) const WIDEST: u32 = 4096;
