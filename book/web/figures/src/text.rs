//! Markup of labels and sentences: `*t*` marks a number, `**P**` a vector, and `_{0}` a subscript.

/// The size of letters in a label, in units of the viewBox.
pub(crate) const TEXT: f64 = 14.0;

/// The size of letters in a less important label, in units of the viewBox.
pub(crate) const SMALL: f64 = 12.0;

/// The size of letters in a subscript, in units of the viewBox.
const SUBSCRIPT: f64 = 11.0;

/// Returns the text without the marks of numbers and vectors.
pub(crate) fn plain(text: &str) -> String {
    text.replace('*', "")
}

/// Returns a plain text with marks as HTML: `*t*`, a number, in italics, and `**P**`, a vector,
/// bold. The rest is escaped as by [`escape`].
pub fn html(text: &str) -> String {
    marked(text, ["<i>", "</i>"], ["<b>", "</b>"])
}

/// Returns the text of a label as SVG.
pub(crate) fn spans(label: &str) -> String {
    let mut spans = String::new();
    for (n, piece) in label.split(['{', '}']).enumerate() {
        let [italic, vector] = ["italic", "vector"].map(|it| format!("<tspan class=\"{it}\">"));
        let piece = piece.trim_end_matches('_');
        let piece = marked(piece, [&italic, "</tspan>"], [&vector, "</tspan>"]);
        spans += &match n {
            _ if n == 0 || piece.is_empty() => piece,
            _ if n % 2 == 0 => format!("<tspan dy=\"-4\">{piece}</tspan>"),
            _ => format!("<tspan dy=\"4\" font-size=\"{SUBSCRIPT}\">{piece}</tspan>"),
        };
    }
    spans
}

/// Puts the tags `number` around each number of the text, and the tags `vector` around each vector.
fn marked(text: &str, number: [&str; 2], vector: [&str; 2]) -> String {
    let within = |text: String, n: usize, [open, close]: [&str; 2]| match n % 2 {
        0 => text,
        _ => format!("{open}{text}{close}"),
    };
    let numbers = |text: &str| -> String {
        let pieces = text.split('*').enumerate();
        pieces
            .map(|(n, piece)| within(escape(piece), n, number))
            .collect()
    };
    let pieces = text.split("**").enumerate();
    pieces
        .map(|(n, piece)| within(numbers(piece), n, vector))
        .collect()
}

/// Estimates the width of a label from above, in units of the viewBox, for the usual fonts and
/// letters of this `size`.
pub(crate) fn width(label: &str, size: f64) -> f64 {
    let advance = |letter: char| match letter {
        '*' => 0.0,
        'i' | 'j' | 'l' | ' ' | ',' | '.' | ':' => 0.36,
        'f' | 't' | 'r' | '(' | ')' | '-' => 0.44,
        'm' | 'w' | 'M' | 'W' | '−' | '<' | '>' | '=' | '%' | '÷' => 0.96,
        'A'..='Z' => 0.76,
        _ => 0.65,
    };
    size * label.chars().map(advance).sum::<f64>()
}

/// Replaces `&`, `<`, `>` and `"` by their entities, so that `text` can stand in XML and HTML.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}
