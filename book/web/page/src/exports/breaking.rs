//! Exports for the worker of an editor in which a reader breaks words of a chapter.

use std::cell::RefCell;
use std::ops::Range;

use super::{keep, typed::draft};
use crate::breaking::{Breakable, Word};
use crate::typed::Draft;

thread_local! {
    static BREAKABLE: RefCell<Option<(Breakable, Vec<Word>)>> = const { RefCell::new(None) };
}

/// Lists the words that can be broken, of the chapter whose name was given: one per line, with the
/// index of its file, and the positions where it begins and ends.
#[unsafe(no_mangle)]
extern "C" fn breakable_words() -> usize {
    let breakable = Breakable::new(draft().chapter);
    let words = breakable.words();
    let lines: Vec<String> = words
        .iter()
        .map(|it| place(breakable.draft(), it.file, &it.at))
        .collect();
    BREAKABLE.set(Some((breakable, words)));
    keep(lines.join("\n"))
}

/// Lists the edits of the word at this index in [`breakable_words`], three fields each with zero
/// bytes between them: label; file, start and end of the replaced text; and the new text.
#[unsafe(no_mangle)]
extern "C" fn alternatives(word: usize) -> usize {
    let lines = BREAKABLE.with_borrow(|it| {
        let (breakable, words) = it.as_ref().expect("the words were asked for");
        let word = &words[word];
        let lines = breakable.edits(word).into_iter().map(|it| {
            let place = place(breakable.draft(), it.file, &it.at);
            let label = breakable.label(word, it);
            format!("{label}\0{place}\0{}", it.new)
        });
        lines.collect::<Vec<_>>().join("\0")
    });
    keep(lines)
}

/// Writes the index of a file and a range of it as a script counts: in UTF-16 units.
fn place(draft: &Draft, file: usize, at: &Range<usize>) -> String {
    let text = &draft.files[file].text;
    let count = |at: usize| text[..at].encode_utf16().count();
    format!("{file} {} {}", count(at.start), count(at.end))
}
