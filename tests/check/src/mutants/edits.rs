//! Mutation operators: each place of a text, and what somebody might have typed instead.

use std::collections::{BTreeSet, HashSet};
use std::ops::Range;

use super::syntax::{Token, tokens};
use crate::sources::Variant;

/// A text with one place changed.
pub(super) struct Edit {
    pub(super) text: String,
    /// The line that was changed, before and after.
    pub(super) wrong: String,
    pub(super) right: String,
}

/// What else may stand where one of these does.
const ALIKE: [&[&str]; 10] = [
    &["+", "-", "*", "/"],
    &["<", ">", "<=", ">="],
    &["&&", "||"],
    &["x", "y", "z"],
    &["length_squared", "length"],
    &["origin", "direction"],
    &["point", "normal"],
    &["t_min", "t_max", "closest_so_far"],
    &["true", "false"],
    &["sqrt", "abs"],
];
/// Numbers that people type.
const NUMBERS: [&str; 7] = ["2.0", "1.0", "0.5", "4.0", "0.0", "10.0", "0.1"];

/// Every text that is one edit away, what is typed most often first.
pub(super) fn of(text: &str) -> Vec<Edit> {
    let all = tokens(text);
    let body = body(&all);
    let mut edits = Vec::new();
    let places = body..all.len();
    edits.extend(places.clone().flat_map(|n| missing(&all, text, n)));
    edits.extend(swaps(text, &all[body..]));
    edits.extend(dropped_lines(text));
    edits.extend(places.clone().flat_map(|n| alike(&all[n])));
    edits.extend(places.clone().flat_map(|n| numbers(&all[n])));
    edits.extend(places.flat_map(|n| added(&all, text, n)));
    made(text, edits)
}

/// The texts in which one name stands for another.
pub(super) fn of_names(text: &str) -> Vec<Edit> {
    made(text, other_names(&tokens(text), text))
}

/// The texts in which a vector's components have changed: another letter, or another sign.
pub(super) fn of_components(text: &str) -> Vec<Edit> {
    let all = tokens(text);
    let names = variables(&all);
    let is_whole = |n: &usize| {
        let is_point = |at: usize| all.get(at).is_some_and(|it| it.text == ".");
        names.contains(all[*n].text) && !is_point(n - 1) && !is_point(n + 1)
    };
    let whole = (body(&all)..all.len()).filter(is_whole);
    made(
        text,
        whole.flat_map(|n| other_components(&all[n])).collect(),
    )
}

/// The token with which the body begins.
fn body(all: &[Token]) -> usize {
    all.iter().position(|it| it.text == "{").unwrap_or(0) + 1
}

fn made(text: &str, changes: Vec<Change>) -> Vec<Edit> {
    let mut seen = HashSet::from([text.to_owned()]);
    let edits = changes.into_iter();
    let edits = edits.map(|(at, with)| Edit::new(text, at, &with));
    edits
        .filter(|edit| seen.insert(edit.text.clone()))
        .collect()
}

/// A place in a text and what comes there.
type Change = (Range<usize>, String);

/// Names that are declared somewhere in the function.
fn variables<'a>(all: &[Token<'a>]) -> BTreeSet<&'a str> {
    let declared = |pair: &[Token<'a>]| match (pair[0].text, pair[1].text) {
        ("let" | "mut" | "for", name) if name != "mut" && name != "Some" => Some(name),
        (name, ":") => Some(name),
        _ => None,
    };
    let is_name = |name: &&str| name.starts_with(|c: char| c.is_ascii_lowercase());
    all.windows(2)
        .filter_map(declared)
        .filter(is_name)
        .collect()
}

/// What else may stand for a sign or a letter.
fn alike(token: &Token) -> Vec<Change> {
    let some = ALIKE.iter().find(|some| some.contains(&token.text));
    let others = some.into_iter().flat_map(|some| some.iter());
    others
        .map(|it| (token.at.clone(), (*it).to_owned()))
        .collect()
}

