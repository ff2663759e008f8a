//! Edits of a function, and what they cost: the fewer words change, the likelier.

use std::ops::Range;

/// A replacement in a function's text, with a measure of how unlikely it is.
#[derive(Clone, Debug)]
pub(super) struct RankedEdit {
    /// The bytes that are replaced; empty where text is inserted.
    pub(super) at: Range<usize>,
    /// The text that replaces these bytes; empty if they are left out.
    pub(super) new: String,
    /// A rank by which edits are tried: 2 for each word that changes, and penalties. The lower, the
    /// likelier is the edit to undo what a person did.
    pub(super) rank: u32,
}

impl RankedEdit {
    /// Makes an edit of a text; `penalty` is added to the rank that its words give.
    pub(super) fn new(text: &str, at: Range<usize>, new: String, penalty: u32) -> Self {
        let rank = penalty + 2 * words_apart(&text[at.clone()], &new);
        Self { at, new, rank }
    }

    /// Returns a text with the edit made.
    pub(super) fn applied_to(&self, text: &str) -> String {
        let mut text = text.to_owned();
        text.replace_range(self.at.clone(), &self.new);
        text
    }

    /// Returns twice the number of brackets that the edit adds to a text: people lose brackets, and
    /// seldom add some.
    pub(super) fn brackets(&self, text: &str) -> u32 {
        let count = |text: &str| text.matches('(').count() as u32;
        2 * count(&self.new).saturating_sub(count(&text[self.at.clone()]))
    }
}

/// Counts the words and signs to change, insert or leave out so that a text becomes another
/// (Levenshtein, 1966). Round brackets don't count.
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

/// Splits a text into its words and signs, without blanks and round brackets.
fn words(text: &str) -> Vec<&str> {
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
