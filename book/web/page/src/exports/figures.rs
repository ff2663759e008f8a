//! Exports for the script of the live figures.
//!
//! The script sets the parameters of a figure one by one, calls a function that changes or draws
//! the figure, and reads the parameters back, since they may have been confined to their ranges.

use std::cell::RefCell;

use figures::{ACCURACY, LESSON, Movable};
use glam::DVec2;

use super::keep;

/// The figures of this module; the script names a figure by its index in the list.
static FIGURES: &[&dyn Movable] = if cfg!(feature = "accuracy") {
    ACCURACY
} else {
    LESSON
};

/// The largest number of parameters that a figure may have.
const MOST: usize = 16;

thread_local! {
    static NUMBERS: RefCell<[f64; MOST]> = const { RefCell::new([0.0; MOST]) };
}

/// Sets the parameter at this index.
#[unsafe(no_mangle)]
extern "C" fn set(place: usize, value: f64) {
    NUMBERS.with_borrow_mut(|numbers| numbers[place] = value);
}

/// Returns the parameter at this index.
#[unsafe(no_mangle)]
extern "C" fn get(place: usize) -> f64 {
    NUMBERS.with_borrow(|numbers| numbers[place])
}

/// Drags a handle of a figure to the point (x, y) of the drawing, in units of its viewBox, and
/// changes the parameters accordingly.
#[unsafe(no_mangle)]
extern "C" fn drag(figure: usize, handle: usize, x: f64, y: f64) {
    with(figure, |live, numbers| {
        live.drag(handle, numbers, DVec2::new(x, y));
    });
}

/// Changes the parameters as a button of a figure says.
#[unsafe(no_mangle)]
extern "C" fn act(figure: usize, action: usize) {
    with(figure, |live, numbers| live.act(action, numbers));
}

/// Draws a figure with the current parameters, confined to their ranges: see [`Movable::text`].
#[unsafe(no_mangle)]
extern "C" fn answer(figure: usize) -> usize {
    with(figure, |live, numbers| {
        live.confine(numbers);
        keep(live.text(numbers))
    })
}

/// Calls `act` with a figure and its parameters.
fn with<T>(figure: usize, act: impl FnOnce(&dyn Movable, &mut [f64]) -> T) -> T {
    let live = FIGURES[figure];
    NUMBERS.with_borrow_mut(|numbers| act(live, &mut numbers[..live.parameters().len()]))
}