/// What else may stand for a number.
fn numbers(token: &Token) -> Vec<Change> {
    let is_number = token.text.starts_with(|c: char| c.is_ascii_digit());
    let others = NUMBERS.iter().filter(|_| is_number);
    others
        .map(|it| (token.at.clone(), (*it).to_owned()))
        .collect()
}

/// Names for each other, and for what a ray has.
fn other_names(all: &[Token], text: &str) -> Vec<Change> {
    let names = variables(all);
    let is = |n: usize, some: &[&str]| all.get(n).is_some_and(|it| some.contains(&it.text));
    let part = |n: usize| match is(n + 1, &["."]) && is(n + 2, &["origin", "direction"]) {
        true => n + 2,
        false => n,
    };
    let own = |n: usize| all[n].at.start..all[part(n)].at.end;
    let places =
        (body(all)..all.len()).filter(|&n| names.contains(all[n].text) && !is(n - 1, &["."]));
    let places: Vec<usize> = places.collect();
    let parts = places
        .iter()
        .filter(|&&n| part(n) > n)
        .map(|&n| &text[own(n)]);
    let others: BTreeSet<&str> = parts.chain(names.iter().copied()).collect();
    let other = |n: &usize| {
        let own = own(*n);
        others
            .iter()
            .map(move |it| (own.clone(), (*it).to_owned()))
            .collect::<Vec<_>>()
    };
    places.iter().flat_map(other).collect()
}

/// Whether an operand begins after it.
fn is_before_operand(text: &str) -> bool {
    is_operator(text) || matches!(text, "=" | "(" | "," | "return" | ";" | "{")
}

fn is_operator(text: &str) -> bool {
    matches!(text, "+" | "-" | "*" | "/")
}

/// The operand that begins at a token: its last token.
fn operand_at(all: &[Token], n: usize) -> Option<usize> {
    let token = all[n].text;
    let begins = token.starts_with(|c: char| c.is_alphanumeric()) || token == "(";
    (begins && is_before_operand(all[n - 1].text)).then(|| operand(all, n))
}

/// What may be missing at a token: a sign, a term, a factor, brackets, a call.
fn missing(all: &[Token], text: &str, n: usize) -> Vec<Change> {
    let token = &all[n];
    let before = all[n - 1].text;
    let text_at = |n: usize| all.get(n).map_or("", |it| it.text);
    let mut changes = Vec::new();
    let mut drop = |at: Range<usize>| changes.push((at, String::new()));
    if let Some(end) = operand_at(all, n) {
        for end in [end, term(all, end)] {
            if is_operator(text_at(end + 1)) {
                drop(token.at.start..all[end + 2].at.start);
            }
            if is_operator(before) {
                drop(all[n - 1].at.start..all[end].at.end);
            }
        }
    }
    if token.text == "-" && is_before_operand(before) {
        drop(token.at.clone());
    }
    let is_call = |name| token.text == "." && text_at(n + 1) == name;
    if ["sqrt", "normalize"].into_iter().any(is_call) {
        drop(token.at.start..all[n + 3].at.end);
    }
    if token.text == "(" && is_before_operand(before) {
        let close = closing(all, n);
        let inside = token.at.end..all[close].at.start;
        changes.push((token.at.start..all[close].at.end, text[inside].to_owned()));
    }
    changes
}

