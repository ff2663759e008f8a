//! What the script of a page calls: numbers in; UTF-8 text, or pixels, out.
//!
//! The script sets the numbers one by one, calls what changes or draws, and reads them
//! back, since a figure may have confined them. No memory is shared but the bytes of the
//! last answer, which stay where they are until the next call.

use std::cell::RefCell;

use figures::{LIVE_FIGURES, Movable};
use glam::DVec2;
use slips::Slip;

use crate::picture::{self, PICTURES, Painting};

/// No figure has more numbers.
const MOST: usize = 16;

struct State {
    numbers: [f64; MOST],
    answer: Vec<u8>,
    painting: Option<Painting>,
}

thread_local! {
    static STATE: RefCell<State> = const {
        RefCell::new(State { numbers: [0.0; MOST], answer: Vec::new(), painting: None })
    };
}

/// Sets the number in that place.
#[unsafe(no_mangle)]
extern "C" fn set(place: usize, value: f64) {
    STATE.with_borrow_mut(|state| state.numbers[place] = value);
}

/// The number in that place.
#[unsafe(no_mangle)]
extern "C" fn get(place: usize) -> f64 {
    STATE.with_borrow(|state| state.numbers[place])
}

/// Drags a handle of a figure to a place on the sheet.
#[unsafe(no_mangle)]
extern "C" fn drag(figure: usize, handle: usize, x: f64, y: f64) {
    change(figure, |live, numbers| {
        live.drag(handle, numbers, DVec2::new(x, y));
    });
}

/// Does what a button of a figure says.
#[unsafe(no_mangle)]
extern "C" fn act(figure: usize, action: usize) {
    change(figure, |live, numbers| live.act(action, numbers));
}

/// Draws a figure; returns the length of the answer in bytes.
#[unsafe(no_mangle)]
extern "C" fn answer(figure: usize) -> usize {
    change(figure, |live, numbers| live.confine(numbers));
    keep(|state| {
        let live = LIVE_FIGURES[figure];
        live.text(&state.numbers[..live.numbers().len()]).into()
    })
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
    STATE.with_borrow_mut(|state| state.painting = Some(painting));
}

/// Paints a piece of it; returns its length in bytes, which is 0 at the end.
#[unsafe(no_mangle)]
extern "C" fn piece() -> usize {
    keep(|state| {
        state
            .painting
            .as_mut()
            .and_then(Iterator::next)
            .unwrap_or_default()
    })
}

/// What is painted, when so many of its pixels are wrong; returns the length in bytes.
#[unsafe(no_mangle)]
extern "C" fn verdict(picture: usize, slip: usize, width: u32, different: u32) -> usize {
    keep(|_| picture::verdict(&PICTURES[picture], slip_at(slip), width, different).into())
}

/// Where the last answer is.
#[unsafe(no_mangle)]
extern "C" fn place() -> *const u8 {
    STATE.with_borrow(|state| state.answer.as_ptr())
}

fn keep(answer: impl FnOnce(&mut State) -> Vec<u8>) -> usize {
    STATE.with_borrow_mut(|state| {
        state.answer = answer(state);
        state.answer.len()
    })
}

fn slip_at(place: usize) -> Option<&'static Slip> {
    slips::all().nth(place)
}

fn change(figure: usize, change: impl FnOnce(&dyn Movable, &mut [f64])) {
    let live = LIVE_FIGURES[figure];
    STATE.with_borrow_mut(|state| change(live, &mut state.numbers[..live.numbers().len()]));
}
