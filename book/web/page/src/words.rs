//! A lexer for text that need not be Rust: it splits a line into names, numbers and signs.

/// Signs of two characters.
const PAIRS: [&str; 15] = [
    "->", "=>", "==", "!=", "<=", ">=", "&&", "||", "::", "..", "+=", "-=", "*=", "/=", "//",
];

/// Splits a text into names, numbers and signs, each with the byte at which it begins. Blanks and
/// `//` comments are left out.
pub(crate) fn words(text: &str) -> Vec<(usize, &str)> {
    let mut words = Vec::new();
    let mut at = 0;
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        if rest.starts_with("//") {
            at += rest.find('\n').unwrap_or(rest.len());
            continue;
        }
        let pair = PAIRS.iter().find(|pair| rest.starts_with(**pair));
        let length = match pair {
            Some(pair) => pair.len(),
            None if first.is_ascii_digit() => number(rest),
            None if is_word(first) => rest.find(|it| !is_word(it)).unwrap_or(rest.len()),
            None => first.len_utf8(),
        };
        if !first.is_whitespace() {
            words.push((at, &rest[..length]));
        }
        at += length;
    }
    words
}

/// Returns the text with other words in the place of those for which `instead`, asked with the text
/// before a word and with the word, has some.
pub(crate) fn replaced<'a>(
    text: &'a str,
    instead: impl Fn(&str, &'a str) -> Option<&'a str>,
) -> String {
    let (mut made, mut end) = (String::new(), 0);
    for (at, word) in words(text) {
        made += &text[end..at];
        made += instead(&text[..at], word).unwrap_or(word);
        end = at + word.len();
    }
    made + &text[end..]
}

/// Returns true for a letter, a digit or `_`.
fn is_word(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_'
}

/// Returns the length in bytes of the number with which the text begins.
fn number(text: &str) -> usize {
    let digits = |text: &str| text.find(|it| !is_word(it)).unwrap_or(text.len());
    let whole = digits(text);
    match text[whole..].strip_prefix('.') {
        Some(rest) if rest.starts_with(|it: char| it.is_ascii_digit()) => whole + 1 + digits(rest),
        _ => whole,
    }
}
