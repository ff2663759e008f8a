//! Tokens of a text that need not be Rust: names, numbers and signs.

/// Signs of two letters.
const PAIRS: [&str; 15] = [
    "->", "=>", "==", "!=", "<=", ">=", "&&", "||", "::", "..", "+=", "-=", "*=", "/=", "//",
];

/// Returns the names, numbers and signs of a text, without its comments, each with the byte where
/// it begins.
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

fn is_word(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_'
}

/// Returns how long the number is with which the text begins.
fn number(text: &str) -> usize {
    let digits = |text: &str| text.find(|it| !is_word(it)).unwrap_or(text.len());
    let whole = digits(text);
    match text[whole..].strip_prefix('.') {
        Some(rest) if rest.starts_with(|it: char| it.is_ascii_digit()) => whole + 1 + digits(rest),
        _ => whole,
    }
}