/// What may be too much, or otherwise, at a token.
fn added(all: &[Token], text: &str, n: usize) -> Vec<Change> {
    let token = &all[n];
    let before = all[n - 1].text;
    let mut changes = Vec::new();
    if let Some(end) = operand_at(all, n) {
        let whole = token.at.start..all[end].at.end;
        let own = &text[whole.clone()];
        let mut instead = |with: String| changes.push((whole.clone(), with));
        instead(format!("(-{own})"));
        instead(format!("(1.0 - {own})"));
        if before == "=" {
            instead(format!("2.0 * {own}"));
            instead(format!("0.5 * {own}"));
        }
        for method in ["sqrt", "abs", "normalize"] {
            instead(format!("{own}.{method}()"));
        }
        instead(format!("{own} * {own}"));
    }
    if token.text == "normalize" {
        // The length without its root.
        let start = (0..n)
            .rfind(|&it| is_before_operand(all[it].text))
            .unwrap_or(0)
            + 1;
        let own = &text[all[start].at.start..all[n - 2].at.end];
        let whole = all[start].at.start..all[n + 2].at.end;
        changes.push((whole, format!("(1.0 / {own}.length_squared()) * {own}")));
    }
    if token.text == "ONE" {
        let one = all[n - 2].at.start..token.at.end;
        for parts in ["0.0, 1.0, 1.0", "1.0, 0.0, 1.0", "1.0, 1.0, 0.0"] {
            changes.push((one.clone(), format!("Vec3::new({parts})")));
        }
    }
    if token.text == "new" && all.get(n + 1).is_some_and(|it| it.text == "(") {
        changes.extend(other_orders(text, all, n + 1));
    }
    if before == "if" && token.text != "let" {
        let brace = (n..all.len())
            .find(|&it| all[it].text == "{")
            .unwrap_or(n + 1);
        let whole = token.at.start..all[brace - 1].at.end;
        changes.push((whole.clone(), format!("!({})", &text[whole])));
    }
    changes
}

/// Three arguments in each other order, or one of them copied.
fn other_orders(text: &str, all: &[Token], open: usize) -> Vec<Change> {
    let inside = &all[open + 1..closing(all, open)];
    let mut depth = 0;
    let parts: Vec<&[Token]> = inside
        .split(|token| {
            depth += i32::from(token.text == "(") - i32::from(token.text == ")");
            depth == 0 && token.text == ","
        })
        .collect();
    let range = |part: &[Token]| Some(part.first()?.at.start..part.last()?.at.end);
    let ranges: Option<Vec<Range<usize>>> = parts.into_iter().map(range).collect();
    let Some([x, y, z]) = ranges.and_then(|it| <[_; 3]>::try_from(it).ok()) else {
        return Vec::new();
    };
    let whole = x.start..z.end;
    let [x, y, z] = [x, y, z].map(|at| &text[at]);
    let orders = [[x, z, y], [y, x, z], [y, z, x], [z, x, y], [z, y, x]];
    let copies = [
        [x, x, z],
        [x, y, y],
        [x, y, x],
        [x, z, z],
        [y, y, z],
        [z, y, z],
    ];
    let parts = orders.into_iter().chain(copies);
    parts
        .map(|parts| (whole.clone(), parts.join(", ")))
        .collect()
}

/// A vector of other components, or with another sign.
fn other_components(token: &Token) -> Vec<Change> {
    let mut changes = Vec::new();
    let letters = ["x", "y", "z"];
    let name = token.text;
    for x in letters {
        for y in letters {
            for z in letters {
                let vector = format!("Vec3::new({name}.{x}, {name}.{y}, {name}.{z})");
                changes.push((token.at.clone(), vector));
            }
        }
    }
    for turned in letters {
        let signed = letters.map(|it| match it == turned {
            true => format!("-{name}.{it}"),
            false => format!("{name}.{it}"),
        });
        changes.push((
            token.at.clone(),
            format!("Vec3::new({})", signed.join(", ")),
        ));
    }
    changes
}

/// The last token of the operand that begins at `n`: a name with its members, or brackets.
fn operand(all: &[Token], n: usize) -> usize {
    let mut end = match all[n].text {
        "(" => closing(all, n),
        "-" if n + 1 < all.len() => return operand(all, n + 1),
        _ => n,
    };
    while let Some(next) = all.get(end + 1) {
        end = match next.text {
            "." | "::" => end + 2,
            "(" => closing(all, end + 1),
            _ => break,
        };
    }
    end.min(all.len() - 1)
}

