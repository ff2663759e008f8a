//! Mutation operators: each place of a text, and what somebody might have typed instead.

use std::collections::HashSet;
use std::ops::Range;

use super::syntax::{Token, tokens};

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
const NUMBERS: [&str; 7] = ["0.0", "0.5", "1.0", "2.0", "4.0", "0.1", "10.0"];

/// Every text that is one edit away.
pub(super) fn of(text: &str) -> Vec<Edit> {
    let all = tokens(text);
    let body = all.iter().position(|it| it.text == "{").unwrap_or(0) + 1;
    let names = variables(&all);
    let mut edits = Vec::new();
    for n in body..all.len() {
        let token = &all[n];
        let at = token.at.clone();
        let replace = |with: &str| (at.clone(), with.to_owned());
        let alike = ALIKE.iter().find(|some| some.contains(&token.text));
        edits.extend(
            alike
                .into_iter()
                .flat_map(|some| some.iter())
                .map(|it| replace(it)),
        );
        if token.text.starts_with(|c: char| c.is_ascii_digit()) {
            edits.extend(NUMBERS.iter().map(|it| replace(it)));
        }
        if names.contains(token.text) && all[n - 1].text != "." {
            edits.extend(names.iter().map(|it| replace(it)));
        }
        edits.extend(around(text, &all, &names, n));
    }
    edits.extend(swaps(text, &all[body..]));
    edits.extend(dropped_lines(text));
    let mut seen = HashSet::from([text.to_owned()]);
    let made = edits
        .into_iter()
        .map(|(at, with)| Edit::new(text, at, &with));
    made.filter(|edit| seen.insert(edit.text.clone())).collect()
}

/// A place in a text and what comes there.
type Change = (Range<usize>, String);

/// Names that are declared somewhere in the function.
fn variables<'a>(all: &[Token<'a>]) -> HashSet<&'a str> {
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

/// What may be missing or too much at a token: a sign, brackets, a call, a factor.
fn around(text: &str, all: &[Token], names: &HashSet<&str>, n: usize) -> Vec<Change> {
    let token = &all[n];
    let mut changes = Vec::new();
    let begins = |text: &str| text.starts_with(|c: char| c.is_alphanumeric()) || text == "(";
    let is_operator =
        |text: &str| matches!(text, "+" | "-" | "*" | "/" | "=" | "(" | "," | "return");
    let before = all[n - 1].text;
    if begins(token.text) && is_operator(before) {
        let end = operand(all, n);
        let whole = token.at.start..all[end].at.end;
        let own = &text[whole.clone()];
        changes.push((whole.clone(), format!("(-{own})")));
        changes.push((whole.clone(), format!("(1.0 - {own})")));
        for method in ["sqrt", "abs", "normalize"] {
            changes.push((whole.clone(), format!("{own}.{method}()")));
        }
        changes.push((whole.clone(), format!("{own} * {own}")));
        let next = all.get(end + 1).map_or("", |it| it.text);
        if matches!(next, "+" | "-" | "*" | "/") {
            changes.push((token.at.start..all[end + 2].at.start, String::new()));
        }
        if matches!(before, "+" | "-" | "*" | "/") {
            changes.push((all[n - 1].at.start..whole.end, String::new()));
        }
    }
    if names.contains(token.text) && before != "." {
        changes.extend(other_components(token));
    }
    if token.text == "normalize" {
        // The length without its root.
        let start = (0..n).rfind(|&it| is_operator(all[it].text)).unwrap_or(0) + 1;
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
        changes.extend(other_orders(text, all, n + 2));
    }
    if before == "if" && token.text != "let" {
        let brace = (n..all.len())
            .find(|&it| all[it].text == "{")
            .unwrap_or(n + 1);
        let whole = token.at.start..all[brace - 1].at.end;
        changes.push((whole.clone(), format!("!({})", &text[whole])));
    }
    if token.text == "-" && is_operator(before) {
        changes.push((token.at.clone(), String::new()));
    }
    if token.text == "(" && is_operator(before) {
        let close = closing(all, n);
        let inside = token.at.end..all[close].at.start;
        changes.push((token.at.start..all[close].at.end, text[inside].to_owned()));
    }
    let is_call = |name| token.text == "." && all.get(n + 1).is_some_and(|it| it.text == name);
    if ["sqrt", "normalize"].into_iter().any(is_call) {
        changes.push((token.at.start..all[n + 3].at.end, String::new()));
    }
    changes
}

/// Three arguments in each other order.
fn other_orders(text: &str, all: &[Token], first: usize) -> Vec<Change> {
    let second = operand(all, first) + 2;
    let third = operand(all, second.min(all.len() - 1)) + 2;
    if third >= all.len() {
        return Vec::new();
    }
    let [x, y, z] =
        [first, second, third].map(|n| &text[all[n].at.start..all[operand(all, n)].at.end]);
    let whole = all[first].at.start..all[operand(all, third)].at.end;
    [[x, z, y], [y, x, z], [y, z, x], [z, x, y], [z, y, x]]
        .into_iter()
        .map(|parts| (whole.clone(), parts.join(", ")))
        .collect()
}

/// A vector whose components have changed: another letter, or another sign.
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

/// Two operands, or two arguments, that have changed places.
fn swaps(text: &str, all: &[Token]) -> Vec<Change> {
    let mut changes = Vec::new();
    for n in 1..all.len().saturating_sub(1) {
        let begins = |at: usize| {
            let first = |c: char| c.is_alphanumeric() || c == '(' || c == '-';
            all[at].text.starts_with(first)
        };
        if !matches!(
            all[n - 1].text,
            "(" | "," | "=" | "return" | "+" | "*" | "|"
        ) || !begins(n)
        {
            continue;
        }
        let end = operand(all, n);
        let Some(between) = all
            .get(end + 1)
            .filter(|it| matches!(it.text, "," | "-" | "/"))
        else {
            continue;
        };
        if end + 2 >= all.len() || !begins(end + 2) {
            continue;
        }
        let other = all[end + 2].at.start..all[operand(all, end + 2)].at.end;
        let one = all[n].at.start..all[end].at.end;
        let middle = &text[one.end..other.start];
        debug_assert!(middle.contains(between.text));
        let swapped = format!("{}{middle}{}", &text[other.clone()], &text[one.clone()]);
        changes.push((one.start..other.end, swapped));
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
