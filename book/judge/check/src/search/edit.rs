//! Edits of a function, and what they cost: the fewer words change, the likelier.

use std::ops::Range;

/// A change of a function's text.
#[derive(Clone, Debug)]
pub(super) struct RankedEdit {
    /// What is replaced; an empty place takes what is left out there.
    pub(super) at: Range<usize>,
    pub(super) new: String,
    /// The lower, the likelier.
    pub(super) rank: u32,
}

/// An expression or a statement of the chapter's costs no more than so many words, and a few for
/// its length.
const MOST: u32 = 3;

impl RankedEdit {
    /// Makes an edit that is so much less likely than its words say.
    pub(super) fn new(text: &str, at: Range<usize>, new: String, penalty: u32) -> Self {
        let rank = penalty + 2 * words_apart(&text[at.clone()], &new);
        Self { at, new, rank }
    }

    /// Makes one by which something is the chapter's as a whole: it may have many words.
    pub(super) fn whole(text: &str, at: Range<usize>, new: String, penalty: u32) -> Self {
        // A choice is long to read in the place of a value.
        if new.contains(" if ") {
            return Self::new(text, at, new, penalty);
        }
        let apart = words_apart(&text[at.clone()], &new);
        let rank = penalty + 2 * apart.min(MOST + apart / 8);
        Self { at, new, rank }
    }

    /// Returns the function with the edit.
    pub(super) fn applied_to(&self, text: &str) -> String {
        let mut text = text.to_owned();
        text.replace_range(self.at.clone(), &self.new);
        text
    }

    /// Counts the brackets that it adds, twice: people lose brackets, and seldom add some.
    pub(super) fn brackets(&self, text: &str) -> u32 {
        let count = |text: &str| text.matches('(').count() as u32;
        2 * count(&self.new).saturating_sub(count(&text[self.at.clone()]))
    }

    /// Returns true if a function is called less often with it.
    pub(super) fn writes_out(&self, name: &str, text: &str) -> bool {
        let count = |text: &str| words(text).iter().filter(|it| **it == name).count();
        count(&text[self.at.clone()]) > count(&self.new)
    }
}

/// Counts the words and signs by which two texts differ (Levenshtein, 1966). Brackets don't count.
fn words_apart(one: &str, other: &str) -> u32 {
    let (one, other) = (words(one), words(other));
    let mut row: Vec<u32> = (0..=other.len() as u32).collect();
    for (n, word) in one.iter().enumerate() {
        let mut diagonal = row[0];
        row[0] = n as u32 + 1;
        for (m, it) in other.iter().enumerate() {
            let changed = if word == it {
                diagonal
            } else {
                1 + diagonal.min(row[m]).min(row[m + 1])
            };
            diagonal = row[m + 1];
            row[m + 1] = changed;
        }
    }
    row[other.len()]
}

pub(super) fn words(text: &str) -> Vec<&str> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let mut words = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let end = if is_word(first) {
            rest.find(|c| !is_word(c)).unwrap_or(rest.len())
        } else {
            first.len_utf8()
        };
        if !first.is_whitespace() && !"()".contains(first) {
            words.push(&rest[..end]);
        }
        rest = &rest[end..];
    }
    words
}
