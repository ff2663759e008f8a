//! What the script calls of a live picture.

use std::cell::RefCell;

use slips::Slip;

use super::{keep, set};
use crate::picture::{self, PICTURES, Painting};

thread_local! {
    static PAINTING: RefCell<Option<Painting>> = const { RefCell::new(None) };
}

/// Begins the picture in that place: with the slip in its place, or right if there is none
/// in it. Its width and height become the first two numbers.
#[unsafe(no_mangle)]
extern "C" fn paint(picture: usize, slip: usize, width: u32) {
    let live = &PICTURES[picture];
    let painting = match slip_at(slip) {
        Some(slip) => Painting::slipped(slip, live.chapter, width),
        None => Painting::right((live.picture)(width)),
    };
    let (width, height) = painting.size();
    set(0, width.into());
    set(1, height.into());
    PAINTING.set(Some(painting));
}

/// Paints a piece of it; returns its length in bytes, which is 0 at the end.
#[unsafe(no_mangle)]
extern "C" fn piece() -> usize {
    let piece = PAINTING.with_borrow_mut(|painting| painting.as_mut().and_then(Iterator::next));
    keep(piece.unwrap_or_default())
}

/// What is painted, when so many of its pixels are wrong; returns the length in bytes.
#[unsafe(no_mangle)]
extern "C" fn verdict(picture: usize, slip: usize, width: u32, different: u32) -> usize {
    keep(picture::verdict(&PICTURES[picture], slip_at(slip), width, different).into())
}

/// The numbers of a pixel of the picture in that width, and beside them those with the slip;
/// returns the length in bytes.
#[unsafe(no_mangle)]
extern "C" fn inspect(picture: usize, slip: usize, width: u32, column: u32, row: u32) -> usize {
    keep(picture::inspect(&PICTURES[picture], slip_at(slip), width, [column, row]).into())
}

fn slip_at(place: usize) -> Option<&'static Slip> {
    slips::all().nth(place)
}
