//! Exports for the worker of the page *Check your picture*.

use std::cell::RefCell;

use super::{given::given, keep};
use crate::checked::{self, CheckRequest, CheckResponse};

thread_local! {
    static RESPONSE: RefCell<Option<CheckResponse>> = const { RefCell::new(None) };
}

/// Judges the bytes that were given: a request, `asked` bytes long, and then the file.
#[unsafe(no_mangle)]
extern "C" fn check(asked: usize) -> usize {
    answer(asked, CheckRequest::answer)
}

/// Answers a request for a file with too many bytes to be given: the `asked` bytes are all there
/// is.
#[unsafe(no_mangle)]
extern "C" fn too_large(asked: usize) -> usize {
    answer(asked, |request, _| request.too_large())
}

/// Returns the right picture (0), the reader's (1), or the difference (2), four bytes a pixel.
#[unsafe(no_mangle)]
extern "C" fn picture(which: usize) -> usize {
    of_the_answer(|it| it.rgba(which))
}

/// Returns the numbers behind the pixel of that column and row, from the top left.
#[unsafe(no_mangle)]
extern "C" fn inspect(column: u32, row: u32) -> usize {
    of_the_answer(|it| it.inspect(column, row).into())
}

/// Returns the chapters and probes that the page's form offers.
#[unsafe(no_mangle)]
extern "C" fn choices() -> usize {
    keep(checked::choices())
}

/// Judges the request and the file that were given, and keeps the response for later questions.
fn answer(asked: usize, judge: impl FnOnce(CheckRequest, &[u8]) -> CheckResponse) -> usize {
    // The last response makes room before the next picture is judged.
    RESPONSE.set(None);
    keep([]);
    let given = given();
    let (asked, file) = given.split_at(asked);
    let response = judge(CheckRequest::read(&String::from_utf8_lossy(asked)), file);
    let length = keep(response.text.clone());
    RESPONSE.set(Some(response));
    length
}

/// Keeps a part of the last response for the script: nothing, if there was none.
fn of_the_answer(what: impl FnOnce(&CheckResponse) -> Vec<u8>) -> usize {
    let said = RESPONSE.with_borrow(|response| response.as_ref().map(what));
    keep(said.unwrap_or_default())
}
