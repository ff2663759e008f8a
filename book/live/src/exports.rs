//! What the script of a page calls: numbers in; UTF-8 text, or pixels, out.
//!
//! The script sets the numbers one by one, calls what changes or draws, and reads them
//! back, since a figure may have confined them. No memory is shared but the bytes of the
//! last answer, which stay where they are until the next call.

#[cfg(not(feature = "accuracy"))]
mod pictures;

use std::cell::RefCell;

use figures::Movable;
use glam::DVec2;

/// The figures of this module.
static FIGURES: &[&dyn Movable] = match cfg!(feature = "accuracy") {
    true => figures::ACCURACY,
    false => figures::LESSON,
};

/// No figure has more numbers.
const MOST: usize = 16;

struct State {
    numbers: [f64; MOST],
    answer: Vec<u8>,
}

thread_local! {
    static STATE: RefCell<State> = const {
        RefCell::new(State { numbers: [0.0; MOST], answer: Vec::new() })
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
    let live = FIGURES[figure];
    let text = STATE.with_borrow(|state| live.text(&state.numbers[..live.numbers().len()]));
    keep(text.into())
}

/// Where the last answer is.
#[unsafe(no_mangle)]
extern "C" fn place() -> *const u8 {
    STATE.with_borrow(|state| state.answer.as_ptr())
}

fn keep(answer: Vec<u8>) -> usize {
    STATE.with_borrow_mut(|state| {
        state.answer = answer;
        state.answer.len()
    })
}

fn change(figure: usize, change: impl FnOnce(&dyn Movable, &mut [f64])) {
    let live = FIGURES[figure];
    STATE.with_borrow_mut(|state| change(live, &mut state.numbers[..live.numbers().len()]));
}
