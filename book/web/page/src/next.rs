//! Line diff: finds the first line of a chapter that a reader's draft lacks.

use interpreter::SourceFile;
use slips::ChapterCode;

use crate::typed::Draft;

/// The first line of a chapter that a reader's draft lacks, and its place in the draft.
#[derive(Debug, PartialEq, Eq)]
pub struct NextLine {
    /// The index in [`Draft::files`], from 0, of the file that lacks the line.
    pub file: usize,
    /// The index, from 0, of the draft's line above which the missing line goes; the number of
    /// lines if it goes to the end.
    pub above: usize,
    /// The line itself, indented as in the chapter, without an end of line.
    pub text: &'static str,
    /// True if the missing line replaces the line at `above`, a `todo!()`; false if it is inserted.
    pub replaces_todo: bool,
}

/// Returns the first line of the chapter that the draft lacks, or `None` if it has all. The search
/// begins in the file with the index `first`, from 0, and goes on through all files from the first
/// one on. Comments, attributes and empty lines do not count.
pub fn next(yours: &Draft, first: usize) -> Option<NextLine> {
    let files = yours.files.iter().enumerate();
    let mut files = files.clone().skip(first).chain(files);
    files.find_map(|(file, SourceFile { name, text })| {
        let theirs = yours.chapter.files().iter().find(|it| it.name == name)?;
        missing(file, theirs.text, text)
    })
}

/// Returns the first line of the text `theirs` that the text `yours` lacks.
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

/// Returns the index in `left` of the chapter's line `line`, if the reader's function has it: other
/// lines of the reader may stand before it.
fn found(left: &[(usize, &str)], line: &str) -> Option<usize> {
    let end = left.iter().position(|(_, it)| is_end_of_item(it));
    let of_function = &left[..end.map_or(left.len(), |end| end + 1)];
    of_function.iter().position(|(_, it)| is_same(it, line))
}

/// Returns true if both lines are the same, or both give a value to the same name by `let`.
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

/// Returns true for a line that begins with a closing brace.
fn is_end(line: &str) -> bool {
    line.trim_start().starts_with('}')
}

/// Returns true for a closing brace that is not indented, with which a function or type ends.
fn is_end_of_item(line: &str) -> bool {
    line.starts_with('}')
}

/// Returns the lines that are not empty and no comment or attribute, with their index from 0.
fn code(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let is_code = |line: &str| {
        !["//", "#"]
            .iter()
            .any(|it| line.trim_start().starts_with(it))
    };
    let lines = text.lines().map(str::trim_end).enumerate();
    lines.filter(move |(_, line)| !line.is_empty() && is_code(line))
}
