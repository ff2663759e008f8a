//! Line diff: finds the first line of a chapter that a reader's draft lacks.

use course::typed::on_the_first_stair;
use interpreter::SourceFile;

use crate::typed::Draft;
use crate::words::{replaced, words};

/// The first line of a chapter that a reader's draft lacks, and its place in the draft.
#[derive(Debug, PartialEq, Eq)]
pub struct NextLine {
    /// The index in [`Draft::files`], from 0, of the file that lacks the line.
    pub file: usize,
    /// The index, from 0, of the draft's line above which the missing line goes.
    pub above: usize,
    /// The line itself, indented as in the chapter and with the reader's own names, without an end
    /// of line.
    pub text: String,
    /// True if the missing line replaces the line at `above`, which is a `todo!()` or its own
    /// beginning; false if it is inserted.
    pub replaces: bool,
}

/// What a draft lacks of its chapter.
#[derive(Debug, PartialEq, Eq)]
pub enum Lack {
    /// The draft lacks this line.
    Line(NextLine),
    /// The draft has every line of the chapter.
    Nothing,
    /// A function of the draft has other lines than the chapter's, so that no line of the chapter
    /// belongs into it.
    Unknown,
}

/// Finds the first line of the chapter that the draft lacks. The search begins in the function with
/// the caret, which stands in a line, counted from 1, of the file with an index from 0. Where no
/// function is, it begins in that file. It goes on through all functions, from the first one on.
///
/// Functions are compared by their names, and line by line: comments and blanks do not count, nor
/// does `return` in front of a result. A `let` is known by its name; if both the chapter and the
/// reader have names that the other lacks, these belong together in their order. In chapter 5 a
/// draft without a trait is compared with the chapter on its first stair.
pub fn next(yours: &Draft, (file, line): (usize, usize)) -> Lack {
    let has_trait = |file: &SourceFile| file.text.contains("trait Hittable");
    let mut theirs = Draft::complete(yours.chapter).files;
    if !yours.files.iter().any(has_trait) {
        for file in &mut theirs {
            file.text = on_the_first_stair(&file.text);
        }
    }
    let files = yours.files.iter().zip(&theirs).enumerate();
    let mut functions: Vec<_> = files
        .flat_map(|(n, (yours, theirs))| {
            let yours = bodies(&yours.text);
            bodies(&theirs.text).into_iter().map(move |theirs| {
                let yours = yours.iter().find(|it| it.name == theirs.name);
                (n, theirs, yours.cloned())
            })
        })
        .collect();
    let has_caret = |yours: &Body| (yours.head + 1..=yours.end + 1).contains(&line);
    let here = functions
        .iter()
        .position(|(n, _, it)| *n == file && it.as_ref().is_some_and(has_caret));
    let here = here.or_else(|| functions.iter().position(|(n, ..)| *n == file));
    functions.rotate_left(here.unwrap_or(0));
    let mut lack = Lack::Nothing;
    for (file, theirs, yours) in functions {
        match yours.map_or(Lack::Unknown, |yours| missing(file, &theirs, &yours)) {
            Lack::Nothing => {}
            Lack::Unknown => lack = Lack::Unknown,
            line => return line,
        }
    }
    lack
}

/// A function, as the lines of its body.
#[derive(Clone)]
struct Body<'a> {
    /// The line of the `fn`, up to the first bracket.
    name: &'a str,
    /// The index of that line, from 0.
    head: usize,
    /// The lines that are not empty and no comment, with their index in the file, from 0.
    lines: Vec<(usize, &'a str)>,
    /// The index of the line with the brace that ends the function.
    end: usize,
}

/// Returns the functions of a file that have a body, in the order of the text.
fn bodies(text: &str) -> Vec<Body<'_>> {
    let lines: Vec<&str> = text.lines().map(str::trim_end).collect();
    let body = |head: usize| {
        let name = lines[head].trim_start();
        let indent = lines[head].len() - name.len();
        let rest = || head..lines.len();
        let open = rest().find(|&n| lines[n].ends_with(['{', ';']))?;
        let end = rest().find(|&n| lines[n] == format!("{:indent$}}}", ""))?;
        let is_code = |&n: &usize| !lines[n].is_empty() && !is_comment(lines[n]);
        lines[open].ends_with('{').then(|| Body {
            name: name.split('(').next().unwrap_or(name),
            head,
            lines: (open + 1..end)
                .filter(is_code)
                .map(|n| (n, lines[n]))
                .collect(),
            end,
        })
    };
    let is_head = |line: &str| words(line).iter().any(|(_, it)| *it == "fn");
    let heads = (0..lines.len()).filter(|&n| is_head(lines[n]));
    heads.filter_map(body).collect()
}

