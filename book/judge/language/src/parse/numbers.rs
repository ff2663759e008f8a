//! Type inference, as far as a quotient needs it: whether a value is a whole number.

use std::collections::HashSet;

use super::{Parser, is_keyword};
use crate::normal::{REAL, WHOLE, is_in};
use crate::tokens::{Token, TokenKind};
use crate::tree::{Op, Tree};

impl Parser<'_> {
    /// Returns true if a value is a whole number in a language that divides these as such.
    pub(super) fn is_whole(&self, tree: &Tree) -> bool {
        match &tree.op {
            Op::Number(_, is_whole) => self.language.divides_whole_numbers() && *is_whole,
            Op::Name(name) => self.whole.contains(name.as_str()),
            Op::Call(name) => match &tree.parts[..] {
                [of] if of.name().is_some() && self.whole.contains(name.as_str()) => true,
                _ => is_in(WHOLE, name),
            },
            Op::Negative => self.is_whole(&tree.parts[0]),
            Op::Operator("+" | "-" | "*" | "//" | "%") => {
                tree.parts.iter().all(|it| self.is_whole(it))
            }
            _ => false,
        }
    }
}

/// Reads a decimal number without its `_`, up to the suffix of its type, which begins with the
/// first letter other than `e`; `None` if that is no number.
pub(super) fn number(text: &str) -> Option<Op> {
    let digits: String = text.chars().filter(|c| *c != '_').collect();
    let is_suffix = |c: char| c.is_ascii_alphabetic() && !"eE".contains(c);
    let digits = match digits.find(is_suffix) {
        Some(end) => &digits[..end],
        None => &digits,
    };
    let is_real = text.contains(['.', 'f']) || digits.contains(['e', 'E']);
    Some(Op::Number(digits.parse().ok()?, !is_real))
}

/// Finds the variables that a text declares as whole numbers: by a type before or behind the name,
/// or by a whole number as its value.
pub(super) fn whole_numbers<'a>(tokens: &[Token<'a>]) -> HashSet<&'a str> {
    let is_type = |it: &Token| is_in(WHOLE, it.text);
    let is_name = |it: &Token| it.kind == TokenKind::Word && !is_keyword(it.text);
    let is_whole = |it: &Token| {
        it.kind == TokenKind::Number && matches!(number(it.text), Some(Op::Number(_, true)))
    };
    let names = tokens.windows(4).filter_map(|four| match four {
        [of, name, ..] if is_type(of) && is_name(name) && !is_type(name) => Some(name.text),
        [name, colon, of, _] if colon.text == ":" && is_type(of) => Some(name.text),
        [name, of, ..] if is_name(name) && is_type(of) && !is_type(name) => Some(name.text),
        [name, sign, value, end]
            if matches!(sign.text, "=" | ":=")
                && is_whole(value)
                && (end.text == ";" || end.is_first) =>
        {
            Some(name.text)
        }
        _ => None,
    });
    // A name that is declared as a real number elsewhere is left out.
    let reals: HashSet<&str> = tokens
        .windows(2)
        .filter(|two| is_in(REAL, two[0].text) && is_name(&two[1]))
        .map(|two| two[1].text)
        .collect();
    names.filter(|it| !reals.contains(it)).collect()
}
