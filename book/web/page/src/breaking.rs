//! Mutation by hand: finds what people type in place of each word of a chapter, so that a reader
//! sees the use of that word.

use std::ops::Range;

use check::{FileEdit, edits_everywhere};
use interpreter::FaultKind;
use slips::Chapter;

use crate::typed::Draft;
use crate::words::words;

/// The largest number of edits that the page offers for one word.
const MOST: usize = 8;
/// Signs that only hold others together: a reader cannot choose them as words to break.
const GLUE: [&str; 12] = ["(", ")", "[", "]", "{", "}", ".", ",", ";", "::", "?", "|"];

/// A chapter's own text, with all edits by which a reader can break it on a page: the reader
/// chooses a word and then an edit, and sees what comes of it.
pub struct Breakable {
    draft: Draft,
    edits: Vec<WordEdit>,
}

/// An edit that the page offers for a word: a range of one file, and the text for its place.
#[derive(Clone, Debug)]
pub struct WordEdit {
    /// The index of the edited file in [`Draft::files`], from 0.
    pub file: usize,
    /// The range of bytes in that file which the edit replaces: whole words, as few as the change
    /// allows.
    pub at: Range<usize>,
    /// The text that takes the place of the range; empty if the words are deleted.
    pub new: String,
    /// The name of the known mistake of readers ([`slips::Slip`]) that this edit makes, or `None`
    /// for a mistake without a name.
    pub slip: Option<&'static str>,
    /// The order in which edits are offered: known slips first, then those that replace the fewest
    /// words.
    rank: (bool, usize, u32),
}

/// A word of a chapter's text that a reader can choose to break.
#[derive(Clone, Debug)]
pub struct Word {
    /// The index of the word's file in [`Draft::files`], from 0.
    pub file: usize,
    /// The range of bytes that the word fills in that file.
    pub at: Range<usize>,
}

impl Breakable {
    /// Reads the text of a chapter and finds all edits of its words, each of them once.
    ///
    /// # Panics
    /// If the interpreter cannot read the chapter's own text, or for [`Chapter::SpeedVsAccuracy`],
    /// which has no text to be typed.
    pub fn new(chapter: Chapter) -> Self {
        let draft = Draft::complete(chapter);
        let program = draft.read().unwrap_or_else(|said| panic!("{}", said.rest));
        let known = known(chapter, &draft);
        let typed = edits_everywhere(&program, &draft.files).into_iter();
        let all = known.into_iter().chain(typed.map(|it| (it, None)));
        let mut edits: Vec<WordEdit> = all
            .filter_map(|(edit, slip)| WordEdit::new(&draft, edit, slip))
            .collect();
        edits.sort_by_key(|it| it.rank);
        let mut seen = Vec::new();
        edits.retain(|it| {
            let made = (it.file, it.at.clone(), it.new.clone());
            let is_new = !seen.contains(&made);
            seen.push(made);
            is_new
        });
        Self { draft, edits }
    }

    /// Returns the chapter's own text, without an edit.
    pub fn draft(&self) -> &Draft {
        &self.draft
    }

    /// Lists the words that at least one edit changes, file by file and from the top; brackets,
    /// commas and their like are left out.
    pub fn words(&self) -> Vec<Word> {
        let files = self.draft.files.iter().enumerate();
        let all = files.flat_map(|(file, it)| {
            words(&it.text).into_iter().map(move |(at, word)| Word {
                file,
                at: at..at + word.len(),
            })
        });
        let is_word = |it: &Word| {
            let text = &self.draft.files[it.file].text;
            !GLUE.contains(&&text[it.at.clone()])
        };
        all.filter(|it| is_word(it) && self.edits.iter().any(|edit| edit.changes(it)))
            .collect()
    }

    /// Lists at most eight edits that change `word` and leave a program that compiles: known slips
    /// (mistakes of readers) first, then those that replace the fewest words. The list is empty if
    /// there are none.
    pub fn edits(&self, word: &Word) -> Vec<&WordEdit> {
        let all = self.edits.iter().filter(|it| it.changes(word));
        all.filter(|it| self.is_drawn(it)).take(MOST).collect()
    }

    /// Returns the chapter's text after `edit`, which has to be one of this chapter's edits.
    pub fn broken(&self, edit: &WordEdit) -> Draft {
        let mut draft = self.draft.clone();
        let file = &mut draft.files[edit.file].text;
        file.replace_range(edit.at.clone(), &edit.new);
        draft
    }

    /// Returns true if the interpreter reads and draws the text after `edit`, or it compiles and
    /// stops.
    fn is_drawn(&self, edit: &WordEdit) -> bool {
        let fault = self.broken(edit).first_fault();
        matches!(fault, None | Some(FaultKind::Stopped))
    }

