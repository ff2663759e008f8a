//! Mutation by hand: what people type in the place of each word of a chapter, so that a reader
//! sees what that word is for.

use std::ops::Range;

use check::{FileEdit, edits_everywhere};
use interpreter::FaultKind;
use slips::{Chapter, ReaderLanguage};

use crate::typed::Draft;
use crate::words::words;

/// So many edits are offered for a word.
const MOST: usize = 8;
/// What only holds others together is no word to be chosen.
const GLUE: [&str; 12] = ["(", ")", "[", "]", "{", "}", ".", ",", ";", "::", "?", "|"];
/// So wide a picture shows what a compiler would refuse.
const WIDTH: u32 = 24;

/// The text of a chapter, and the edits that can be made in it.
pub struct Breakable {
    draft: Draft,
    edits: Vec<WordEdit>,
}

/// An edit that is offered.
#[derive(Clone, Debug)]
pub struct WordEdit {
    /// The place of its file among those of the reader.
    pub file: usize,
    /// The bytes that it replaces: whole words, and no more than differ.
    pub at: Range<usize>,
    /// The text that takes their place.
    pub new: String,
    /// The name of a known slip, if it is one.
    pub slip: Option<&'static str>,
    /// The likeliest have the lowest.
    rank: (bool, usize, u32),
}

/// A word that can be chosen.
#[derive(Clone, Debug)]
pub struct Word {
    /// The place of its file among those of the reader.
    pub file: usize,
    /// The bytes of the word.
    pub at: Range<usize>,
}

impl Breakable {
    /// Reads a chapter and finds all edits.
    ///
    /// # Panics
    /// If the chapter's own text can't be read.
    pub fn new(chapter: Chapter) -> Self {
        let draft = Draft::full(chapter);
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

    /// Returns the chapter's own text.
    pub fn draft(&self) -> &Draft {
        &self.draft
    }

    /// Lists the words for which there are edits.
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

    /// Lists the edits of a word that draw something: known slips first, and then those that
    /// change least.
    pub fn edits(&self, word: &Word) -> Vec<&WordEdit> {
        let all = self.edits.iter().filter(|it| it.changes(word));
        all.filter(|it| self.is_drawn(it)).take(MOST).collect()
    }

    /// Returns the text with the edit.
    pub fn broken(&self, edit: &WordEdit) -> Draft {
        let mut draft = self.draft.clone();
        let file = &mut draft.files[edit.file].text;
        file.replace_range(edit.at.clone(), &edit.new);
        draft
    }

    fn is_drawn(&self, edit: &WordEdit) -> bool {
        let broken = self.broken(edit);
        let program = interpreter::read(&broken.in_reading_order());
        program.is_ok_and(|it| match it.draw(WIDTH) {
            Ok(_) => true,
            Err(fault) => fault.kind == FaultKind::Stopped,
        })
    }

    /// Returns what the edit replaces, and with what, as a reader sees it.
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
    /// Makes one of an edit in one line, or of a known slip.
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

    fn changes(&self, word: &Word) -> bool {
        self.file == word.file && self.at.start < word.at.end && word.at.start < self.at.end
    }
}

/// Lists the known slips that are one edit of one place of the chapter's text.
fn known(chapter: Chapter, draft: &Draft) -> Vec<(FileEdit, Option<&'static str>)> {
    let is_typed = |slip: &&slips::Slip| {
        slip.is_typed_in(chapter) && slip.is_possible_in_language(ReaderLanguage::Rust)
    };
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

/// Returns the words of the old text that the new one has otherwise, and what that has there: with
/// the next word, or the last, where only something is added.
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

/// Counts the brackets that are closed and were not opened, and those that stay open.
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
