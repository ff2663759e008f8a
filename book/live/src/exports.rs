//! What the script of a page calls: numbers in, UTF-8 text out.
//!
//! The script sets the numbers one by one, calls what changes or draws, and reads them
//! back, since a figure may have confined them. No memory is shared but the text of the
//! last answer, which stays where it is until the next call.

use std::cell::RefCell;

use glam::DVec2;

use crate::{FIGURES, Live};

/// No figure has more numbers.
const MOST: usize = 16;

struct State {
    numbers: [f64; MOST],
    text: String,
}

thread_local! {
    static STATE: RefCell<State> = const {
        RefCell::new(State { numbers: [0.0; MOST], text: String::new() })
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
        live.drag(&live.handles[handle], numbers, DVec2::new(x, y));
    });
}

/// Does what a button of a figure says.
#[unsafe(no_mangle)]
extern "C" fn act(figure: usize, action: usize) {
    change(figure, |live, numbers| (live.actions[action].act)(numbers));
}

/// Draws a figure; returns the length of the answer in bytes.
#[unsafe(no_mangle)]
extern "C" fn answer(figure: usize) -> usize {
    change(figure, Live::confine);
    STATE.with_borrow_mut(|state| {
        let live = &FIGURES[figure];
        state.text = live.text(&state.numbers[..live.numbers.len()]);
        state.text.len()
    })
}

/// Where the last answer is.
#[unsafe(no_mangle)]
extern "C" fn text() -> *const u8 {
    STATE.with_borrow(|state| state.text.as_ptr())
}

fn change(figure: usize, change: impl FnOnce(&Live, &mut [f64])) {
    let live = &FIGURES[figure];
    STATE.with_borrow_mut(|state| change(live, &mut state.numbers[..live.numbers.len()]));
}
