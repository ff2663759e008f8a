//! Lexical analysis: splits a program into words, numbers, strings and signs, without its comments.

use crate::Language;

/// A word, a number, a string literal or a sign of a program.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Token<'a> {
    /// The token as it is written.
    pub(crate) text: &'a str,
    /// The kind of the token.
    pub(crate) kind: TokenKind,
    /// The byte of the program at which the token begins.
    pub(crate) at: usize,
    /// True if the token is the first of its line.
    pub(crate) is_first: bool,
}

/// The kinds of tokens.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TokenKind {
    /// A name or a keyword.
    Word,
    /// A number with its point, exponent and suffix.
    Number,
    /// A string or character literal with its quotes.
    Text,
    /// An operator or a bracket.
    Sign,
}

/// The signs of more than one character, longer ones first.
const SIGNS: [&str; 34] = [
    "...", "..=", "..<", "===", "!==", "<<=", ">>=", "->", "=>", "::", ":=", "**", "//", "&&",
    "||", "<=", ">=", "==", "!=", "<<", ">>", "+=", "-=", "*=", "/=", "++", "--", "..", "?:", "?.",
    "!!", "??", "|=", "&=",
];

/// Splits a text into tokens.
pub(crate) fn tokens(text: &str, language: Language) -> Vec<Token<'_>> {
    let mut all = Vec::new();
    let (mut at, mut is_first) = (0, true);
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        let length = skipped(rest, language, is_first);
        if length > 0 {
            is_first |= rest[..length].contains('\n');
            at += length;
            continue;
        }
        let (kind, length) = token(rest, first, language);
        all.push(Token {
            text: &rest[..length],
            kind,
            at,
            is_first,
        });
        (at, is_first) = (at + length, false);
    }
    all
}

/// Returns the bytes of the blank, comment or preprocessor line at the start of a text, or 0.
fn skipped(rest: &str, language: Language, is_first: bool) -> usize {
    let line = || rest.find('\n').unwrap_or(rest.len());
    let is_python = language == Language::Python;
    if rest.starts_with(|c: char| c.is_whitespace() || c == '\u{feff}') {
        rest.chars().next().map_or(0, char::len_utf8)
    } else if rest.starts_with('#') && (is_python || is_first)
        || rest.starts_with("//") && !is_python
    {
        line()
    } else if rest.starts_with("/*") && !is_python {
        rest.find("*/").map_or(rest.len(), |end| end + 2)
    } else if rest.starts_with("\\\n") {
        2
    } else {
        0
    }
}

/// Returns the kind and the bytes of the token at the start of a text.
fn token(rest: &str, first: char, language: Language) -> (TokenKind, usize) {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let end = |is: &dyn Fn(char) -> bool| rest.find(|c| !is(c)).unwrap_or(rest.len());
    let next = rest.chars().nth(1).unwrap_or_default();
    match first {
        '0'..='9' => (TokenKind::Number, number(rest)),
        '.' if next.is_ascii_digit() => (TokenKind::Number, 1 + number(&rest[1..])),
        c if is_word(c) || c == '$' => (TokenKind::Word, end(&|c| is_word(c) || c == '$')),
        '"' | '`' => (TokenKind::Text, quoted(rest, first)),
        // In Rust a lifetime has no second quote.
        '\'' if language != Language::Rust || rest.chars().nth(2) == Some('\'') || next == '\\' => {
            (TokenKind::Text, quoted(rest, first))
        }
        c => {
            let mut signs = SIGNS.iter();
            let sign = signs.find(|it| rest.starts_with(**it));
            (TokenKind::Sign, sign.map_or(c.len_utf8(), |it| it.len()))
        }
    }
}

/// Returns the bytes of a number with its point, its exponent and the suffix of its type.
fn number(rest: &str) -> usize {
    let letters = rest.as_bytes();
    let is = |at: usize, is: fn(&u8) -> bool| letters.get(at).is_some_and(is);
    let mut at = 0;
    let mut has_point = false;
    while let Some(letter) = letters.get(at) {
        let is_exponent =
            matches!(letter, b'+' | b'-') && matches!(letters[at.max(1) - 1], b'e' | b'E');
        match letter {
            b'.' if !has_point => {
                // Two points are a range, and a name after one is a method.
                let is_word = |it: &u8| it.is_ascii_alphabetic() || *it == b'.' || *it == b'_';
                let is_suffix = |it: &u8| matches!(it, b'f' | b'F' | b'd' | b'L');
                let ends = !is(at + 2, |it| it.is_ascii_alphanumeric() || *it == b'_');
                if is(at + 1, is_word) && !(is(at + 1, is_suffix) && ends) {
                    break;
                }
                has_point = true;
            }
            it if it.is_ascii_alphanumeric() || *it == b'_' || is_exponent => {}
            _ => break,
        }
        at += 1;
    }
    at
}

/// Returns the bytes of a string literal with its quotes, one or three at each end.
fn quoted(rest: &str, quote: char) -> usize {
    let three = quote.to_string().repeat(3);
    if let Some(inner) = rest.strip_prefix(&three) {
        return inner.find(&three).map_or(rest.len(), |end| end + 6);
    }
    let mut is_escaped = false;
    let end = rest.char_indices().skip(1).find(|(_, c)| {
        let is_end = *c == quote && !is_escaped;
        is_escaped = *c == '\\' && !is_escaped;
        is_end
    });
    end.map_or(rest.len(), |(at, _)| at + 1)
}