    /// Returns the words that offer `edit` for `word` in a list, as plain text in one line: the new
    /// text, `old → new` if the edit replaces more than `word`, or `without old`; and then the name
    /// of a known mistake in brackets.
    pub fn label(&self, word: &Word, edit: &WordEdit) -> String {
        let text = &self.draft.files[edit.file].text;
        let squeezed = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        let (old, new) = (squeezed(&text[edit.at.clone()]), squeezed(&edit.new));
        let made = match (old.as_str(), new.as_str()) {
            (old, "") => format!("without {old}"),
            (_, new) if edit.at == word.at => new.to_owned(),
            (old, new) => format!("{old} → {new}"),
        };
        match edit.slip {
            Some(slip) => format!("{made}   ({})", slip.replace('-', " ")),
            None => made,
        }
    }
}

impl WordEdit {
    /// Narrows an edit to the words that differ. Returns `None` if none do, or if an edit that is
    /// no known slip replaces text of more than one line.
    fn new(draft: &Draft, edit: FileEdit, slip: Option<&'static str>) -> Option<Self> {
        let file = &draft.files[edit.file].text;
        let old = &file[edit.at.clone()];
        if slip.is_none() && old.contains('\n') {
            return None;
        }
        let (mut at, new) = differing(old, &edit.new)?;
        let count = words(&old[at.clone()]).len();
        // No blank stays before what ends a list or a statement.
        if new.is_empty() && file[edit.at.start + at.end..].starts_with([';', ',', ')', '.']) {
            at.start = old[..at.start].trim_end().len();
        }
        Some(Self {
            file: edit.file,
            at: edit.at.start + at.start..edit.at.start + at.end,
            new: new.to_owned(),
            slip,
            rank: (slip.is_none(), count, edit.rank),
        })
    }

    /// Returns true if the edit replaces at least a part of `word`.
    fn changes(&self, word: &Word) -> bool {
        self.file == word.file && self.at.start < word.at.end && word.at.start < self.at.end
    }
}

/// Lists the known slips that are one edit of one place of the chapter's text, each as an edit of a
/// whole file, with the slip's name.
fn known(chapter: Chapter, draft: &Draft) -> Vec<(FileEdit, Option<&'static str>)> {
    let is_typed = |slip: &&slips::Slip| slip.is_typed_in(chapter) && slip.is_possible_in_rust();
    let edits = slips::all().filter(is_typed).filter_map(|slip| {
        let edit = slip.only_edit(chapter)?;
        let files = draft.files.iter().enumerate();
        let mut made = files.filter_map(|(n, it)| Some((n, &it.text, edit.applied_to(&it.text)?)));
        let (file, text, new) = made.next().filter(|_| made.next().is_none())?;
        let whole = FileEdit {
            file,
            at: 0..text.len(),
            new,
            rank: 0,
        };
        Some((whole, Some(slip.name)))
    });
    edits.collect()
}

/// Returns the range of bytes of `old` that differs from `new`, in whole words and with brackets in
/// pairs, and the words that `new` has there. Where `new` only adds words, the range is a neighbor
/// of these. Returns `None` if both texts have the same words, or `old` has none.
fn differing<'n>(old: &str, new: &'n str) -> Option<(Range<usize>, &'n str)> {
    let (olds, news) = (words(old), words(new));
    let same = olds
        .iter()
        .zip(&news)
        .take_while(|(one, other)| one.1 == other.1);
    let mut first = same.count();
    let rest = olds.len().min(news.len()) - first;
    let backwards = olds.iter().rev().zip(news.iter().rev()).take(rest);
    let mut last = backwards
        .take_while(|(one, other)| one.1 == other.1)
        .count();
    if first == olds.len() && first == news.len() {
        return None;
    }
    if first + last == olds.len() {
        if last > 0 {
            last -= 1;
        } else {
            first = first.checked_sub(1)?;
        }
    }
    // What a bracket opens or closes belongs to it.
    let (first, last) = loop {
        let parts = [&olds, &news].map(|it| unmatched(&it[first..it.len() - last]));
        match (parts[0].1 + parts[1].1, parts[0].0 + parts[1].0) {
            (1.., _) if last > 0 => last -= 1,
            (_, 1..) if first > 0 => first -= 1,
            _ => break (first, last),
        }
    };
    let place = |words: &[(usize, &str)]| match &words[first..words.len() - last] {
        [one, .., other] => one.0..other.0 + other.1.len(),
        [one] => one.0..one.0 + one.1.len(),
        [] => {
            let end = words.get(first).map_or(0, |it| it.0);
            end..end
        }
    };
    Some((place(&olds), &new[place(&news)]))
}

/// Counts the brackets that close without having been opened, and those that stay open.
fn unmatched(words: &[(usize, &str)]) -> (usize, usize) {
    words
        .iter()
        .fold((0, 0), |(closed, open), (_, word)| match *word {
            "(" | "[" | "{" => (closed, open + 1),
            ")" | "]" | "}" if open > 0 => (closed, open - 1),
            ")" | "]" | "}" => (closed + 1, open),
            _ => (closed, open),
        })
}
