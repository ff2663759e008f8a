//! Exports: the functions that the scripts of the pages call.
//!
//! A script calls a function, and reads the answer, as long as that one says, where [`place`]
//! says. It stays there until the next call.

#[cfg(feature = "judge")]
mod breaking;
#[cfg(feature = "judge")]
mod checked;
#[cfg(any(feature = "lesson", feature = "accuracy"))]
mod figures;
#[cfg(feature = "judge")]
mod given;
#[cfg(feature = "judge")]
mod typed;

use std::cell::RefCell;

thread_local! {
    static ANSWER: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Where the last answer is.
#[unsafe(no_mangle)]
extern "C" fn place() -> *const u8 {
    ANSWER.with_borrow(Vec::as_ptr)
}

/// Keeps an answer; returns its length in bytes.
fn keep(answer: impl Into<Vec<u8>>) -> usize {
    ANSWER.set(answer.into());
    ANSWER.with_borrow(Vec::len)
}
