//! Line diff: finds the first line of a chapter that a reader's draft lacks.

use interpreter::SourceFile;
use skeletons::on_the_first_stair;
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
    pub text: String,
    /// True if the missing line replaces the line at `above`, a `todo!()` or a line of chapter 5's
    /// first stair; false if it is inserted.
    pub is_instead: bool,
}

/// Returns the first line of the chapter that the draft lacks, or `None` if it has all. The search
/// begins in the file with the index `first`, from 0, and goes on through all files from the first
/// one on. Comments, attributes and empty lines do not count. In chapter 5 the second stair, which
/// begins with the trait, comes when no file lacks a line of the first.
pub fn next(yours: &Draft, first: usize) -> Option<NextLine> {
    let has_trait = |file: &SourceFile| file.text.contains("trait Hittable");
    let is_on_the_second = yours.files.iter().any(has_trait);
    let of_the_first = || lacked(yours, first, on_the_first_stair);
    let of_the_second = || lacked(yours, first, str::to_owned);
    let lacked = (!is_on_the_second).then(of_the_first).flatten();
    lacked.or_else(of_the_second)
}

/// Returns the first line that the draft lacks of the chapter's files, as `stair` makes them.
fn lacked(yours: &Draft, first: usize, stair: fn(&str) -> String) -> Option<NextLine> {
    let files = yours.files.iter().enumerate();
    let mut files = files.clone().skip(first).chain(files);
    files.find_map(|(file, SourceFile { name, text })| {
        let theirs = yours.chapter.files().iter().find(|it| it.name == name)?;
        missing(file, &stair(theirs.text), text)
    })
}

/// Returns the first line of the text `theirs` that the text `yours` lacks.
fn missing(file: usize, theirs: &str, yours: &str) -> Option<NextLine> {
    let mut left: &[(usize, &str)] = &code(yours).collect::<Vec<_>>();
    let mut theirs = code(theirs).map(|(_, line)| line).peekable();
    while let Some(line) = theirs.next() {
        // Whatever is used may be named in any order.
        if line.starts_with("use ") && yours.contains(line) {
            continue;
        }
        let Some(found) = found(left, line) else {
            let (at, below) = *left.first().unwrap_or(&(yours.lines().count(), ""));
            let is_last = theirs.peek().is_none_or(|it| is_end(it));
            let is_todo = is_last && below.trim() == "todo!()";
            let earlier = found(left, &on_the_first_stair(line)).map(|it| left[it].0);
            return Some(NextLine {
                file,
                above: match earlier {
                    Some(earlier) => earlier,
                    None if is_todo => at,
                    None => above_comments(yours, at),
                },
                text: line.to_owned(),
                is_instead: is_todo || earlier.is_some(),
            });
        };
        left = &left[found + 1..];
    }
    None
}

/// Returns the index of the first line of the comments and attributes above the line `at`.
fn above_comments(yours: &str, at: usize) -> usize {
    let lines: Vec<&str> = yours.lines().take(at).collect();
    let is_above = |line: &&&str| {
        ["///", "#["]
            .iter()
            .any(|it| line.trim_start().starts_with(it))
    };
    at - lines.iter().rev().take_while(is_above).count()
}

/// Returns the index in `left` of the chapter's line `line`, if the reader's function has it: other
/// lines of the reader may stand before it.
fn found(left: &[(usize, &str)], line: &str) -> Option<usize> {
    let end = left.iter().position(|(_, it)| is_end_of_item(it));
    let begun = left.iter().position(|(_, it)| is_begin_of_item(it));
    let end = end.map_or(left.len(), |end| end + 1);
    let is_of_another = is_end_of_item(line) && begun.is_some_and(|begun| begun < end);
    let of_function = &left[..if is_of_another { 0 } else { end }];
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

/// Returns true for a line with which a function or type begins.
fn is_begin_of_item(line: &str) -> bool {
    line.starts_with(char::is_alphabetic)
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
