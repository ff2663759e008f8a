//! What the worker of the page *Check your picture* calls.

use std::cell::RefCell;

use super::{given::given, keep};
use crate::checked::{self, Answered, Question};

thread_local! {
    static ANSWERED: RefCell<Option<Answered>> = const { RefCell::new(None) };
}

/// Judges what was given: so many bytes of what is asked, and then the file.
#[unsafe(no_mangle)]
extern "C" fn check(asked: usize) -> usize {
    answer(asked, checked::answer)
}

/// Returns the answer to a file whose bytes are too many to be given.
#[unsafe(no_mangle)]
extern "C" fn too_large(asked: usize) -> usize {
    answer(asked, |question, _| checked::too_large(question))
}

/// Judges what the browser shows of a file: behind what is asked so many bytes of the file,
/// and then the pixels.
#[unsafe(no_mangle)]
extern "C" fn decoded(asked: usize, why: usize, width: u32, height: u32) -> usize {
    answer(asked, |question, rest| {
        let (why, rgba) = rest.split_at(why);
        checked::decoded(question, why, (width, height), rgba)
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

fn answer(asked: usize, judge: impl FnOnce(Question, &[u8]) -> Answered) -> usize {
    // What was answered before is not needed while the next is judged.
    ANSWERED.set(None);
    keep([]);
    let given = given();
    let (asked, file) = given.split_at(asked);
    let answered = judge(Question::read(&String::from_utf8_lossy(asked)), file);
    let length = keep(answered.text.clone());
    ANSWERED.set(Some(answered));
    length
}

fn of_the_answer(what: impl FnOnce(&Answered) -> Vec<u8>) -> usize {
    let said = ANSWERED.with_borrow(|answered| answered.as_ref().map(what));
    keep(said.unwrap_or_default())
}
