//! Island parsing: the expressions of a program in any of three languages, and nothing of
//! what stands between them.

use std::ops::Range;

use super::tokens::is_name;

/// What is given to a name, returned, asked or listed.
pub(super) struct Expression<'a> {
    pub(super) name: Option<&'a str>,
    pub(super) at: Range<usize>,
}

/// Each expression of the program; in Python a statement ends with its line.
pub(super) fn expressions(text: &str, is_python: bool) -> Vec<Expression<'_>> {
    let ends = |at: usize, depth: i32| match text.as_bytes()[at] {
        b';' | b'{' | b'}' => true,
        b'\n' => is_python && depth == 0,
        _ => false,
    };
    let mut found = Vec::new();
    for statement in split(text, 0..text.len(), &ends) {
        add(text, statement, &mut found);
    }
    found
}

/// The parts of a stretch between bytes that end them, which may be inside of brackets.
fn split(
    text: &str,
    stretch: Range<usize>,
    ends: &dyn Fn(usize, i32) -> bool,
) -> Vec<Range<usize>> {
    let (mut depth, mut start, mut at) = (0, stretch.start, stretch.start);
    let mut parts = Vec::new();
    while at < stretch.end {
        let rest = &text[at..];
        if rest.starts_with("//") || rest.starts_with('#') {
            at += rest.find('\n').unwrap_or(rest.len());
            continue;
        }
        depth += i32::from(rest.starts_with(['(', '['])) - i32::from(rest.starts_with([')', ']']));
        if ends(at, depth) {
            parts.push(start..at);
            start = at + 1;
            depth = depth.min(0);
        }
        at += rest.chars().next().map_or(1, char::len_utf8);
    }
    parts.push(start..stretch.end);
    parts
}

/// Words before an expression.
const BEFORE: [&str; 13] = [
    "return", "let", "mut", "auto", "const", "double", "else", "if", "elif", "not", "while", "and",
    "or",
];

/// What stands between two, beside a colon.
const BETWEEN: [&str; 8] = [",", "?", " if ", " else ", "&&", "||", " and ", " or "];

/// The expressions of a stretch: of a choice, of arguments and of a list each for itself.
fn add<'a>(text: &'a str, stretch: Range<usize>, found: &mut Vec<Expression<'a>>) {
    let is = |at: usize, sign: &str| text.get(at..).is_some_and(|rest| rest.starts_with(sign));
    let ends = |at: usize, depth: i32| {
        let is_colon = is(at, ":") && !is(at + 1, ":") && !text[..at].ends_with(':');
        depth == 0 && (is_colon || BETWEEN.iter().any(|word| is(at, word)))
    };
    for part in split(text, stretch, &ends) {
        let skipped = text[part.clone()].find(|c| !" &|".contains(c)).unwrap_or(0);
        let mut part = trimmed(text, part.start + skipped..part.end);
        let word = |part: &Range<usize>| {
            let first = text[part.clone()].split(|c: char| !c.is_alphanumeric() && c != '_');
            first.into_iter().next().filter(|it| BEFORE.contains(it))
        };
        while let Some(word) = word(&part) {
            part = trimmed(text, part.start + word.len()..part.end);
        }
        if let Some(end) = bracketed(text, &part) {
            let rest = trimmed(text, end..part.end);
            let goes_on = text[rest.clone()].starts_with(|c: char| c.is_alphabetic());
            if rest.is_empty() || goes_on && !rest.is_empty() {
                add(text, part.start + 1..end - 1, found);
                add(text, rest, found);
                continue;
            }
        }
        // What a function is given is nothing that it says.
        if text[part.clone()].starts_with("def ") {
            continue;
        }
        let (name, mut value) = given(text, part);
        let is_list = text[value.clone()].starts_with('[');
        if is_list && bracketed(text, &value) == Some(value.end) {
            add(text, value.start + 1..value.end - 1, found);
        }
        if text[value.clone()].starts_with("Some(") && text[value.clone()].ends_with(')') {
            value = value.start + "Some(".len()..value.end - 1;
        }
        if !value.is_empty() {
            found.push(Expression { name, at: value });
        }
    }
}

fn trimmed(text: &str, part: Range<usize>) -> Range<usize> {
    let part_text = &text[part.clone()];
    let start = part.start + part_text.len() - part_text.trim_start().len();
    start..start.max(part.start + part_text.trim_end().len())
}

/// Where the bracket is closed that the stretch begins with.
fn bracketed(text: &str, part: &Range<usize>) -> Option<usize> {
    let mut depth = 0;
    let mut letters = text[part.clone()].char_indices();
    let starts = text[part.clone()].starts_with(['(', '[']);
    let (end, _) = letters.find(|(_, letter)| {
        depth += i32::from("([".contains(*letter)) - i32::from(")]".contains(*letter));
        depth == 0
    })?;
    starts.then_some(part.start + end + 1)
}

/// The name that is given something, if one is, and what it is given.
fn given(text: &str, part: Range<usize>) -> (Option<&str>, Range<usize>) {
    let own = &text[part.clone()];
    let mut depth = 0;
    let mut letters = own.char_indices();
    let equals = letters.find(|(at, letter)| {
        depth += i32::from("([".contains(*letter)) - i32::from(")]".contains(*letter));
        let is_part = |at: usize| {
            own[..at].ends_with(['=', '<', '>', '!', '+', '-', '*', '/'])
                || own[at + 1..].starts_with('=')
        };
        depth == 0 && *letter == '=' && !is_part(*at)
    });
    let Some((at, _)) = equals else {
        return (None, part);
    };
    let before = own[..at].trim_end();
    let start = before.rfind(|c: char| !c.is_alphanumeric() && c != '_');
    let name = &before[start.map_or(0, |start| start + 1)..];
    let value = trimmed(text, part.start + at + 1..part.end);
    (Some(name).filter(|name| is_name(name)), value)
}
