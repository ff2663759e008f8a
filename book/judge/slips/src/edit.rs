//! Edits: what is typed in the place of what a chapter has.

use std::borrow::Cow;

/// A part of a text and what is typed in its place. Blanks and the ends of lines do not count.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Edit {
    /// What the text has.
    pub right: Cow<'static, str>,
    /// What is typed.
    pub wrong: Cow<'static, str>,
}

impl Edit {
    /// The edit that puts a text in the place of another.
    pub fn new(right: impl Into<Cow<'static, str>>, wrong: impl Into<Cow<'static, str>>) -> Self {
        Self {
            right: right.into(),
            wrong: wrong.into(),
        }
    }

    /// Reads the edit that is written `right → wrong`.
    pub fn parse(said: &'static str) -> Self {
        let (right, wrong) = said.split_once('→').unwrap_or((said, ""));
        Self::new(right.trim(), wrong.trim())
    }

    /// Returns true if it puts shorter numbers in the place of all.
    pub(crate) fn is_precision(&self) -> bool {
        *self == Self::new("f64", "f32") || self.is_as_in_cpp()
    }

    /// Returns true if it does so but for levels, since a number that is typed in C++ is a double.
    pub(crate) fn is_as_in_cpp(&self) -> bool {
        *self == Self::new("double", "float")
    }

    /// The text with the edit everywhere where it stands, if it stands there.
    pub fn applied_to(&self, text: &str) -> Option<String> {
        let (mut made, mut done) = (String::new(), 0);
        while let Some((start, end)) = self.found(text, done) {
            made += &text[done..start];
            made += &self.wrong;
            done = end;
        }
        (done > 0).then(|| made + &text[done..])
    }

    /// Finds the statement around the place where it stands first, right and with all of these
    /// edits.
    pub(crate) fn statement(&self, text: &str, edits: &[Self]) -> Option<Self> {
        let (start, end) = self.found(text, 0)?;
        let ends = [';', '{', '}'];
        let start = text[..start].rfind(ends).map_or(0, |at| at + 1);
        let after = match text[..end].ends_with(ends) {
            true => 0,
            false => text[end..].find(ends).unwrap_or_default(),
        };
        let right = &text[start..end + after];
        let made = edits.iter().filter(|edit| edit.stands_in(right));
        let wrong = made.fold(right.to_owned(), |text, edit| {
            edit.applied_to(&text).unwrap_or(text)
        });
        Some(Self::new(line(right), line(&wrong)))
    }

    /// Returns true if it stands in the text.
    pub(crate) fn stands_in(&self, text: &str) -> bool {
        self.found(text, 0).is_some()
    }

    /// Where it stands first, from a place on.
    fn found(&self, text: &str, from: usize) -> Option<(usize, usize)> {
        let first = *self.right.trim_start().as_bytes().first()?;
        let starts = (from..text.len()).filter(|&at| text.as_bytes()[at] == first);
        let mut all = starts.filter_map(|start| Some((start, self.end(text, start)?)));
        all.find(|&(start, end)| is_whole(text, start, end))
    }

    /// Where it ends if it begins at that place.
    fn end(&self, text: &str, start: usize) -> Option<usize> {
        let is_said = |it: &u8| !it.is_ascii_whitespace();
        let mut wanted = self.right.bytes().filter(is_said);
        let mut next = wanted.next();
        for (n, byte) in text
            .bytes()
            .enumerate()
            .skip(start)
            .filter(|it| is_said(&it.1))
        {
            match next {
                Some(it) if it == byte => next = wanted.next(),
                _ => return None,
            }
            if next.is_none() {
                return Some(n + 1);
            }
        }
        None
    }
}

/// Returns true if no name goes on at either end, and none before it has this one as a part.
fn is_whole(text: &str, start: usize, end: usize) -> bool {
    let is_of_a_name = |it: char| it.is_alphanumeric() || it == '_';
    let [first, last] = [
        text[start..].chars().next(),
        text[..end].chars().next_back(),
    ];
    let (before, after) = (
        text[..start].chars().next_back(),
        text[end..].chars().next(),
    );
    let goes_on = |one: Option<char>, other: Option<char>| {
        one.is_some_and(is_of_a_name) && other.is_some_and(is_of_a_name)
    };
    let is_a_field = first.is_some_and(is_of_a_name) && before == Some('.');
    !goes_on(before, first) && !goes_on(last, after) && !is_a_field
}

/// Writes a statement on one line, without what binds it to those around it. A pixel of a file may
/// have numbers that are no bytes; in Rust it has bytes.
fn line(statement: &str) -> String {
    let code = statement
        .lines()
        .map(|line| line.split("//").next().unwrap_or(line));
    let words: Vec<&str> = code.flat_map(str::split_whitespace).collect();
    let line = words
        .join(" ")
        .replace("; let ", "; ")
        .replace(" as i32", " as u8");
    let line = line.trim_end_matches(';').trim_start_matches("let ");
    let some = line
        .strip_prefix("Some(")
        .and_then(|it| it.strip_suffix(')'));
    match some.unwrap_or(line) {
        pattern if pattern.starts_with("if let") => pattern.to_owned(),
        line => line.trim_start_matches("if ").to_owned(),
    }
}
