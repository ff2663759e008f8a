//! Exports: the functions that the scripts of the pages call.
//!
//! Unless it says otherwise, an exported function leaves its answer, bytes or UTF-8 text, in one
//! buffer and returns its length. The script then reads that many bytes from the address that
//! [`place`] returns, before it makes the next call.

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

/// Returns the address of the last answer.
#[unsafe(no_mangle)]
extern "C" fn place() -> *const u8 {
    ANSWER.with_borrow(Vec::as_ptr)
}

/// Keeps an answer for the script; returns its length in bytes.
fn keep(answer: impl Into<Vec<u8>>) -> usize {
    ANSWER.set(answer.into());
    ANSWER.with_borrow(Vec::len)
}
