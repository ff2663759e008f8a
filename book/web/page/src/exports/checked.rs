//! What the worker of the page *Check your picture* calls.

use std::cell::RefCell;

use super::{given::given, keep};
use crate::checked::{self, CheckRequest, CheckResponse};

thread_local! {
    static RESPONSE: RefCell<Option<CheckResponse>> = const { RefCell::new(None) };
}

/// Judges what was given: so many bytes of what is asked, and then the file.
#[unsafe(no_mangle)]
extern "C" fn check(asked: usize) -> usize {
    answer(asked, checked::answer)
}

/// Returns the answer to a file whose bytes are too many to be given.
#[unsafe(no_mangle)]
extern "C" fn too_large(asked: usize) -> usize {
    answer(asked, |request, _| checked::too_large(request))
}

/// Judges what the browser shows of a file: behind what is asked so many bytes of the file,
/// and then the pixels.
#[unsafe(no_mangle)]
extern "C" fn decoded(asked: usize, why: usize, width: u32, height: u32) -> usize {
    answer(asked, |request, rest| {
        let (why, rgba) = rest.split_at(why);
        checked::decoded(request, why, width, height, rgba)
    })
}

/// The right picture, the reader's, or the difference, four bytes a pixel.
#[unsafe(no_mangle)]
extern "C" fn picture(which: usize) -> usize {
    of_the_answer(|it| it.rgba(which))
}

/// The numbers of a pixel.
#[unsafe(no_mangle)]
extern "C" fn inspect(column: u32, row: u32) -> usize {
    of_the_answer(|it| it.inspect(column, row).into())
}

/// Returns what can be asked.
#[unsafe(no_mangle)]
extern "C" fn choices() -> usize {
    keep(checked::choices())
}

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

fn of_the_answer(what: impl FnOnce(&CheckResponse) -> Vec<u8>) -> usize {
    let said = RESPONSE.with_borrow(|response| response.as_ref().map(what));
    keep(said.unwrap_or_default())
}