/// Finds the first line of the chapter's function `theirs` that the reader's function lacks.
fn missing(file: usize, theirs: &Body, yours: &Body) -> Lack {
    let renamed = renamed(theirs, yours);
    let mut lack = None;
    // The numbers of the reader's lines that belong to one of the chapter's, and how many lines
    // stand up to the last of them.
    let (mut known, mut after) = (Vec::new(), 0);
    for (n, (_, line)) in theirs.lines.iter().enumerate() {
        let text = with_names(line, &renamed);
        let found = yours.find(&text, after);
        known.extend(found);
        match found {
            Some(at) if !is_begun(yours.lines[at].1, &text) => after = after.max(at + 1),
            _ if lack.is_some() => {}
            _ => {
                let at = found.unwrap_or(after);
                let &(above, below) = yours.lines.get(at).unwrap_or(&(yours.end, ""));
                let mut rest = theirs.lines[n + 1..].iter();
                let is_last =
                    rest.all(|(_, line)| yours.find(&with_names(line, &renamed), at).is_some());
                lack = Some(NextLine {
                    file,
                    above,
                    text,
                    replaces: found.is_some() || is_last && is_todo(below),
                });
            }
        }
    }
    let mut lines = yours.lines.iter().enumerate();
    let all_known =
        lines.all(|(n, (_, line))| known.contains(&n) || is_todo(line) || bound(line).is_some());
    match lack {
        Some(line) if all_known => Lack::Line(line),
        Some(_) => Lack::Unknown,
        None => Lack::Nothing,
    }
}

impl Body<'_> {
    /// Returns the number of the line that says the same as one of the chapter's, or begins it:
    /// wherever it gives a value to the same name, or else at or behind the line number `after`.
    fn find(&self, text: &str, after: usize) -> Option<usize> {
        let is_it = |(n, (_, line)): (usize, &(usize, &str))| match bound(text) {
            Some(name) => bound(line) == Some(name),
            None => n >= after && (is_same(line, text) || is_begun(line, text)),
        };
        self.lines.iter().enumerate().position(is_it)
    }
}

/// Pairs the names that only the chapter's function gives to values with those that only the
/// reader's gives, in their order.
fn renamed<'a>(theirs: &'a Body, yours: &'a Body) -> Vec<(&'a str, &'a str)> {
    let names = |body: &'a Body| body.lines.iter().filter_map(|&(_, it)| bound(it));
    let only = |one: &'a Body, other: &'a Body| {
        let others: Vec<&str> = names(other).collect();
        names(one).filter(move |it| !others.contains(it))
    };
    only(theirs, yours).zip(only(yours, theirs)).collect()
}

/// Returns the line with the second name of each pair in the place of the first; fields keep theirs.
fn with_names(line: &str, renamed: &[(&str, &str)]) -> String {
    replaced(line, |before, word| {
        let pair = renamed.iter().find(|(old, _)| *old == word)?;
        (!before.ends_with('.')).then_some(pair.1)
    })
}

/// Returns the name to which the line gives a value by `let`.
fn bound(line: &str) -> Option<&str> {
    let rest = line.trim_start().strip_prefix("let ")?.trim_start();
    let rest = rest.strip_prefix("mut ").unwrap_or(rest);
    words(rest).first().map(|(_, name)| *name)
}

/// Returns true if both lines say the same. The indentation of a brace says of what it is the end.
fn is_same(yours: &str, theirs: &str) -> bool {
    match theirs.trim_start().starts_with('}') {
        true => yours == theirs,
        false => squeezed(yours) == squeezed(theirs),
    }
}

/// Returns true if the reader's line is only the beginning of the chapter's.
fn is_begun(yours: &str, theirs: &str) -> bool {
    let (yours, theirs) = (squeezed(yours), squeezed(theirs));
    !["", "}"].contains(&&*yours) && yours != theirs && theirs.starts_with(&yours)
}

/// Returns the line without blanks and comment, without `return` in front and without a semicolon
/// behind it.
fn squeezed(line: &str) -> String {
    let line = line.split("//").next().unwrap_or(line).trim();
    let result = line.strip_prefix("return ").unwrap_or(line);
    let result = result.strip_suffix(';').unwrap_or(result);
    result.split_whitespace().collect()
}

/// Returns true for a line that a reader has not written yet.
fn is_todo(line: &str) -> bool {
    line.trim() == "todo!()"
}

/// Returns true for a comment.
fn is_comment(line: &str) -> bool {
    line.trim_start().starts_with("//")
}
