//! Budgets: what a text may take before it is stopped, far above what the chapters need.

/// The budget of turns of loops and calls for one pixel: far above what a chapter's pixel takes.
pub(crate) const MAX_TURNS: u32 = 200_000;
/// The budget of turns of loops and calls where the text has a loop over all its pixels.
pub(crate) const MAX_TURNS_OF_A_PICTURE: u32 = 20_000_000;
/// The deepest call of functions that is run, far above what a chapter needs.
pub(crate) const MAX_CALL_DEPTH: u32 = 60;
/// The budget of bytes for one pixel, far above what a chapter's pixel takes.
pub(crate) const MAX_BYTES: usize = 1 << 28;
/// The deepest nesting of a value; in a chapter, a struct in a box in a list is three deep.
pub(crate) const MAX_VALUE_DEPTH: usize = 100;
/// How many parts of a value are visited to measure its nesting; beyond, it counts as too deep.
pub(crate) const MAX_VISITS: usize = 10_000;
/// The largest width and height, in pixels, of a picture that is drawn whole.
pub(crate) const MAX_WIDTH: u32 = 4096;
