//! Edits of a function, and what they cost: the fewer words change, the likelier.

use std::ops::Range;

use super::functions::Function;
use super::tree::Tree;

/// A change of a function's text.
#[derive(Clone, Debug)]
pub(super) struct Edit {
    /// What is replaced; an empty place takes what is left out there.
    at: Range<usize>,
    new: String,
    /// The lower, the likelier.
    pub(super) rank: u32,
}

/// A place in a function, and what may be right there.
pub(super) struct Proposal {
    at: Range<usize>,
    new: String,
    /// What makes it less likely than its words say.
    penalty: u32,
    /// Whether an expression or a statement is the chapter's with it: then it may have many words.
    is_whole: bool,
}

impl Proposal {
    pub(super) fn new(at: Range<usize>, new: String, penalty: u32) -> Self {
        Self {
            at,
            new,
            penalty,
            is_whole: false,
        }
    }

    pub(super) fn whole(self) -> Self {
        // A choice is long to read in the place of a value.
        let is_whole = !self.new.contains(" if ");
        Self { is_whole, ..self }
    }
}

impl Edit {
    /// The function with the edit.
    pub(super) fn applied_to(&self, text: &str) -> String {
        let mut text = text.to_owned();
        text.replace_range(self.at.clone(), &self.new);
        text
    }

    /// Whether this function is called less often with it.
    pub(super) fn writes_out(&self, name: &str, text: &str) -> bool {
        let count = |text: &str| words(text).iter().filter(|it| **it == name).count();
        count(&text[self.at.clone()]) > count(&self.new)
    }
}

/// What is the chapter's as a whole costs no more than so many words, and a few for its length.
const MOST: u32 = 3;

/// The edits that are proposed for a function, each with its rank.
pub(super) fn ranked(function: &Function, proposals: Vec<Proposal>) -> Vec<Edit> {
    let edits = proposals.into_iter().filter_map(|it| {
        let apart = words_apart(function.text.get(it.at.clone())?, &it.new);
        let cost = if it.is_whole {
            apart.min(MOST + apart / 8)
        } else {
            apart
        };
        Some(Edit {
            at: it.at,
            new: it.new,
            rank: it.penalty + 2 * cost,
        })
    });
    edits.collect()
}

/// By how many words and signs two texts differ (Levenshtein, 1966). Brackets don't count.
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

pub(super) fn words(text: &str) -> Vec<&str> {
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

/// What an expression is there for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// It is given to a new name.
    Let(String),
    /// It is given to a field or to a name that there was.
    Set(String),
    Condition,
    /// It is a part of a condition.
    Part,
    Result,
    Each,
    Called,
}

/// The expressions that stand for themselves, each with its role.
pub(super) fn roots(tree: &Tree) -> Vec<(Role, &Tree)> {
    let mut roots = Vec::new();
    let op = tree.op.as_str();
    match &tree.parts[..] {
        [value] if op.starts_with("let ") && op.ends_with(';') => {
            let name = op["let ".len()..].trim_start_matches("mut ");
            let name = name.split([' ', ':']).next().unwrap_or_default();
            roots.push((Role::Let(name.to_owned()), value));
        }
        [condition, ..] if op.starts_with("if ") || op.starts_with("while ") => {
            roots.push((Role::Condition, condition));
            let parts = conjuncts(condition).into_iter().skip(1);
            roots.extend(parts.map(|it| (Role::Part, it)));
        }
        [each, _] if op.starts_with("for ") => roots.push((Role::Each, each)),
        [value] if op.starts_with("return") => roots.push((Role::Result, value)),
        [name, value] if op == "□ = □" => {
            let name = name.text();
            let field = name.rsplit('.').next().unwrap_or(&name);
            roots.push((Role::Set(field.to_owned()), value));
        }
        [value] if op.ends_with(": □") => {
            roots.push((Role::Set(op[..op.len() - ": □".len()].to_owned()), value));
        }
        [call] if op == "□;" && call.op.contains('(') => roots.push((Role::Called, call)),
        _ => {}
    }
    if tree.is_block()
        && let Some(last) = tree.parts.last()
        && !["if ", "for ", "return"]
            .iter()
            .any(|it| last.op.starts_with(it))
        && !last.op.ends_with(';')
    {
        roots.push((Role::Result, last));
    }
    roots.extend(tree.parts.iter().flat_map(|part| self::roots(part)));
    roots
}

/// A condition, and the parts of which it is made.
fn conjuncts(condition: &Tree) -> Vec<&Tree> {
    let mut all = vec![condition];
    if let Some("&&" | "||") = condition.sign() {
        all.extend(condition.parts.iter().flat_map(conjuncts));
    }
    all
}
