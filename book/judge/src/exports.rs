//! What the worker of the page calls.
//!
//! The script puts the name of a file and its bytes where [`take`] says, calls what judges,
//! and reads the answer where [`place`] says. It stays there until the next call.

use std::cell::RefCell;

use crate::{Answered, Asked};

#[derive(Default)]
struct State {
    given: Vec<u8>,
    answered: Option<Answered>,
    said: Vec<u8>,
}

thread_local! {
    static STATE: RefCell<State> = RefCell::default();
}

/// Makes room for so many bytes: the name of a file, and what is in it.
#[unsafe(no_mangle)]
extern "C" fn take(length: usize) -> *mut u8 {
    STATE.with_borrow_mut(|state| {
        // What was said before is not needed while the next is judged.
        *state = State::default();
        state.given = vec![0; length];
        state.given.as_mut_ptr()
    })
}

/// Judges what was given: a name of so many bytes, and then the file.
#[unsafe(no_mangle)]
extern "C" fn judge(name: usize, chapter: usize, probe: usize, edition: usize) -> usize {
    let asked = Asked {
        chapter,
        probe,
        edition,
    };
    answered(name, |name, bytes| crate::answer(name, bytes, asked))
}

/// The same of a file whose bytes are too many to be given.
#[unsafe(no_mangle)]
extern "C" fn too_large(name: usize) -> usize {
    answered(name, |name, _| crate::too_large(name, Asked::default()))
}

/// Judges what the browser shows of a file: after the name so many bytes of the file, and
/// then the pixels.
#[unsafe(no_mangle)]
extern "C" fn decoded(
    name: usize,
    why: usize,
    width: u32,
    height: u32,
    chapter: usize,
    probe: usize,
    edition: usize,
) -> usize {
    let asked = Asked {
        chapter,
        probe,
        edition,
    };
    answered(name, |name, rest| {
        let (why, rgba) = rest.split_at(why);
        crate::decoded(name, why, (width, height), rgba, asked)
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

/// What can be asked.
#[unsafe(no_mangle)]
extern "C" fn choices() -> usize {
    say(crate::choices().into())
}

/// Where the last answer is.
#[unsafe(no_mangle)]
extern "C" fn place() -> *const u8 {
    STATE.with_borrow(|state| state.said.as_ptr())
}

fn answered(name: usize, judge: impl FnOnce(&str, &[u8]) -> Answered) -> usize {
    let given = STATE.with_borrow_mut(|state| std::mem::take(&mut state.given));
    let (name, bytes) = given.split_at(name);
    let answered = judge(&String::from_utf8_lossy(name), bytes);
    let text = answered.text.clone();
    STATE.with_borrow_mut(|state| state.answered = Some(answered));
    say(text.into())
}

fn of_the_answer(what: impl FnOnce(&Answered) -> Vec<u8>) -> usize {
    let said = STATE.with_borrow(|state| state.answered.as_ref().map(what));
    say(said.unwrap_or_default())
}

fn say(said: Vec<u8>) -> usize {
    STATE.with_borrow_mut(|state| {
        state.said = said;
        state.said.len()
    })
}
