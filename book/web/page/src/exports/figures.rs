//! What the script calls of a live figure.
//!
//! It sets the numbers one by one, calls what changes or draws, and reads them back, since a
//! figure may have confined them.

use std::cell::RefCell;

use figures::{ACCURACY, LESSON, Movable};
use glam::DVec2;

use super::keep;

/// The figures of this module.
static FIGURES: &[&dyn Movable] = if cfg!(feature = "accuracy") {
    ACCURACY
} else {
    LESSON
};

/// No figure has more numbers.
const MOST: usize = 16;

thread_local! {
    static NUMBERS: RefCell<[f64; MOST]> = const { RefCell::new([0.0; MOST]) };
}

/// Sets the number in that place.
#[unsafe(no_mangle)]
extern "C" fn set(place: usize, value: f64) {
    NUMBERS.with_borrow_mut(|numbers| numbers[place] = value);
}

/// The number in that place.
#[unsafe(no_mangle)]
extern "C" fn get(place: usize) -> f64 {
    NUMBERS.with_borrow(|numbers| numbers[place])
}

/// Drags a handle of a figure to a place on the sheet.
#[unsafe(no_mangle)]
extern "C" fn drag(figure: usize, handle: usize, x: f64, y: f64) {
    with(figure, |live, numbers| {
        live.drag(handle, numbers, DVec2::new(x, y));
    });
}

/// Does what a button of a figure says.
#[unsafe(no_mangle)]
extern "C" fn act(figure: usize, action: usize) {
    with(figure, |live, numbers| live.act(action, numbers));
}

/// Draws a figure.
#[unsafe(no_mangle)]
extern "C" fn answer(figure: usize) -> usize {
    with(figure, |live, numbers| {
        live.confine(numbers);
        keep(live.text(numbers))
    })
}

fn with<T>(figure: usize, act: impl FnOnce(&dyn Movable, &mut [f64]) -> T) -> T {
    let live = FIGURES[figure];
    NUMBERS.with_borrow_mut(|numbers| act(live, &mut numbers[..live.parameters().len()]))
}