/// The last token of the term whose first factor ends at `end`.
fn term(all: &[Token], mut end: usize) -> usize {
    let is_factor = |end: usize| {
        all.get(end + 1)
            .is_some_and(|it| matches!(it.text, "*" | "/"))
    };
    while is_factor(end) && end + 2 < all.len() {
        end = operand(all, end + 2);
    }
    end
}

/// The bracket that closes the one at `n`.
fn closing(all: &[Token], n: usize) -> usize {
    let mut depth = 0;
    let mut rest = all.iter().enumerate().skip(n);
    let end = rest.find(|(_, token)| {
        depth += i32::from(token.text == "(") - i32::from(token.text == ")");
        depth == 0
    });
    end.map_or(all.len() - 1, |(at, _)| at)
}

/// Two operands, terms or arguments that have changed places.
fn swaps(text: &str, all: &[Token]) -> Vec<Change> {
    let begins = |at: usize| {
        let first = |c: char| c.is_alphanumeric() || c == '(' || c == '-';
        all.get(at).is_some_and(|it| it.text.starts_with(first))
    };
    let is_start = |n: usize| {
        let before = all[n - 1].text;
        let is_start = is_before_operand(before) && !matches!(before, "-" | "/") || before == "|";
        is_start && begins(n)
    };
    let mut changes = Vec::new();
    for n in (1..all.len()).filter(|&n| is_start(n)) {
        let end = operand(all, n);
        for (end, is_term) in [(end, false), (term(all, end), true)] {
            let between = all.get(end + 1).map_or("", |it| it.text);
            if !matches!(between, "," | "-" | "/") || !begins(end + 2) {
                continue;
            }
            let last = operand(all, end + 2);
            let last = if is_term { term(all, last) } else { last };
            let one = all[n].at.start..all[end].at.end;
            let other = all[end + 2].at.start..all[last].at.end;
            let middle = &text[one.end..other.start];
            let swapped = format!("{}{middle}{}", &text[other.clone()], &text[one.clone()]);
            changes.push((one.start..other.end, swapped));
        }
    }
    changes
}

/// A line that is a statement of its own, and is not there.
fn dropped_lines(text: &str) -> Vec<Change> {
    let mut at = 0;
    let mut changes = Vec::new();
    for line in text.split_inclusive('\n') {
        let trimmed = line.trim();
        if trimmed.ends_with(';') && !trimmed.starts_with("let") && !trimmed.starts_with("return") {
            let start = at + line.len() - line.trim_start().len();
            changes.push((start..start + trimmed.len(), String::new()));
        }
        at += line.len();
    }
    changes
}

impl Edit {
    /// An expression of the reader's in the text.
    pub(super) fn from(text: &str, variant: Variant) -> Self {
        let mut changed = text.to_owned();
        changed.replace_range(variant.at, &variant.with);
        Self {
            text: changed,
            wrong: variant.wrong,
            right: variant.right,
        }
    }

    fn new(text: &str, at: Range<usize>, with: &str) -> Self {
        let mut changed = text.to_owned();
        changed.replace_range(at.clone(), with);
        let start = text[..at.start].rfind('\n').map_or(0, |end| end + 1);
        let end = text[at.end..]
            .find('\n')
            .map_or(text.len(), |it| at.end + it);
        let right = said(&text[start..end]);
        let wrong = said(&changed[start..end + with.len() - at.len()]);
        Self {
            text: changed,
            wrong: match wrong.is_empty() {
                true => format!("without {right}"),
                false => wrong,
            },
            right,
        }
    }
}

/// The line without what Rust alone needs.
fn said(line: &str) -> String {
    let line = line.split_whitespace().collect::<Vec<_>>().join(" ");
    let line = line.trim_start_matches("let ").trim_start_matches("mut ");
    line.trim_end_matches([';', ',', '{']).trim().to_owned()
}
