//! What the script calls of a live picture. A chapter and a slip go by their places; where no
//! slip is in a place, the picture is right.

use std::cell::RefCell;

use slips::{Chapter, Slip};

use super::{figures::set, keep};
use crate::picture::{self, Painting};

thread_local! {
    static PAINTING: RefCell<Option<Painting>> = const { RefCell::new(None) };
}

/// Begins a picture. Its width and height become the first two numbers.
#[unsafe(no_mangle)]
extern "C" fn paint(chapter: usize, slip: usize, width: u32) {
    let painting = Painting::new(chapter_at(chapter), slip_at(slip), width);
    let (width, height) = painting.size;
    set(0, width.into());
    set(1, height.into());
    PAINTING.set(Some(painting));
}

/// Paints a piece of it; nothing at the end.
#[unsafe(no_mangle)]
extern "C" fn piece() -> usize {
    let piece = PAINTING.with_borrow_mut(|painting| painting.as_mut()?.pieces.next());
    keep(piece.unwrap_or_default())
}

/// What is painted, when so many of its pixels are wrong.
#[unsafe(no_mangle)]
extern "C" fn verdict(chapter: usize, slip: usize, width: u32, different: u32) -> usize {
    let (chapter, slip) = (chapter_at(chapter), slip_at(slip));
    keep(picture::verdict(chapter, slip, width, different))
}

/// The numbers of a pixel as it should be, and beside them those with the slip.
#[unsafe(no_mangle)]
extern "C" fn inspect(chapter: usize, slip: usize, width: u32, column: u32, row: u32) -> usize {
    let (chapter, slip) = (chapter_at(chapter), slip_at(slip));
    keep(picture::inspect(chapter, slip, width, [column, row]))
}

fn chapter_at(place: usize) -> Chapter {
    Chapter::OF_THE_BOOK[place]
}

fn slip_at(place: usize) -> Option<&'static Slip> {
    slips::all().nth(place)
}
