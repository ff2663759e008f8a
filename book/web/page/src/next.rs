//! Line diff: the first line of a chapter that is not in what a reader has typed so far.

use interpreter::SourceFile;

use crate::typed::Draft;

/// A line of the chapter that is still to be typed.
#[derive(Debug, PartialEq, Eq)]
pub struct NextLine {
    /// The place of its file among those of the reader.
    pub file: usize,
    /// The reader's line that it goes above, from 0.
    pub above: usize,
    /// The line, as far indented as it should be.
    pub text: &'static str,
    /// True if the line takes the place of the one at `above`, a `todo!()`, of which it is the
    /// last: false if it is inserted above that.
    pub replaces_todo: bool,
}

/// The next line to type, in the file in that place, and then in the others in their order.
pub fn next(yours: &Draft, first: usize) -> Option<NextLine> {
    let files = yours.files.iter().enumerate();
    let mut files = files.clone().skip(first).chain(files);
    files.find_map(|(file, SourceFile { name, text })| {
        let (_, theirs) = yours.chapter.files().iter().find(|(it, _)| it == name)?;
        missing(file, theirs, text)
    })
}

/// The first line of theirs that is not in yours, and where it goes.
fn missing(file: usize, theirs: &'static str, yours: &str) -> Option<NextLine> {
    let mut left: &[(usize, &str)] = &code(yours).collect::<Vec<_>>();
    let mut theirs = code(theirs).map(|(_, line)| line).peekable();
    while let Some(line) = theirs.next() {
        // Whatever is used may be named in any order.
        if line.starts_with("use ") && yours.contains(line) {
            continue;
        }
        let Some(found) = found(left, line) else {
            let (above, below) = *left.first().unwrap_or(&(yours.lines().count(), ""));
            let is_last = theirs.peek().is_none_or(|it| is_end(it));
            return Some(NextLine {
                file,
                above,
                text: line,
                replaces_todo: is_last && below.trim() == "todo!()",
            });
        };
        left = &left[found + 1..];
    }
    None
}

/// Where the line is among those that are left of the same function: lines of the reader's
/// own may stand before it.
fn found(left: &[(usize, &str)], line: &str) -> Option<usize> {
    let end = left.iter().position(|(_, it)| is_end_of_item(it));
    let of_function = &left[..end.map_or(left.len(), |end| end + 1)];
    of_function.iter().position(|(_, it)| is_same(it, line))
}

/// Returns true if both are the same, or say the same name in other words.
fn is_same(yours: &str, theirs: &str) -> bool {
    let name = |line: &str| {
        let mut words = line.split_whitespace();
        (words.next() == Some("let")).then(|| words.next().map(str::to_owned))
    };
    if is_end(theirs) {
        // The indentation says of what it is the end.
        return yours == theirs;
    }
    yours.trim() == theirs.trim() || name(theirs).is_some_and(|it| name(yours) == Some(it))
}

fn is_end(line: &str) -> bool {
    line.trim_start().starts_with('}')
}

fn is_end_of_item(line: &str) -> bool {
    line.starts_with('}')
}

/// The lines that are more than a comment or an attribute, with their places.
fn code(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let is_code = |line: &str| {
        !["//", "#"]
            .iter()
            .any(|it| line.trim_start().starts_with(it))
    };
    let lines = text.lines().map(str::trim_end).enumerate();
    lines.filter(move |(_, line)| !line.is_empty() && is_code(line))
}
