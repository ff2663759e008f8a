//! Search and replace in source text, blind to how it is laid out.

use std::borrow::Cow;

/// A replacement in a source text, which makes a mistake. Blanks and line ends do not count when
/// the code to replace is looked for.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Edit {
    /// The code to replace, as the right text has it.
    pub right: Cow<'static, str>,
    /// The code that replaces it; empty to delete the right code.
    pub wrong: Cow<'static, str>,
}

impl Edit {
    /// Makes the edit that replaces the code `right` by `wrong`.
    pub fn new(right: impl Into<Cow<'static, str>>, wrong: impl Into<Cow<'static, str>>) -> Self {
        Self {
            right: right.into(),
            wrong: wrong.into(),
        }
    }

    /// Parses an edit that is written `right → wrong`, as in the catalogue of slips. Without an
    /// arrow, the edit deletes the text.
    pub fn parse(text: &'static str) -> Self {
        let (right, wrong) = text.split_once('→').unwrap_or((text, ""));
        Self::new(right.trim(), wrong.trim())
    }

    /// Returns true if the edit is no text but makes all numbers single precision.
    pub(crate) fn is_precision(&self) -> bool {
        *self == Self::new("f64", "f32")
    }

    /// Returns a text in which every occurrence of the [`right`](Self::right) code is replaced, or
    /// `None` if there is no occurrence. An occurrence cuts no name in two, and does not begin with
    /// a field: `b` is not found in `rgb`, nor in `it.b`.
    pub fn applied_to(&self, text: &str) -> Option<String> {
        let (mut made, mut done) = (String::new(), 0);
        while let Some((start, end)) = self.found(text, done) {
            made += &text[done..start];
            made += &self.wrong;
            done = end;
        }
        (done > 0).then(|| made + &text[done..])
    }

    /// Finds the statement around the first occurrence of the right part, as it is and with all of
    /// these edits, both on one line. `None` if the text does not have the right part.
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

    /// Returns true if a text has the right part.
    pub(crate) fn stands_in(&self, text: &str) -> bool {
        self.found(text, 0).is_some()
    }

    /// Finds the first and last byte of the first occurrence of the right part from byte `from` on,
    /// the last one excluded.
    fn found(&self, text: &str, from: usize) -> Option<(usize, usize)> {
        let first = *self.right.trim_start().as_bytes().first()?;
        let starts = (from..text.len()).filter(|&at| text.as_bytes()[at] == first);
        let mut all = starts.filter_map(|start| Some((start, self.end(text, start)?)));
        all.find(|&(start, end)| is_whole(text, start, end))
    }

    /// Returns where an occurrence that begins at byte `start` ends, if there is one.
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

/// Returns true if the bytes from `start` to `end` cut no name in two and begin with no field.
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

/// Writes a statement on one line, without comments, `let`, `if`, `Some(…)` and semicolon. Levels,
/// which here may be no bytes, are written as the bytes they are in the chapters.
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
