//! Input from a worker: it writes bytes to the address that [`take`] returns, and then calls the
//! function that reads them.

use std::cell::RefCell;

thread_local! {
    static GIVEN: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Makes room for `length` bytes and returns the address where the worker writes them.
#[unsafe(no_mangle)]
extern "C" fn take(length: usize) -> *mut u8 {
    GIVEN.set(vec![0; length]);
    GIVEN.with_borrow_mut(Vec::as_mut_ptr)
}

/// Returns the bytes that the worker has written, and forgets them.
pub(super) fn given() -> Vec<u8> {
    GIVEN.take()
}
