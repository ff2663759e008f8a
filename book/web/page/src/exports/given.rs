//! What a worker gives: it puts the bytes where [`take`] says, and then asks about them.

use std::cell::RefCell;

thread_local! {
    static GIVEN: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Makes room for so many bytes.
#[unsafe(no_mangle)]
extern "C" fn take(length: usize) -> *mut u8 {
    GIVEN.set(vec![0; length]);
    GIVEN.with_borrow_mut(Vec::as_mut_ptr)
}

/// Returns what was given, once.
pub(super) fn given() -> Vec<u8> {
    GIVEN.take()
}
